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
  blend.clear();
  ceiling.clear();
  level.clear();
}

void Stretch::add(const PlanElement& planned, std::uint32_t path_element, std::uint32_t programmed,
                  bool is_blend) {
  plan.push_back(planned);
  element.push_back(path_element);
  block.push_back(programmed);
  blend.push_back(is_blend ? 1 : 0);
}

void Stretch::hold_level(std::uint32_t e) {
  plan[e].limits.acceleration.value = plan[e].limits.jerk.value = no_ramp;
  if (level.empty() || level.back() < e) {
    level.push_back(e);
  }
  level.push_back(e + 1);
}

StretchRange next_stretch(const Toolpath& toolpath, std::size_t first, bool stop_at_arc_corners,
                          bool stop_at_line_corners) {
  std::size_t last = first + 1;
  for (; last < toolpath.segments.size(); ++last) {
    const JunctionKind kind = junction_kind(toolpath, last);
    if (kind == JunctionKind::stop || (stop_at_arc_corners && kind == JunctionKind::arc_corner) ||
        (stop_at_line_corners && kind == JunctionKind::corner)) {
      break;
    }
  }
  return {first, last};
}

void run_stretches(const Toolpath& toolpath, TrajectoryBuilder& builder, Progress* progress,
                   bool stop_at_line_corners, const StretchRun& run, bool stop_at_arc_corners) {
  ProgressSteps steps(progress, toolpath.segments.size());
  for (std::size_t first = 0; first < toolpath.segments.size();) {
    const StretchRange range = next_stretch(toolpath, first, stop_at_arc_corners, stop_at_line_corners);
    steps.at(first);
    if (toolpath.segments[first].kind == SegmentKind::dwell) {
      const std::uint32_t element = builder.add_segment(toolpath, first, 0);
      builder.add_piece({0, 0, 0, 0, 0, element, {CauseKind::dwell}}, toolpath.segments[first].dwell);
    } else {
      run(range, steps);
    }
    first = range.last;
  }
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
    if (arcs && stretch.blend[j - 1] == 0 && stretch.blend[j] == 0) {
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

void add_planned_motion(TrajectoryBuilder& builder, const Stretch& stretch,
                        const std::vector<PlanNode>& nodes, ProgressSteps& steps) {
  double speed = 0;
  Cause gained;  // what limited the ramp before
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const std::size_t first = nodes[n].junction;
    const std::size_t last = nodes[n + 1].junction;
    steps.at(stretch.block[first]);
    if (last == first + 1 && stretch.is_level(first)) {
      const SpeedBound& limit = stretch.plan[first].limits.speed;
      const bool below = speed < limit.value * (1 - 1e-9);
      const bool slows_next = n + 2 < nodes.size() && nodes[n + 2].speed < speed;
      const Cause held = slows_next ? Cause{CauseKind::ramp_down} : gained;
      builder.add_piece({0, 0, speed, 0, 0, stretch.element[first], below ? held : limit.cause},
                        stretch.plan[first].length / speed);
      continue;
    }
    const SpanLimits span = span_limits(stretch.plan, first, last);
    gained = {CauseKind::axis_jerk, span.jerk.axis};
    speed = add_profile(builder, stretch, profile_to(nodes[n + 1].speed, span, speed, 0), span, first, last);
  }
}

}  // namespace feedscope
