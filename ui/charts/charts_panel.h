#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>

#include "core/machine/machine.h"
#include "ui/charts/chart_header.h"
#include "ui/charts/kinematic_chart.h"
#include "ui/models/cursor.h"

class QComboBox;
class QToolButton;

namespace feedscope::ui {

/// Feed, acceleration and jerk of a run, one above the other, along one abscissa.
class ChartsPanel : public QWidget {
  Q_OBJECT

 public:
  /// `cursor` outlives this; a click moves it.
  explicit ChartsPanel(Cursor& cursor, QWidget* parent = nullptr);

  /// Shows a run, or nothing if `trajectory` is null. `keep_range`: stay at the stretch that is shown.
  void set_run(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const Envelope> envelope,
               bool keep_range);
  void set_limits(const std::array<AxisLimits, 3>& limits);
  /// For pictures, where nothing can be pressed.
  void hide_controls();
  ViewRange& range() { return range_; }
  /// 0 feed, 1 acceleration, 2 jerk.
  KinematicChart& chart(std::size_t i) { return *charts_[i]; }
  /// Brings the curves up to date now, not with the next turn of the event loop.
  void refresh();

 private:
  void show_cursor();
  void choose_abscissa(int index);

  Cursor& cursor_;
  ViewRange range_;
  std::shared_ptr<const Envelope> envelope_;
  std::array<ChartHeader*, 3> headers_{};
  std::array<KinematicChart*, 3> charts_{};
  QComboBox* abscissa_;
  QToolButton* show_all_;
  QTimer refresh_;
};

}  // namespace feedscope::ui
