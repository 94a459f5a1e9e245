#pragma once

#include <QWidget>
#include <optional>

#include "ui/charts/lost_times.h"
#include "ui/charts/value_fit.h"
#include "ui/shared/job.h"
#include "ui/shared/view_range.h"

namespace feedscope::ui {

/// The time that the current run has lost against each other run since the start, along the charts: where a
/// curve rises, the current run is slower, where it falls, faster; where it ends, is the difference of the
/// cycle times. Hidden while there is no other run.
class LostTimeChart : public QWidget {
  Q_OBJECT

 public:
  /// `range` outlives this.
  explicit LostTimeChart(const ViewRange& range, QWidget* parent = nullptr);

  /// Works out on another thread what `run` (null: none) has lost at `times`, the borders of equally wide
  /// columns of the range; what is shown stays until then.
  void show_runs(const std::shared_ptr<const Trajectory>& run, const std::vector<RunOverlay>& others,
                 const std::vector<double>& times);
  bool busy() const { return job_.busy(); }
  /// For pictures that are drawn at once: nothing is worked out or shown.
  /// Whether the panel is high enough for it.
  void set_room(bool room);
  void switch_off() { off_ = true; }
  void set_lost(LostTimes lost);
  const LostTimes& lost() const { return lost_; }
  /// Position of the cursor along the abscissa, and its time [s]; none: values of the end of what is shown.
  void set_cursor(std::optional<double> position, std::optional<double> time);
  /// "−12.345 s" of the other run with this number, at the cursor or at the end of what is shown.
  QString value_text(std::size_t other) const;
  /// The ordinate [s]; holds 0.
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
