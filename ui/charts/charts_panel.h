#pragma once

#include <QFutureWatcher>
#include <QList>
#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/machine/machine.h"
#include "ui/charts/cause_strip.h"
#include "ui/charts/chart_header.h"
#include "ui/charts/charts_state.h"
#include "ui/charts/column_cache.h"
#include "ui/charts/csv_dialog.h"
#include "ui/charts/kinematic_chart.h"
#include "ui/charts/run_overlay.h"
#include "ui/charts/zoom_history.h"
#include "ui/models/cursor.h"

class QAction;
class QComboBox;
class QLabel;
class QLayout;
class QMenu;
class QToolButton;

namespace feedscope::ui {

/// Feed with what limits it, acceleration and jerk of a run, one above the other, along one abscissa; other
/// runs beside it.
///
/// Cursor A is the shared one. Cursor B stands where Shift and a click put it, and is this panel's own: with
/// it the differences between both are shown.
class ChartsPanel : public QWidget {
  Q_OBJECT

 public:
  /// `cursor` outlives this; a click moves it.
  explicit ChartsPanel(Cursor& cursor, QWidget* parent = nullptr);
  ~ChartsPanel() override;

  /// Shows a run, or nothing if `trajectory` is null. `keep_range`: stay at the stretch that is shown; with
  /// nothing in between, the next run that keeps it goes on there.
  void set_run(std::shared_ptr<const Trajectory> trajectory, std::shared_ptr<const Envelope> envelope,
               bool keep_range);
  /// Other runs of the same program, drawn behind. Over path length they stand by place.
  void set_overlays(std::vector<RunOverlay> overlays);
  /// The curve of other runs that a chart shows, by its number in the chart's spec; none: no curve. At first
  /// the achieved feed alone.
  void set_overlay_curve(std::size_t chart, std::optional<std::size_t> curve);
  void set_limits(const std::array<AxisLimits, 3>& limits);
  /// Step of exported samples [s].
  void set_sample_time(double seconds) { sample_time_ = seconds; }
  /// For pictures, where nothing can be pressed.
  void hide_controls();

  /// What is shown; null for nothing.
  const std::shared_ptr<const Trajectory>& trajectory() const { return trajectory_; }
  const std::vector<RunOverlay>& overlays() const { return overlays_; }
  ViewRange& range() { return range_; }
  /// 0 feed, 1 acceleration, 2 jerk.
  KinematicChart& chart(std::size_t i) { return *charts_[i]; }
  ChartHeader& header(std::size_t i) { return *headers_[i]; }
  CauseStrip& causes() { return *causes_; }
  void show_curve(std::size_t chart, std::size_t curve, bool shown);
  void show_all_curves();
  /// Time of cursor B [s].
  const std::optional<double>& second_cursor() const { return second_; }
  void set_second_cursor(std::optional<double> time);
  /// The differences between both cursors as they are shown; empty without cursor B.
  QString measurement_text() const;

  /// Every command of the panel, for menus, the list of keys and the command palette.
  QList<QAction*> panel_actions() const { return actions_; }
  ChartsState state() const;
  /// Without a run, range and second cursor are those of the next one. Curves that there are none of are
  /// left out.
  void set_state(const ChartsState& state);

  /// All but the controls, at the size that the panel has.
  void draw(QPainter& painter);
  /// As the file's ending says, png or svg; throws InputError.
  void save_picture(const QString& file);
  /// The visible range; `step` of CsvRows::samples [s]. Another thread writes it and one of exported() and
  /// failed() follows.
  void save_csv(const QString& file, CsvRows rows, double step = 0);
  /// Brings the curves up to date now, not with the next turn of the event loop.
  void refresh();

 signals:
  void exported(const QString& message);
  void failed(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLayout* add_header(std::size_t i, const ChartSpec& spec);
  void connect_chart(KinematicChart& chart);
  void make_actions();
  void make_zoom_actions();
  void make_cursor_actions();
  void make_display_actions();
  void make_export_actions();
  QAction* add_action(const QString& text, const QString& tip, const QKeySequence& key = {});
  void add_overlay_menu(std::size_t chart, QMenu& menu);
  void show_menu(const QPoint& global);

  void show_alone(std::size_t chart, std::size_t curve);
  void refresh_columns();
  std::vector<OverlayCurve> overlay_curves(std::size_t chart) const;
  double overlay_time(const RunOverlay& overlay, double position) const;
  void show_cursor();
  void show_other_runs();
  void show_measurement();
  void move_cursor(int pixels);
  void zoom_to_cursors();
  void fit();
  void choose_abscissa(Abscissa abscissa);

  ChartView view() const;
  void show_view(const ChartView& view);
  void show_range(const ChartsState& state);
  void hold_range();
  void show_held_range();
  void begin_rest();
  void rest();
  void ask_for_csv();
  void ask_for_picture();

  Cursor& cursor_;
  ViewRange range_;
  std::shared_ptr<const Trajectory> trajectory_;
  std::shared_ptr<const Envelope> envelope_;
  ColumnCache columns_;
  std::vector<RunOverlay> overlays_;
  std::vector<ColumnCache> overlay_columns_;
  std::array<std::optional<std::size_t>, chart_count> overlay_curve_{0, std::nullopt, std::nullopt};
  std::optional<double> second_;
  ZoomHistory history_;
  std::optional<ChartsState> awaiting_run_;  ///< its range is the next run's
  /// What was shown of the last run while there is none.
  struct Held {
    ChartsState state;
    std::optional<double> second_place;  ///< cursor B, path length [mm]
  };
  std::optional<Held> held_;
  double sample_time_ = 0.001;
  CauseStrip* causes_;
  QLabel* readout_;
  std::array<ChartHeader*, chart_count> headers_{};
  std::array<KinematicChart*, chart_count> charts_{};
  QComboBox* abscissa_;
  QToolButton* show_all_;
  QToolButton* more_;
  QList<QAction*> actions_;
  QMenu* menu_;
  QAction* back_ = nullptr;
  QAction* forward_ = nullptr;
  QAction* remove_second_ = nullptr;
  QAction* show_causes_ = nullptr;
  std::array<std::vector<QAction*>, chart_count> curve_actions_;
  QTimer refresh_;
  QTimer rest_;  ///< runs while the view is being changed
  QFutureWatcher<QString> export_;
  QString export_file_;
};

}  // namespace feedscope::ui
