#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/models/ward/ward_pulses.h"
#include "core/trajectory/length_walk.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Lays the filtered motion of chosen pulses as elements, pieces and records of a trajectory.
class WardMotion {
 public:
  /// The builder outlives this.
  WardMotion(WardPulses pulses, TrajectoryBuilder& builder) : pulses_(std::move(pulses)), builder_(builder) {}

  /// Lays the motion after everything built so far. `error`: largest distance of a programmed point from the
  /// path [mm]; `steps` counts segments.
  void lay(double error, ProgressSteps& steps);

 private:
  struct Span {
    double end = 0;  ///< of the motion [s]
    double q = 0;    ///< path length from the element's start [mm]
    Cause cause;
    bool settled = false;
  };
  struct SpanEnd {
    double time = 0;                                   ///< of the motion [s]
    std::optional<std::size_t> corner = std::nullopt;  ///< corner whose blending pulse fills the span, if any
    bool settled = false;
  };

  void add_element(double start, std::size_t block);
  void add_spans(LengthWalk& length, std::size_t block);
  void add_span(LengthWalk& length, std::size_t block, const SpanEnd& to);
  /// Limiting cause at a time within `block`. `corner`: of the blending pulse there, if any.
  Cause cause_at(const SpeedSample& at, std::size_t block, std::optional<std::size_t> corner) const;
  /// Share of the speed limit on an arc left by the filters.
  double arc_gain(std::size_t block) const;
  bool slowed_by_tolerance(std::size_t corner) const;

  WardPulses pulses_;
  TrajectoryBuilder& builder_;
  std::vector<Span> spans_;  ///< of the current element
};

}  // namespace feedscope
