// What mouse and keyboard do to a chart.
#include <QApplication>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "ui/charts/kinematic_chart.h"

namespace feedscope::ui {

namespace {

constexpr double zoom_a_notch = 0.8;
constexpr double pan_a_notch = 0.1;  // of what is shown
constexpr double flat_box = 16;      // [px] below which a box leaves the values as they are
constexpr double narrow_box = 5;     // [px] below which it leaves the abscissa as it is

/// With Alt some platforms turn the wheel sideways.
double notches_of(const QWheelEvent& event) {
  const QPoint turned = event.angleDelta();
  return (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
}

}  // namespace

bool KinematicChart::event(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    apply_colours();
  }
  return QChartView::event(event);
}

void KinematicChart::wheelEvent(QWheelEvent* event) {
  const double notches = notches_of(*event);
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    const double pivot = value_at(event->position().y());
    const double factor = std::pow(zoom_a_notch, notches);
    choose_values(
        Interval{pivot + (values_.lower - pivot) * factor, pivot + (values_.upper - pivot) * factor});
  } else if (event->modifiers().testFlag(Qt::ShiftModifier)) {
    range_.pan(-pan_a_notch * notches * (range_.upper() - range_.lower()));
  } else {
    range_.zoom(std::pow(zoom_a_notch, notches), position_at(event->position().x()));
  }
  event->accept();
}

void KinematicChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton || event->button() == Qt::RightButton) {
    pressed_at_ = event->position();
    dragged_to_ = event->position();
    drag_ = Drag::undecided;
  }
}

void KinematicChart::begin_drag(const QMouseEvent& event) {
  if (event.buttons().testFlag(Qt::RightButton) || event.modifiers().testFlag(Qt::ControlModifier)) {
    drag_ = Drag::box;
  } else {
    drag_ = event.modifiers().testFlag(Qt::ShiftModifier) ? Drag::second_cursor : Drag::pan;
  }
}

void KinematicChart::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ == Drag::undecided &&
      (event->position() - pressed_at_).manhattanLength() >= QApplication::startDragDistance()) {
    begin_drag(*event);
  }
  if (drag_ == Drag::pan) {
    range_.pan(position_at(dragged_to_.x()) - position_at(event->position().x()));
  } else if (drag_ == Drag::second_cursor) {
    emit second_position_clicked(position_at(event->position().x()));
  } else if (drag_ == Drag::box) {
    viewport()->update();
  }
  dragged_to_ = event->position();
}

void KinematicChart::mouseReleaseEvent(QMouseEvent* event) {
  const Drag drag = std::exchange(drag_, Drag::none);
  if (drag == Drag::box) {
    dragged_to_ = event->position();
    zoom_to(box());
    viewport()->update();
  } else if (drag == Drag::undecided && event->button() == Qt::RightButton) {
    emit menu_requested(event->globalPosition().toPoint());
  } else if (drag == Drag::undecided && event->modifiers().testFlag(Qt::ShiftModifier)) {
    emit second_position_clicked(position_at(event->position().x()));
  } else if (drag == Drag::undecided) {
    emit position_clicked(position_at(event->position().x()));
  }
}

void KinematicChart::mouseDoubleClickEvent(QMouseEvent* event) {
  drag_ = Drag::none;  // the release that follows is no click
  if (event->position().x() < chart()->plotArea().left()) {
    choose_values({});
  } else {
    emit fit_requested();
  }
}

void KinematicChart::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse) {
    event->accept();  // the release of the button decides between box and menu
  } else {
    emit menu_requested(mapToGlobal(chart()->plotArea().center().toPoint()));
  }
}

QRectF KinematicChart::box() const {
  const QRectF plot = chart()->plotArea();
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

void KinematicChart::zoom_to(const QRectF& box) {
  const QRectF plot = chart()->plotArea();
  if (box.height() < plot.height()) {
    choose_values(Interval{value_at(box.bottom()), value_at(box.top())});
  }
  if (box.width() < plot.width()) {
    range_.show(position_at(box.left()), position_at(box.right()));
  }
}

}  // namespace feedscope::ui
