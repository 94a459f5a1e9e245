#include "ui/charts/chart_input.h"

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/charts/kinematic_chart.h"

namespace feedscope::ui {

namespace {

constexpr double zoom_a_notch = 0.8;
constexpr double pan_a_notch = 0.1;  // of the shown range
constexpr double flat_box = 16;      // [px] below this height a box does not change the values
constexpr double narrow_box = 5;     // [px] below this width it does not change the abscissa

/// Wheel notches; with Alt some platforms turn the wheel sideways.
double notches_of(const QWheelEvent& event) {
  const QPoint turned = event.angleDelta();
  return (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
}

}  // namespace

ChartInput::ChartInput(KinematicChart& chart, ViewRange& range)
    : QObject(&chart), chart_(chart), range_(range) {
  chart.installEventFilter(this);
}

bool ChartInput::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Wheel:
      turn_wheel(*static_cast<QWheelEvent*>(event));
      break;
    case QEvent::MouseButtonPress:
      press(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseMove:
      move(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonRelease:
      release(*static_cast<QMouseEvent*>(event));
      break;
    case QEvent::MouseButtonDblClick:
      double_click(*static_cast<QMouseEvent*>(event));
      break;
    default:
      return QObject::eventFilter(watched, event);
  }
  event->accept();
  return true;
}

void ChartInput::turn_wheel(QWheelEvent& event) {
  const double notches = notches_of(event);
  if (event.modifiers().testFlag(Qt::ControlModifier)) {
    const double pivot = chart_.value_at(event.position().y());
    const double factor = std::pow(zoom_a_notch, notches);
    const Interval& values = chart_.values();
    chart_.choose_values(
        Interval{pivot + (values.lower - pivot) * factor, pivot + (values.upper - pivot) * factor});
  } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
    range_.pan(-pan_a_notch * notches * (range_.upper() - range_.lower()));
  } else {
    range_.zoom(std::pow(zoom_a_notch, notches), chart_.position_at(event.position().x()));
  }
}

void ChartInput::press(const QMouseEvent& event) {
  if (event.button() == Qt::LeftButton || event.button() == Qt::RightButton) {
    pressed_at_ = event.position();
    dragged_to_ = event.position();
    drag_ = Drag::undecided;
  }
}

void ChartInput::begin_drag(const QMouseEvent& event) {
  if (event.buttons().testFlag(Qt::RightButton) || event.modifiers().testFlag(Qt::ControlModifier)) {
    drag_ = Drag::box;
  } else {
    drag_ = event.modifiers().testFlag(Qt::ShiftModifier) ? Drag::second_cursor : Drag::pan;
  }
}

void ChartInput::move(const QMouseEvent& event) {
  if (drag_ == Drag::undecided &&
      (event.position() - pressed_at_).manhattanLength() >= QApplication::startDragDistance()) {
    begin_drag(event);
  }
  if (drag_ == Drag::pan) {
    range_.pan(chart_.position_at(dragged_to_.x()) - chart_.position_at(event.position().x()));
  } else if (drag_ == Drag::second_cursor) {
    emit chart_.second_position_clicked(chart_.position_at(event.position().x()));
  } else if (drag_ == Drag::box) {
    chart_.update();
  }
  dragged_to_ = event.position();
}

void ChartInput::release(const QMouseEvent& event) {
  const Drag drag = std::exchange(drag_, Drag::none);
  if (drag == Drag::box) {
    dragged_to_ = event.position();
    zoom_to(drawn_box());
    chart_.update();
  } else if (drag == Drag::undecided && event.button() == Qt::RightButton) {
    emit chart_.menu_requested(event.globalPosition().toPoint());
  } else if (drag == Drag::undecided && event.modifiers().testFlag(Qt::ShiftModifier)) {
    emit chart_.second_position_clicked(chart_.position_at(event.position().x()));
  } else if (drag == Drag::undecided) {
    emit chart_.position_clicked(chart_.position_at(event.position().x()));
  }
}

void ChartInput::double_click(const QMouseEvent& event) {
  drag_ = Drag::none;  // the following release is not a click
  if (event.position().x() < chart_.plot().left()) {
    chart_.choose_values({});
  } else {
    emit chart_.fit_requested();
  }
}

std::optional<QRectF> ChartInput::box() const {
  return drag_ == Drag::box ? std::optional(drawn_box()) : std::nullopt;
}

QRectF ChartInput::drawn_box() const {
  const QRectF plot = chart_.plot();
  const auto inside = [&](const QPointF& point) {
    return QPointF(std::clamp(point.x(), plot.left(), plot.right()),
                   std::clamp(point.y(), plot.top(), plot.bottom()));
  };
  QRectF box = QRectF(inside(pressed_at_), inside(dragged_to_)).normalized();
  if (box.height() < flat_box) {
    box.setTop(plot.top());
    box.setBottom(plot.bottom());
  }
  if (box.width() < narrow_box) {
    box.setLeft(plot.left());
    box.setRight(plot.right());
  }
  return box;
}

void ChartInput::zoom_to(const QRectF& box) {
  const QRectF plot = chart_.plot();
  if (box.height() < plot.height()) {
    chart_.choose_values(Interval{chart_.value_at(box.bottom()), chart_.value_at(box.top())});
  }
  if (box.width() < plot.width()) {
    range_.show(chart_.position_at(box.left()), chart_.position_at(box.right()));
  }
}

}  // namespace feedscope::ui
