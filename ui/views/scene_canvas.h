#pragma once

#include <QImage>
#include <QOpenGLWidget>
#include <QWidget>

class QMouseEvent;
class QWheelEvent;
class vtkGenericOpenGLRenderWindow;
class vtkRenderWindowInteractor;

namespace feedscope::ui {

/// Passes a mouse or wheel event of `widget` on to VTK's interactor. False for other events.
bool pass_to_interactor(QEvent& event, const QWidget& widget, vtkRenderWindowInteractor& interactor);

/// Shows a VTK window that draws with this widget's OpenGL context.
class GpuCanvas : public QOpenGLWidget {
 public:
  GpuCanvas(vtkGenericOpenGLRenderWindow& window, vtkRenderWindowInteractor& interactor, QWidget* parent);
  ~GpuCanvas() override;

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  bool event(QEvent* event) override;

 private:
  void release();

  vtkGenericOpenGLRenderWindow& window_;
  vtkRenderWindowInteractor& interactor_;
};

/// Shows the image of a VTK window that draws in software.
class SoftwareCanvas : public QWidget {
 public:
  SoftwareCanvas(vtkGenericOpenGLRenderWindow& window, vtkRenderWindowInteractor& interactor,
                 QWidget* parent);

  /// The next paint draws the scene again instead of showing the last image.
  void request_frame();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QSize pixel_size() const;

  vtkGenericOpenGLRenderWindow& window_;
  vtkRenderWindowInteractor& interactor_;
  QImage image_;  ///< null: draw again
};

}  // namespace feedscope::ui
