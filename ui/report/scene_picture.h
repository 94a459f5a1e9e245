#pragma once

#include <vtkSmartPointer.h>

#include <QImage>
#include <QRectF>

#include "ui/annotations/annotation_picture.h"
#include "ui/report/report_input.h"

class vtkGenericOpenGLRenderWindow;

namespace feedscope::ui {

/// How large a 3D view is drawn.
struct SceneScale {
  double pixel_ratio = 1;  ///< pixels to a unit of the painter
  double text_scale = 1;   ///< size of text and lines, 1 for 96 units an inch
};

/// A run in 3D for pictures, drawn in software without a display.
class ScenePicture {
 public:
  /// Run `row` of `input`, which outlives this, with the look that the input has. Throws what
  /// make_render_window() throws.
  ScenePicture(const ReportInput& input, std::size_t row, ThemeKind theme, bool transparent = false);
  ~ScenePicture();
  ScenePicture(const ScenePicture&) = delete;
  ScenePicture& operator=(const ScenePicture&) = delete;

  PathScene& scene() { return scene_; }
  /// Gives the scene its window's size, so that what is fitted now fits the picture. Throws as image().
  void prepare(const QSizeF& size, const SceneScale& scale);
  /// The scene as it is now. Throws InputError if a side is too long for software OpenGL.
  QImage image(const QSizeF& size, const SceneScale& scale);
  /// The same as part of a larger picture, the annotations above it. In devices of shapes (SVG, PDF) all of
  /// it is vectors; where there are too many lines for that (see paint_vectors), the scene is a bitmap.
  void paint(QPainter& painter, const QRectF& place, const SceneScale& scale);
  /// Where the annotations are in such a picture, as it was prepared.
  std::vector<PlacedAnnotation> annotations(const QSizeF& size, const SceneScale& scale) const;
  /// What the annotations say.
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
