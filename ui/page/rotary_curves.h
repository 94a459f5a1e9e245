#pragma once

#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope::ui {

struct CurvePoint {
  double time = 0;   ///< [s]
  double value = 0;  ///< [rad/s], [rad/s2], [rad/s3]
};

/// Velocity, acceleration or jerk of a rotary axis over the time of a run: straight between its points.
struct RotaryCurve {
  CauseKind kind = CauseKind::axis_velocity;  ///< or axis_acceleration, axis_jerk: the limit beside it
  char axis = 'A';
  double limit = 0;      ///< of the axis, in the unit of the values
  double precision = 0;  ///< how far it may be from the run, a share of the limit
  std::vector<CurvePoint> points;
};

/// Of axis_velocity, axis_acceleration and axis_jerk those whose limit of a rotary axis slows `run` for a
/// hundredth of its time at least.
std::vector<CauseKind> deciding_rotary_limits(const Run& run);

/// Curves of `kinds` for every rotary axis of the machine; none where no rotary axis turns. `most`: points of
/// a curve; of more the ones that matter least are left out, as the precision says. Throws Cancelled.
std::vector<RotaryCurve> rotary_curves(const Run& run, const std::vector<CauseKind>& kinds, std::size_t most,
                                       const Progress* progress = nullptr);

}  // namespace feedscope::ui
