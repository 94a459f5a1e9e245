#pragma once

#include <QObject>
#include <QPointF>
#include <QRectF>
#include <optional>

class QMouseEvent;
class QWheelEvent;

namespace feedscope::ui {

class KinematicChart;
class ViewRange;

/// What mouse and wheel do to a chart, as KinematicChart says: it zooms and pans the shared range, chooses
/// the values that the chart shows, and has the chart ask for cursors, the menu and all of the run.
class ChartInput : public QObject {
 public:
  /// Of the chart's viewport; both outlive it.
  ChartInput(KinematicChart& chart, ViewRange& range);

  /// The part of the plot that the box being drawn will show [px]; none: no box is being drawn.
  std::optional<QRectF> box() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { none, undecided, pan, box, second_cursor };

  void turn_wheel(QWheelEvent& event);
  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void double_click(const QMouseEvent& event);
  void begin_drag(const QMouseEvent& event);
  QRectF drawn_box() const;
  void zoom_to(const QRectF& box);

  KinematicChart& chart_;
  ViewRange& range_;
  QPointF pressed_at_;
  QPointF dragged_to_;
  Drag drag_ = Drag::none;
};

}  // namespace feedscope::ui
