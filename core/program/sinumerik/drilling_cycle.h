#pragma once

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
    thread,    ///< `value` mm a revolution, at `speed` revolutions a second; 0: the programmed one
    dwell,     ///< `value` seconds; negative: revolutions
  };
  Kind kind = Kind::rapid;
  double height = 0;  ///< on the tool axis, as programmed
  double value = 1;
  double speed = 0;
};

/// CYCLE81 to CYCLE89 and CYCLE840.
class DrillingCycle {
 public:
  /// `number` is that of the cycle, lengths are as programmed; none for other numbers.
  static std::optional<DrillingCycle> make(int number, const Arguments& arguments);

  /// One hole, from above it.
  const std::vector<DrillingStep>& steps() const { return steps_; }

 private:
  explicit DrillingCycle(const Arguments& arguments);

  void drill(double bottom_dwell);
  void deep_hole(const Arguments& arguments);
  void tap(double pitch, double speed, double speed_back, double dwell);
  void rapid(double height) { steps_.push_back({DrillingStep::Kind::rapid, height, 1, 0}); }
  void feed(double height, double share = 1) {
    steps_.push_back({DrillingStep::Kind::feed, height, share, 0});
  }
  void own_feed(double height, double feed);
  void dwell(double time);

  double retract_ = 0;  ///< RTP
  double top_ = 0;      ///< RFP
  double safe_ = 0;     ///< RFP and SDIS
  double bottom_ = 0;   ///< DP, or from DPR
  double up_ = 1;       ///< direction out of the hole: 1 or -1
  std::vector<DrillingStep> steps_;
};

}  // namespace feedscope::sinumerik
