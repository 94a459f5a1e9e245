#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/trajectory/trajectory.h"

namespace feedscope::ui {

/// What runs along the charts.
enum class Abscissa { time, path_length };

/// The stretch that all charts show: one shared range along one shared abscissa.
///
/// Positions are seconds or millimetres, whichever the abscissa is. Over time the charts go on where a run or
/// a trace that is shown beside the run takes longer.
class ViewRange : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Another run; the range stays where it is if `keep` and the new run reaches there, else all is shown.
  void set_trajectory(std::shared_ptr<const Trajectory> trajectory, bool keep);
  /// When what is shown beside the run ends [s]; where the whole was shown, it is again.
  void set_end_beside(double end);
  /// Shows the same stretch along the other abscissa.
  void set_abscissa(Abscissa abscissa);
  Abscissa abscissa() const { return abscissa_; }

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  double length() const;  ///< of all that can be shown, in units of the abscissa
  /// Whether rapids are shown: one switch for the path and the charts.
  bool rapids_shown() const { return rapids_shown_; }
  void show_rapids(bool shown);
  bool shows_all() const { return lower_ <= 0 && upper_ >= length(); }

  void fit();
  /// Shrinks (factor < 1) or widens the range; `pivot` keeps its place on the screen.
  void zoom(double factor, double pivot);
  void pan(double distance);
  /// Shows from one position to another, moved and cut to what there is.
  void show(double lower, double upper);
  /// The same from one time to another [s]; nothing without a run.
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
