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

/// Mouse and wheel on a chart, as described at KinematicChart: zooms and pans the shared range, chooses the
/// shown values, and makes the chart request cursors, the menu and the whole run.
class ChartInput : public QObject {
 public:
  /// Both outlive this.
  ChartInput(KinematicChart& chart, ViewRange& range);

  /// The part of the plot that the drawn box will show [px]; none without a box.
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
