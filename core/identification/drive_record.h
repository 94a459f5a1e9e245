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

/// How the set position runs between two samples, which no record says.
enum class BetweenSamples : std::uint8_t {
  curve,  ///< the cubic through the four samples around them
  line,   ///< at constant velocity, as a control commands it that interpolates once a sample
};

/// Set and actual positions of one axis, prepared so that the answers of many drives can be laid beside the
/// actual ones.
/// Stretches without samples part a trace, and their ends are not compared; of long traces parts are taken
/// evenly. Traces can stand anywhere against each other: a constant distance of actual and set position, one
/// a trace, counts as no error.
class DriveRecord {
 public:
  /// `axis`: 0 to 2; traces that lack it, or its actual position, are omitted. `most`: samples that are
  /// taken, about. Throws Cancelled.
  DriveRecord(const std::vector<const Trace*>& traces, std::size_t axis, std::size_t most,
              BetweenSamples between = BetweenSamples::curve, Progress* progress = nullptr);

  std::size_t size() const { return measured_.size(); }  ///< samples that are compared
  double reach() const { return reach_; }                ///< of the set positions, highest less lowest [mm]
  /// By how much the actual position lags at constant velocity: following error over velocity, by least
  /// squares [s].
  double lag_time() const;
  /// Actual position of the drive less the measured one, less their mean in each trace, by sample [mm].
  /// `delay`: by which the actual positions were recorded later than the set ones, at most nine periods to
  /// both sides [s].
  Eigen::VectorXd residuals(const AxisDrive& drive, double delay = 0) const;
  double period() const { return period_; }  ///< longest of the traces [s]
  BetweenSamples between() const { return between_; }
  /// The same for an axis that follows exactly.
  Eigen::VectorXd following_errors() const;

 private:
  /// Samples in order without a gap.
  struct Stretch {
    std::size_t first = 0;          ///< step
    std::size_t last = 0;           ///< behind the last step
    std::size_t settling = 0;       ///< steps at its start that are not compared
    std::size_t last_compared = 0;  ///< behind the last step that is
    std::size_t trace = 0;          ///< of those with this axis
    bool begins_in_motion = false;
  };
  /// From one sample to the next.
  struct Step {
    double time = 0;                     ///< [s]
    double set = 0;                      ///< position at its end [mm]
    double actual = 0;                   ///< the same, measured
    std::array<double, 3> derivative{};  ///< of the set position at its start [mm/s^k]
  };

  void add(const Trace& trace, std::size_t axis, std::size_t number, std::size_t most);
  void add_stretch(const Trace& trace, std::size_t axis, std::size_t number, std::size_t begin,
                   std::size_t end);
  /// Leaves what delays reach beyond out of both ends of a stretch.
  void leave_margins(Stretch& stretch) const;
  Eigen::VectorXd without_means(Eigen::VectorXd values) const;

  BetweenSamples between_;
  std::vector<Step> steps_;
  std::vector<Stretch> stretches_;
  std::vector<double> measured_;    ///< following errors of the steps that are compared [mm]
  std::vector<Eigen::Index> ends_;  ///< behind the last of these, by trace
  double reach_ = 0;
  double period_ = 0;
};

}  // namespace feedscope
