#include "core/trajectory/stretch.h"

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"
#include "core/feed/profile_walk.h"

namespace feedscope {

void Stretch::clear() {
  plan.clear();
  element.clear();
  block.clear();
  ceiling.clear();
}

void Stretch::add(const PlanElement& planned, std::uint32_t path_element, std::uint32_t programmed) {
  plan.push_back(planned);
  element.push_back(path_element);
  block.push_back(programmed);
}

StretchRange next_stretch(const Toolpath& toolpath, std::size_t first, bool stop_at_arc_corners) {
  std::size_t last = first + 1;
  for (; last < toolpath.segments.size(); ++last) {
    const JunctionKind kind = junction_kind(toolpath, last);
    if (kind == JunctionKind::stop || (stop_at_arc_corners && kind == JunctionKind::arc_corner)) {
      break;
    }
  }
  return {first, last};
}

void set_junction_ceilings(Stretch& stretch, const BlendedPath& path, const Vec3& axis_jerk,
                           double interpolation_period, std::uint32_t lookahead_blocks) {
  const std::size_t count = stretch.plan.size();
  stretch.ceiling.assign(count + 1, 0);
  for (std::size_t j = 1; j < count; ++j) {
    const PathElement& before = path.elements[stretch.element[j - 1]];
    const PathElement& after = path.elements[stretch.element[j]];
    double ceiling = std::min(stretch.plan[j - 1].limits.speed.value, stretch.plan[j].limits.speed.value);
    const bool arcs = before.kind == ElementKind::arc || after.kind == ElementKind::arc;
    if (arcs && before.kind != ElementKind::blend && after.kind != ElementKind::blend) {
      const Vec3 step = path.at(after, 0).d2 - path.at(before, before.length).d2;
      ceiling = std::min(ceiling, crossing_speed(step, axis_jerk, interpolation_period).value);
    }
    stretch.ceiling[j] = ceiling;
  }
  apply_lookahead_horizon(stretch.plan, stretch.block, lookahead_blocks, stretch.ceiling);
  stretch.ceiling.front() = stretch.ceiling.back() = 0;
}

SpeedProfile profile_to(double target, const SpanLimits& span, double speed, double acceleration) {
  const auto plan = [&](double end) {
    return plan_profile(speed, acceleration, end, span.length, span.ceiling, span.ramp());
  };
  SpeedProfile profile = plan(target);
  const double settled = speed + acceleration * std::abs(acceleration) / (2 * span.jerk.value);
  if (profile.feasible || target <= settled) {
    return profile;
  }
  double low = std::max(settled, 0.0);
  double high = target;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (plan(middle).feasible ? low : high) = middle;
  }
  return plan(low);
}

double add_profile(TrajectoryBuilder& builder, const Stretch& stretch, const SpeedProfile& profile,
                   const SpanLimits& span, std::size_t first, std::size_t last) {
  const bool slows_first = profile.peak < profile.v0;
  const auto cause_of = [&](std::size_t phase, std::size_t e) -> Cause {
    if (phase == 3) {
      return stretch.plan[e].limits.speed.cause;
    }
    if (phase > 3 || slows_first) {
      return {CauseKind::ramp_down};
    }
    return phase == 1 ? Cause{CauseKind::axis_acceleration, span.acceleration.axis}
                      : Cause{CauseKind::axis_jerk, span.jerk.axis};
  };
  ProfileWalk walk(profile);
  double start = 0;
  for (std::size_t e = first; e < last; ++e) {
    const double end = start + stretch.plan[e].length;
    while (walk.phase() < 7) {
      const double left = walk.phase_left();
      const double time = e + 1 == last ? left : walk.time_to(end);
      const Motion1d& at = walk.at();
      builder.add_piece(
          {0, at.s - start, at.v, at.a, walk.jerk(), stretch.element[e], cause_of(walk.phase(), e)}, time);
      walk.move_by(time);
      if (time < left) {
        break;
      }
    }
    start = end;
  }
  return walk.at().v;
}

}  // namespace feedscope
