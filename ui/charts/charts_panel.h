#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>

#include "core/machine/machine.h"
#include "ui/charts/cause_strip.h"
#include "ui/charts/chart_header.h"
#include "ui/charts/kinematic_chart.h"
#include "ui/models/cursor.h"

class QComboBox;
class QLayout;
class QToolButton;

namespace feedscope::ui {

/// Feed with what limits it, acceleration and jerk of a run, one above the other, along one abscissa.
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
  ChartHeader& header(std::size_t i) { return *headers_[i]; }
  CauseStrip& causes() { return *causes_; }
  void show_curve(std::size_t chart, std::size_t curve, bool shown);
  /// Brings the curves up to date now, not with the next turn of the event loop.
  void refresh();

 private:
  QLayout* add_header(std::size_t i, const ChartSpec& spec);
  void show_alone(std::size_t chart, std::size_t curve);
  void show_cursor();
  void fit();
  void choose_abscissa(int index);

  Cursor& cursor_;
  ViewRange range_;
  std::shared_ptr<const Envelope> envelope_;
  CauseStrip* causes_;
  std::array<ChartHeader*, chart_count> headers_{};
  std::array<KinematicChart*, chart_count> charts_{};
  QComboBox* abscissa_;
  QToolButton* show_all_;
  QTimer refresh_;
};

}  // namespace feedscope::ui
