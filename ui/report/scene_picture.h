#pragma once

#include <vtkSmartPointer.h>

#include <QImage>
#include <QRectF>

#include "ui/annotations/annotation_picture.h"
#include "ui/report/report_input.h"

class vtkGenericOpenGLRenderWindow;

namespace feedscope::ui {

/// Scale of a 3D view.
struct SceneScale {
  double pixel_ratio = 1;  ///< pixels per unit of the painter
  double text_scale = 1;   ///< size of text and lines, 1 for 96 units per inch
};

/// While one exists, opaque pictures that a thread draws one after the other share a window: Mesa compiles
/// its shaders and touches its buffers for the first time once. The window ends with the last of these.
class SharedPictureWindow {
 public:
  SharedPictureWindow();
  ~SharedPictureWindow();
  SharedPictureWindow(const SharedPictureWindow&) = delete;
  SharedPictureWindow& operator=(const SharedPictureWindow&) = delete;
};

/// A run in 3D for pictures, drawn in software without a display.
class ScenePicture {
 public:
  /// Run `row` of `input`, which outlives this, in the appearance of the input. Throws as
  /// make_render_window().
  ScenePicture(const ReportInput& input, std::size_t row, ThemeKind theme, bool transparent = false);
  ~ScenePicture();
  ScenePicture(const ScenePicture&) = delete;
  ScenePicture& operator=(const ScenePicture&) = delete;

  PathScene& scene() { return scene_; }
  /// Sets the size of the scene's window, so that later fits suit the picture. Throws as image().
  void prepare(const QSizeF& size, const SceneScale& scale);
  /// The current scene. Throws InputError if a side is too long for software OpenGL.
  QImage image(const QSizeF& size, const SceneScale& scale);
  /// Paints the scene into a larger picture, with the annotations on top. Devices of shapes (SVG, PDF) get
  /// vectors; with too many lines for that (see paint_vectors), the scene is a bitmap.
  void paint(QPainter& painter, const QRectF& place, const SceneScale& scale);
  /// Places of the annotations in a picture prepared like this.
  std::vector<PlacedAnnotation> annotations(const QSizeF& size, const SceneScale& scale) const;
  QStringList annotation_texts();

 private:
  std::shared_ptr<const SampledPath> samples();
  void show_stretch();
  bool paint_lines(QPainter& painter, const QRectF& place, const SceneScale& scale);
  AnnotatedView annotated(const QSizeF& size, const SceneScale& scale) const;

  PathScene scene_;
  const ReportInput& input_;
  std::size_t row_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  ThemeKind theme_;
  bool transparent_;
};

}  // namespace feedscope::ui
