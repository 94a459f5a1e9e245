#include "ui/annotations/annotation_overlay.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

namespace feedscope::ui {

namespace {

constexpr double grip_radius = 7;  // [pixels of scale 1]

}  // namespace

AnnotationOverlay::AnnotationOverlay(QWidget& canvas, PathScene& scene)
    : QWidget(&canvas), scene_(scene), canvas_(canvas) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  resize(canvas.size());
  canvas.installEventFilter(this);
}

void AnnotationOverlay::set_annotations(AnnotationList* annotations) {
  annotations_ = annotations;
  if (annotations != nullptr) {
    connect(annotations, &AnnotationList::changed, this, qOverload<>(&QWidget::update));
    connect(annotations, &AnnotationList::selection_changed, this, qOverload<>(&QWidget::update));
  }
  update();
}

void AnnotationOverlay::set_run(std::shared_ptr<const Trajectory> trajectory, const QString& name,
                                const RunSources& sources) {
  trajectory_ = std::move(trajectory);
  sources_ = sources;
  run_ = name;
  update();
  emit run_changed();
}

void AnnotationOverlay::set_scale(double scale) {
  scale_ = scale;
  update();
}

void AnnotationOverlay::set_background(Background background) {
  background_ = background;
  update();
}

std::optional<AnnotatedView> AnnotationOverlay::view() const {
  if (annotations_ == nullptr || annotations_->items().empty() || trajectory_ == nullptr) {
    return std::nullopt;
  }
  return AnnotatedView{scene_, *trajectory_, QSizeF(size()) * devicePixelRatioF(), scale_, background_,
                       run_,   sources_};
}

std::vector<PlacedAnnotation> AnnotationOverlay::placed() const {
  const auto shown = view();
  return shown ? place_annotations(annotations_->items(), *shown) : std::vector<PlacedAnnotation>();
}

QString AnnotationOverlay::text_of(const Annotation& annotation) const {
  const auto shown = view();
  return shown && !shown->trajectory.pieces().empty() ? annotation_texts({&annotation, 1}, *shown).front()
                                                      : annotation.text;
}

void AnnotationOverlay::paintEvent(QPaintEvent*) {
  if (const auto shown = view()) {
    QPainter painter(this);
    painter.scale(1 / devicePixelRatioF(), 1 / devicePixelRatioF());
    draw_annotations(painter, place_annotations(annotations_->items(), *shown), *shown,
                     annotations_->selected());
  }
}

bool AnnotationOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &canvas_ && event->type() == QEvent::Resize) {
    resize(canvas_.size());
  }
  return QWidget::eventFilter(watched, event);
}

QPointF AnnotationOverlay::pixel_of(const QMouseEvent& mouse) const {
  return mouse.position() * devicePixelRatioF();
}

std::optional<AnnotationOverlay::Held> AnnotationOverlay::grip_at(const QPointF& pixel) const {
  const auto near = [&](const QPointF& dot) { return QLineF(dot, pixel).length() <= grip_radius * scale_; };
  std::vector<PlacedAnnotation> all = placed();
  std::ranges::reverse(all);  // the last one drawn is on top
  for (const PlacedAnnotation& placed : all) {
    if (placed.id == annotations_->selected()) {
      if (near(placed.anchor)) {
        return Held{placed.id, Grip::anchor, pixel, {}};
      }
      if (has_two_places(placed.kind) && near(placed.other)) {
        return Held{placed.id, Grip::other, pixel, {}};
      }
    }
    if (placed.label.contains(pixel)) {
      // The label may have been moved into the picture: dragging continues from its visible place.
      return Held{placed.id, Grip::label, pixel, (placed.label.center() - placed.middle) / scale_};
    }
  }
  return std::nullopt;
}

bool AnnotationOverlay::take(const QEvent& event) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(event));
    case QEvent::MouseMove:
      if (held_) {
        move(pixel_of(static_cast<const QMouseEvent&>(event)));
      }
      return held_.has_value();
    case QEvent::MouseButtonRelease:
      if (held_ && annotations_ != nullptr) {
        annotations_->end_step();
      }
      return std::exchange(held_, std::nullopt).has_value();
    case QEvent::MouseButtonDblClick: {
      const auto grip = grip_at(pixel_of(static_cast<const QMouseEvent&>(event)));
      if (grip) {
        emit edit_wanted(grip->id);
      }
      return grip.has_value();
    }
    case QEvent::KeyPress: {
      const int selected = annotations_ == nullptr ? 0 : annotations_->selected();
      if (selected == 0 || static_cast<const QKeyEvent&>(event).key() != Qt::Key_Delete) {
        return false;
      }
      annotations_->remove(selected);
      return true;
    }
    default:
      return false;
  }
}

bool AnnotationOverlay::press(const QMouseEvent& mouse) {
  if (mouse.button() != Qt::LeftButton || mouse.modifiers() != Qt::NoModifier || annotations_ == nullptr) {
    return false;
  }
  held_ = grip_at(pixel_of(mouse));
  annotations_->select(held_ ? held_->id : 0);
  return held_.has_value();
}

void AnnotationOverlay::move(const QPointF& pixel) {
  const Annotation* annotation = annotations_ == nullptr ? nullptr : annotations_->find(held_->id);
  if (annotation == nullptr) {
    held_.reset();
    return;
  }
  Annotation moved = *annotation;
  if (held_->grip == Grip::label) {
    moved.offset = held_->offset + (pixel - held_->from) / scale_;
    moved.view = QSizeF(size()) * devicePixelRatioF() / scale_;
  } else {
    constexpr double reach = 60;  // [pixels of scale 1]
    const auto time = scene_.pick_time({pixel.x(), pixel.y()}, reach);
    if (!time) {
      return;
    }
    (held_->grip == Grip::anchor ? moved.place : moved.until) = programmed_place(*trajectory_, *time);
  }
  annotations_->change(moved, tr("move annotation"));
}

}  // namespace feedscope::ui
