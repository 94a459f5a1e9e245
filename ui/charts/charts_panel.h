#pragma once

#include <QList>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/analysis/run/run_sources.h"
#include "ui/charts/cause_strip.h"
#include "ui/charts/chart_columns.h"
#include "ui/charts/chart_commands.h"
#include "ui/charts/chart_rows.h"
#include "ui/charts/chart_scroll.h"
#include "ui/charts/charts_state.h"
#include "ui/charts/overlay_curves.h"
#include "ui/charts/usual_curves.h"
#include "ui/charts/zoom_history.h"
#include "ui/shared/cursor.h"
#include "ui/workbench/panel.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace feedscope::ui {

/// Charts of a run one above the other along one abscissa, with other runs overlaid: feed with its limiting
/// causes, acceleration, jerk and, for a machine with drives, following error.
///
/// Cursor A is the shared one. A Shift click sets cursor B, which belongs to this panel only; it adds the
/// differences between both.
class ChartsPanel : public Panel {
  Q_OBJECT

 public:
  /// Both outlive this; a click moves the cursor, the wheel the range.
  ChartsPanel(Cursor& cursor, ViewRange& range, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;

  /// Shows a run, or nothing if `trajectory` is null. `keep_range`: keep the shown stretch; after a time
  /// without a run, the next run with `keep_range` resumes it. `sources`: of the run.
  void set_run(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const Envelope> envelope,
               bool keep_range, const RunSources& sources = {});
  /// Names the run of the charts in their titles; empty: it is the only one.
  void name_run(const QString& name);
  /// Other runs of the same program, drawn under the run's curves. Over path length they are aligned by
  /// place.
  /// Recorded traces are drawn in the same way.
  void set_overlays(std::vector<RunOverlay> overlays, std::vector<TraceOverlay> traces = {});
  /// Index in the chart's spec of the curve that is shown for other runs; none: no curve. Initially the
  /// achieved feed only.
  void set_overlay_curve(std::size_t chart, std::optional<std::size_t> curve);
  /// Limits of the machine, those of jerk where the model keeps them.
  void set_limits(const Setup& setup);
  /// Step of exported samples [s].
  void set_sample_time(double seconds) { sample_time_ = seconds; }
  double sample_time() const { return sample_time_; }
  /// For pictures, which have no controls.
  void hide_controls();

  /// The shown run; null for none.
  const std::shared_ptr<const Trajectory>& trajectory() const { return trajectory_; }
  /// Its drives and load; empty where axes follow exactly.
  const RunSources& sources() const { return sources_; }
  const std::vector<RunOverlay>& overlays() const { return overlays_.runs(); }
  const std::vector<TraceOverlay>& traces() const { return overlays_.traces(); }
  std::optional<std::size_t> overlay_curve(std::size_t chart) const { return overlays_.chosen(chart); }
  Cursor& cursor() { return cursor_; }
  ViewRange& range() { return range_; }
  Interval shown_times() const { return {range_.lower_time(), range_.upper_time()}; }  ///< of the run [s]
  /// Times of the pixel columns' borders at the last refresh() [s].
  const std::vector<double>& column_times() const { return columns_.times(); }
  /// 0 feed, 1 acceleration, 2 jerk; 3 following error: shown if the run has drives; 4 cutting force,
  /// 5 chip thickness: shown if it has a cutting load.
  KinematicChart& chart(std::size_t i) { return *rows_.charts[i]; }
  ChartHeader& header(std::size_t i) { return *rows_.headers[i]; }
  CauseStrip& causes() { return *causes_; }
  LostTimeChart& lost() { return *rows_.lost; }
  FeedShares& shares() { return *rows_.shares; }
  void show_curve(std::size_t chart, std::size_t curve, bool shown);
  void show_usual_curves();
  /// The last shown chart remains.
  void show_chart(std::size_t chart, bool shown);
  bool chart_hidden(std::size_t chart) const { return rows_.hidden[chart]; }
  /// Time of cursor B [s].
  const std::optional<double>& second_cursor() const { return second_; }
  void set_second_cursor(std::optional<double> time);
  /// Text of the differences between both cursors; empty without cursor B.
  QString measurement_text() const;
  /// Values at the cursor, in one line; empty at the start of the run.
  QString cursor_text() const;
  void zoom_to_cursors();
  void move_cursor(int pixels);
  /// Zooms about the cursor if it is visible.
  void zoom(double factor);
  void fit();
  /// Returns to the range and values shown before; go_forward() to those after.
  void go_back();
  void go_forward();
  void choose_abscissa(Abscissa abscissa);

  bool busy() const override { return rows_.lost->busy() || usual_.busy(); }
  /// All commands of the panel, for menus, the list of keys and the command palette.
  QList<QAction*> panel_actions() const override { return commands_->actions(); }
  ChartCommands& commands() { return *commands_; }
  ChartsState state() const;
  /// Without a run, range and second cursor apply to the next one. Unknown curves are omitted.
  void set_state(const ChartsState& state);

  /// Draws everything except the controls, at the size of the panel.
  void draw(QPainter& painter);
  /// Updates the curves now instead of in the next turn of the event loop.
  void refresh();

 signals:
  /// A click has moved the cursor.
  void time_chosen();
  void exported(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place_overlays();
  void place_readout();
  void add_header(std::size_t i, const ChartSpec& spec);
  void connect_chart(KinematicChart& chart);
  void show_alone(std::size_t chart, std::size_t curve);
  /// Whether the cursor points into the shown run: it may already belong to another one.
  bool points_into_run() const;
  void show_cursor();
  void show_charts_of_run();
  void show_other_runs();
  void show_measurement();

  ChartView view() const {
    return {{range_.time_at(range_.lower()), range_.time_at(range_.upper())}, rows_.chosen_values()};
  }
  void show_view(const ChartView& view);
  void show_range(const ChartsState& state);
  void hold_range();
  void show_run_of(Workbench& workbench);
  void show_held_range();
  void begin_rest();
  void rest();

  Cursor& cursor_;
  ViewRange& range_;
  std::shared_ptr<const Trajectory> trajectory_;
  RunSources sources_;
  ChartColumns columns_;
  UsualCurves usual_;
  OverlayCurves overlays_;
  std::optional<double> second_;
  ZoomHistory history_;
  std::optional<ChartsState> awaiting_run_;  ///< its range applies to the next run
  /// The shown range of the last run, kept while there is none.
  struct Held {
    ChartsState state;
    std::optional<double> second_place;  ///< cursor B, path length [mm]
  };
  std::optional<Held> held_;
  std::filesystem::path shown_file_;  ///< file for which the curves were last chosen
  double sample_time_ = 0.001;
  ChartRows rows_;
  ChartScroll* scroll_;            ///< contains the charts
  QVBoxLayout* layout_ = nullptr;  ///< of the charts
  CauseStrip* causes_;
  QLabel* readout_;
  QToolButton* more_;
  ChartCommands* commands_ = nullptr;
  QTimer refresh_;
  QTimer rest_;  ///< runs while the view is changing
};

}  // namespace feedscope::ui
