#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QStringList>
#include <span>
#include <vector>

#include "core/analysis/run/run_sources.h"
#include "ui/scene/path_scene.h"
#include "ui/workbench/annotation.h"

class QPainter;

namespace feedscope::ui {

/// The 3D view that annotations are drawn over.
struct AnnotatedView {
  const PathScene& scene;  ///< attached, with the camera of the picture
  const Trajectory& trajectory;
  QSizeF size;       ///< [pixels of the scene]
  double scale = 1;  ///< of text and lines, as PathScene::set_scale()
  Background background = Background::light;
  QString run;         ///< name of the run
  RunSources sources;  ///< of the run
};

/// Place of an annotation in a picture, in pixels from its upper left corner.
struct PlacedAnnotation {
  int id = 0;
  AnnotationKind kind = AnnotationKind::text;
  QPointF anchor;     ///< the annotated place
  QPointF other;      ///< the second of two places
  QPolygonF stretch;  ///< of a region: the path between them
  QPointF middle;     ///< reference point of the label and its offset
  QRectF label;       ///< moved fully into the picture
  QStringList lines;
  QColor colour;
  double text_pixels = 0;
};

/// The annotations whose places are in the picture, in order. A label that nobody has placed goes next to the
/// path. If there is room, no label covers another one or a text of the scene, and no line from a label to
/// its place crosses one. The cost depends on the number of annotations alone.
std::vector<PlacedAnnotation> place_annotations(std::span<const Annotation> annotations,
                                                const AnnotatedView& view);
/// Texts of all annotations, including those out of the picture.
QStringList annotation_texts(std::span<const Annotation> annotations, const AnnotatedView& view);

/// Draws within the path's part of the picture. `selected`: id of the highlighted one; 0 for none.
void draw_annotations(QPainter& painter, std::span<const PlacedAnnotation> annotations,
                      const AnnotatedView& view, int selected = 0);

}  // namespace feedscope::ui
