#pragma once

#include <QImage>
#include <QOpenGLWidget>
#include <QWidget>

class vtkGenericOpenGLRenderWindow;

namespace feedscope::ui {

/// Shows a VTK window that draws with this widget's OpenGL context.
class GpuCanvas : public QOpenGLWidget {
 public:
  GpuCanvas(vtkGenericOpenGLRenderWindow& window, QWidget* parent);
  ~GpuCanvas() override;

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

 private:
  void release();
  bool is_current() const;

  vtkGenericOpenGLRenderWindow& window_;
  unsigned long make_current_ = 0;  ///< observer of the window
  unsigned long ask_current_ = 0;
};

/// Shows the image of a VTK window that draws in software.
class SoftwareCanvas : public QWidget {
 public:
  SoftwareCanvas(vtkGenericOpenGLRenderWindow& window, QWidget* parent);

  /// Makes the next paint draw the scene again instead of showing the last image.
  void request_frame();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QSize pixel_size() const;

  vtkGenericOpenGLRenderWindow& window_;
  QImage image_;
  bool drawn_ = false;  ///< image_ is the scene as it is
};

}  // namespace feedscope::ui
