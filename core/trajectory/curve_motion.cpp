#include "core/trajectory/curve_motion.h"

#include <algorithm>
#include <cmath>

#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

/// Share of the limits above which a ceiling is lowered, and the share to which it is lowered.
constexpr double allowed = 1.01;
constexpr double aim = 0.97;

/// Factor of the speed with which no axis exceeds its limits in this motion; at most 1.
double fitting_speed(const Kinematics& motion, const AxisVectors& axes) {
  double acceleration = 0;
  double jerk = 0;
  for (int j = 0; j < 3; ++j) {
    if (motion.velocity[j] != 0) {
      acceleration = std::max(acceleration, std::abs(motion.acceleration[j]) / axes.acceleration[j]);
      jerk = std::max(jerk, std::abs(motion.jerk[j]) / axes.jerk[j]);
    }
  }
  double factor = 1;
  if (acceleration > allowed) {
    factor = std::sqrt(aim / acceleration);
  }
  if (jerk > allowed) {
    factor = std::min(factor, std::cbrt(aim / jerk));
  }
  return factor;
}

}  // namespace

bool lower_curve_ceilings(const TrajectoryBuilder& builder, const TrajectoryBuilder::Mark& start,
                          Stretch& stretch, const AxisVectors& axes) {
  const BlendedPath& path = builder.path();
  bool any = false;
  std::size_t e = 0;
  for (PartWalk walk(builder.so_far(), start.piece); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    if (path.kind(part.element) != ElementKind::curve) {
      continue;
    }
    while (stretch.element(e) < part.element) {
      ++e;
    }
    if (part.a == 0 && part.j == 0) {
      continue;  // constant speed, below the ceiling
    }
    const ElementCurve curve = path.curve(part.element);
    double factor = 1;
    double speed = 0;
    for (const double share : {0.0, 0.5, 1.0}) {
      const LawPoint law = law_at(part, share * part.duration);
      const double place = std::clamp(law.q / curve.length, 0.0, 1.0);
      const Kinematics at = kinematics_of(curve.span->by_share(place), law);
      factor = std::min(factor, fitting_speed(at, axes));
      speed = std::max(speed, at.velocity.norm());
    }
    if (factor < 1) {
      any = true;
      MotionLimits limits = stretch.plan[e].limits();
      limits.speed.lower(factor * speed, {CauseKind::radial_jerk, limits.speed.cause.axis});
      stretch.plan[e].set_limits(limits);
    }
  }
  return any;
}

void move_over_curves(TrajectoryBuilder& builder, Stretch& stretch, const AxisVectors& axes,
                      const std::function<void()>& plan_and_move) {
  constexpr int most_corrections = 4;
  if (!stretch.has_curves) {
    plan_and_move();
    return;
  }
  const TrajectoryBuilder::Mark start = builder.mark();
  const std::vector<PlanElement> laid = stretch.plan;
  plan_and_move();
  for (int i = 0; i < most_corrections && lower_curve_ceilings(builder, start, stretch, axes); ++i) {
    builder.take_back(start);
    for (std::size_t e = 0; e < laid.size(); ++e) {
      if (stretch.blend[e] != 0) {  // a plan makes them level places
        stretch.plan[e] = laid[e];
      }
    }
    plan_and_move();
  }
}

}  // namespace feedscope
