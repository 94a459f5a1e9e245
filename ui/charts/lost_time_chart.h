#pragma once

#include <QWidget>
#include <optional>

#include "ui/charts/lost_times.h"
#include "ui/charts/value_fit.h"
#include "ui/shared/job.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// The time that the current run has lost against each other run since the start, along the charts. Where a
/// curve rises, the current run is slower; where it falls, faster; its end is the difference of the cycle
/// times. Hidden without another run.
class LostTimeChart : public QWidget {
  Q_OBJECT

 public:
  /// `range` outlives this.
  explicit LostTimeChart(const ViewRange& range, QWidget* parent = nullptr);

  /// Computes on another thread the time that `run` (null: none) has lost at `times`, the borders of equally
  /// wide columns of the range; until then the old curves remain.
  void show_runs(const std::shared_ptr<const Trajectory>& run, const std::vector<RunOverlay>& others,
                 const std::vector<double>& times);
  bool busy() const { return job_.busy(); }
  /// Whether the panel is high enough for the chart.
  void set_room(bool room);
  /// For pictures, which are drawn at once: nothing is computed or shown.
  void switch_off() { off_ = true; }
  void set_lost(LostTimes lost);
  const LostTimes& lost() const { return lost_; }
  /// Position of the cursor along the abscissa, and its time [s]; none: values at the end of the shown range.
  void set_cursor(std::optional<double> position, std::optional<double> time);
  /// "−12.345 s" of the other run with this number, at the cursor or at the end of the shown range.
  QString value_text(std::size_t other) const;
  /// The ordinate [s]; contains 0.
  Interval values() const;
  void draw(QPainter& painter) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plot() const;
  void draw_head(QPainter& painter) const;
  void draw_curves(QPainter& painter) const;

  const ViewRange& range_;
  LostTimes lost_;
  std::optional<double> cursor_;
  std::optional<double> cursor_time_;  ///< [s]
  Job<LostTimes> job_;
  bool off_ = false;
  bool has_room_ = true;
};

}  // namespace feedscope::ui
