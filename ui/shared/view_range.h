#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/trajectory/trajectory.h"

namespace feedscope::ui {

/// Quantity along the charts.
enum class Abscissa { time, path_length };

/// The range of all charts: one shared range along one shared abscissa.
///
/// Positions are seconds or millimetres, by the abscissa. Over time, the charts extend beyond the run's end
/// if another run or a trace takes longer.
class ViewRange : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Another run; the range is kept if `keep` is set and the new run contains it, else everything is shown.
  void set_trajectory(std::shared_ptr<const Trajectory> trajectory, bool keep);
  /// End of the longest other run or trace [s]; if the whole was shown, it is shown again.
  void set_end_beside(double end);
  /// Shows the same range along the other abscissa.
  void set_abscissa(Abscissa abscissa);
  Abscissa abscissa() const { return abscissa_; }

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  double length() const;  ///< of the whole, in units of the abscissa
  /// Whether rapids are shown: one switch for path and charts.
  bool rapids_shown() const { return rapids_shown_; }
  void show_rapids(bool shown);
  bool shows_all() const { return lower_ <= 0 && upper_ >= length(); }

  void fit();
  /// Shrinks (factor < 1) or widens the range; `pivot` keeps its place on the screen.
  void zoom(double factor, double pivot);
  void pan(double distance);
  /// Shows the range between two positions, moved and cut to the existing one.
  void show(double lower, double upper);
  /// Shows the range between two times [s]; does nothing without a run.
  void show_times(double from, double to);
  double lower_time() const { return in_run(time_at(lower_)); }  ///< within the run [s]
  double upper_time() const { return in_run(time_at(upper_)); }  ///< within the run [s]

  double position_of(const State& state) const;
  double time_at(double position) const;  ///< over time also beyond the run's end [s]
  /// Times at `count` + 1 equally spaced positions from lower() to upper().
  std::vector<double> column_times(int count) const;

 signals:
  void changed();
  void rapids_shown_changed(bool shown);

 private:
  double in_run(double time) const;

  std::shared_ptr<const Trajectory> trajectory_;
  double end_beside_ = 0;  ///< [s]
  Abscissa abscissa_ = Abscissa::time;
  double lower_ = 0;
  double upper_ = 1;
  bool rapids_shown_ = true;
};

}  // namespace feedscope::ui
