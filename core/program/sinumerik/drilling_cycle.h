#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/program/sinumerik/arguments.h"

namespace feedscope::sinumerik {

/// One step of a drilling cycle, along the tool axis.
struct DrillingStep {
  enum class Kind : std::uint8_t {
    rapid,
    feed,      ///< at the programmed feed times `value`
    own_feed,  ///< at the feed `value`, as F would give it
    thread,    ///< `value` [mm] a revolution, at `speed` revolutions a second; 0: the programmed one
    dwell,     ///< `value` seconds; negative: revolutions
  };
  Kind kind = Kind::rapid;
  double height = 0;  ///< on the tool axis, as programmed
  double value = 1;
  double speed = 0;
  /// From the hole's centre, along the plane's axes, as programmed: CYCLE86 lifts the edge off the wall.
  std::array<double, 2> aside{};
};

/// CYCLE81 to CYCLE89 and CYCLE840, the order of their parameters as in the Programming Manual NC,
/// "programming cycles externally".
class DrillingCycle {
 public:
  /// `number` is that of the cycle, lengths are as programmed, a unit of them being `mm` long; none for other
  /// numbers.
  static std::optional<DrillingCycle> make(int number, const Arguments& arguments, double mm = 1);

  /// One hole, from above it.
  const std::vector<DrillingStep>& steps() const { return steps_; }
  /// Axis of the plane that the tool moves along: 0, 1, or 2 for the one across it.
  int axis() const { return axis_; }

 private:
  explicit DrillingCycle(const Arguments& arguments);

  void drill(double bottom_dwell);
  void deep_hole(const Arguments& arguments);
  struct Tapping {
    double lead = 0;   ///< [mm]
    double speed = 0;  ///< [1/s]
    double speed_back = 0;
    double dwell = 0;
    double stroke = 0;  ///< between lifts; 0: in one go
    double lift = 0;    ///< 0: up to the safe height
  };
  void tap(const Tapping& tapping);
  void lift_off(double first, double second, double up);
  void add(DrillingStep::Kind kind, double height, double value = 1, double speed = 0) {
    steps_.push_back({kind, height, value, speed, {}});
  }
  void rapid(double height) { add(DrillingStep::Kind::rapid, height); }
  void feed(double height, double share = 1) { add(DrillingStep::Kind::feed, height, share); }
  void own_feed(double height, double feed);
  void dwell(double time);

  double retract_ = 0;  ///< RTP
  double top_ = 0;      ///< RFP
  double safe_ = 0;     ///< RFP and SDIS
  double bottom_ = 0;   ///< DP, or from DPR
  double up_ = 1;       ///< direction out of the hole: 1 or -1
  int axis_ = 2;
  std::vector<DrillingStep> steps_;
};

}  // namespace feedscope::sinumerik
