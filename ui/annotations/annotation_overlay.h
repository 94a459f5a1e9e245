#pragma once

#include <QPointer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/annotations/annotation_picture.h"
#include "ui/workbench/annotation_list.h"

class QKeyEvent;
class QMouseEvent;

namespace feedscope::ui {

/// The annotations drawn over a 3D view, transparent to the mouse: the receiver of the view's events offers
/// them to take(). Dragging moves a label; dragging a dot moves the place of the selected annotation along
/// the path.
class AnnotationOverlay : public QWidget {
  Q_OBJECT

 public:
  /// `canvas` shows `scene`, which outlives this.
  AnnotationOverlay(QWidget& canvas, PathScene& scene);

  /// Null for none.
  void set_annotations(AnnotationList* annotations);
  /// The run whose values the labels show, and its name.
  void set_run(std::shared_ptr<const Trajectory> trajectory, const QString& name,
               const RunSources& sources = {});
  const std::shared_ptr<const Trajectory>& trajectory() const { return trajectory_; }
  const QString& run_name() const { return run_; }
  /// Size of text and lines, as of the scene.
  void set_scale(double scale);
  void set_background(Background background);

  /// Handles a mouse or key event of the canvas; false: it does not concern an annotation.
  bool take(const QEvent& event);
  /// Current places of the annotations, in device pixels.
  std::vector<PlacedAnnotation> placed() const;
  /// The text of an annotation with the values of the run, on one or more lines; without a run, the text as
  /// written.
  QString text_of(const Annotation& annotation) const;

 signals:
  /// The values now belong to another run.
  void run_changed();
  /// A double click: the user wants to change the text.
  void edit_wanted(int id);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Grip { label, anchor, other };
  struct Held {
    int id = 0;
    Grip grip = Grip::label;
    QPointF from;    ///< of the mouse at the start [device pixels]
    QPointF offset;  ///< of the label at the start
  };

  std::optional<AnnotatedView> view() const;
  std::optional<Held> grip_at(const QPointF& pixel) const;
  QPointF pixel_of(const QMouseEvent& mouse) const;
  bool press(const QMouseEvent& mouse);
  void move(const QPointF& pixel);

  PathScene& scene_;
  QWidget& canvas_;
  QPointer<AnnotationList> annotations_;
  std::shared_ptr<const Trajectory> trajectory_;
  RunSources sources_;
  QString run_;
  double scale_ = 1;
  Background background_ = Background::light;
  std::optional<Held> held_;
};

}  // namespace feedscope::ui
