#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QStringList>
#include <span>
#include <vector>

#include "core/analysis/run_sources.h"
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

/// Where an annotation is in a picture, in pixels from its upper left corner.
struct PlacedAnnotation {
  int id = 0;
  AnnotationKind kind = AnnotationKind::text;
  QPointF anchor;     ///< its place
  QPointF other;      ///< of two places the other one
  QPolygonF stretch;  ///< of a region: the path between them
  QPointF middle;     ///< what the label belongs to and its offset counts from
  QRectF label;       ///< moved to where all of it is in the picture
  QStringList lines;
  QColor colour;
  double text_pixels = 0;
};

/// Those whose places are in the picture, in order. A label that nobody has put where it is goes beside the
/// path; no label covers another one or a text of the scene, and no line from a label to its place crosses
/// one, where there is room for that. Costs time in the number of annotations alone.
std::vector<PlacedAnnotation> place_annotations(std::span<const Annotation> annotations,
                                                const AnnotatedView& view);
/// What all of them say, those out of the picture too.
QStringList annotation_texts(std::span<const Annotation> annotations, const AnnotatedView& view);

/// Inside the part of the picture that the path has. `selected`: id of the one that is marked; 0 for none.
void draw_annotations(QPainter& painter, std::span<const PlacedAnnotation> annotations,
                      const AnnotatedView& view, int selected = 0);

}  // namespace feedscope::ui
