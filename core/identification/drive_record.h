#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/drives/set_course.h"
#include "core/machine/axis_drive.h"
#include "core/trace/trace.h"

namespace feedscope {

/// Course of the set position between two samples, which no record contains.
enum class BetweenSamples : std::uint8_t {
  curve,  ///< the cubic through the four samples around them
  line,   ///< at constant velocity, as from a control that interpolates once per sample
};

/// Set and actual positions of one axis, prepared for comparison with the responses of many drives. Stretches
/// without samples divide a trace, and their ends are not compared; of long traces, evenly spaced parts are
/// taken. The zero points of traces may differ: a constant distance between actual and set position, one per
/// trace, is no error.
class DriveRecord {
 public:
  /// `axis`: 0 to 2; traces without it or its actual position are omitted. `most`: approximate number of
  /// samples taken. Throws Cancelled.
  DriveRecord(const std::vector<const Trace*>& traces, std::size_t axis, std::size_t most,
              BetweenSamples between = BetweenSamples::curve, Progress* progress = nullptr);

  std::size_t size() const { return measured_.size(); }  ///< compared samples
  double reach() const { return reach_; }                ///< range of the set positions [mm]
  /// Lag of the actual position at constant velocity: following error over velocity, by least squares [s].
  double lag_time() const;
  /// Actual position of the drive minus the measured one, minus their mean in each trace, by sample [mm].
  /// `delay`: delay of the recorded actual positions against the set ones, at most nine periods either way
  /// [s].
  Eigen::VectorXd residuals(const AxisDrive& drive, double delay = 0) const;
  double period() const { return period_; }  ///< longest of the traces [s]
  BetweenSamples between() const { return between_; }
  /// Residuals of an axis that follows exactly.
  Eigen::VectorXd following_errors() const;

 private:
  /// Consecutive samples without a gap.
  struct Stretch {
    std::size_t first = 0;          ///< step
    std::size_t last = 0;           ///< after the last step
    std::size_t settling = 0;       ///< steps at its start that are not compared
    std::size_t last_compared = 0;  ///< after the last compared step
    std::size_t trace = 0;          ///< index among those with this axis
    bool begins_in_motion = false;
  };
  /// Interval from one sample to the next.
  struct Step {
    double time = 0;                     ///< [s]
    double set = 0;                      ///< position at its end [mm]
    double actual = 0;                   ///< measured position at its end [mm]
    std::array<double, 3> derivative{};  ///< of the set position at its start [mm/s^k]
  };

  void add(const Trace& trace, std::size_t axis, std::size_t number, std::size_t most);
  void add_stretch(const Trace& trace, std::size_t axis, std::size_t number, std::size_t begin,
                   std::size_t end);
  /// Excludes the margins of a stretch that delays may exceed.
  void leave_margins(Stretch& stretch) const;
  Eigen::VectorXd without_means(Eigen::VectorXd values) const;

  BetweenSamples between_;
  std::vector<Step> steps_;
  std::vector<Stretch> stretches_;
  std::vector<double> measured_;    ///< following errors of the compared steps [mm]
  std::vector<Eigen::Index> ends_;  ///< one past the last of these, by trace
  double reach_ = 0;
  double period_ = 0;
};

}  // namespace feedscope
