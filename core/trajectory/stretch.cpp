#include "core/trajectory/stretch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "core/base/parallel.h"
#include "core/base/roots.h"
#include "core/blend/junction.h"
#include "core/limits/segment_limits.h"

namespace feedscope {

void Stretch::clear() {
  plan.clear();
  has_curves = false;
  blend.clear();
  ceiling.clear();
  level.clear();
  turning.clear();
}

void Stretch::reserve(std::size_t elements) {
  plan.reserve(elements);
  blend.reserve(elements);
  ceiling.reserve(elements + 1);
}

void Stretch::add(const PlanElement& planned, std::uint32_t path_element, std::uint32_t block,
                  bool is_blend) {
  std::uint32_t order = 0;
  if (plan.empty()) {
    first_element_ = path_element;
  } else {
    order = plan.back().order + (block - last_block_);
  }
  last_block_ = block;
  plan.push_back(planned);
  plan.back().order = order;
  blend.push_back(is_blend ? 1 : 0);
}

void Stretch::add_span(const PlanElement& planned, std::uint32_t path_element, std::uint32_t block) {
  const std::uint32_t next = plan.empty() ? 0 : plan.back().order + 1;
  add(planned, path_element, block);
  plan.back().order = next;
  has_curves = true;
}

void Stretch::hold_level(std::uint32_t e) {
  const MotionLimits limits = plan[e].limits();
  plan[e].set_ramps({no_ramp, limits.acceleration.axis}, {no_ramp, limits.jerk.axis});
  if (level.empty() || level.back() < e) {
    level.push_back(e);
  }
  level.push_back(e + 1);
}

std::span<const std::uint32_t> Stretch::held() {
  if (turning.empty()) {
    return level;
  }
  held_.clear();
  std::ranges::set_union(level, turning, std::back_inserter(held_));
  return held_;
}

namespace {

/// True if a stretch begins at `segment`.
bool begins_stretch(const Toolpath& toolpath, const PathRules& rules, std::size_t segment,
                    bool stop_at_arc_corners) {
  const JunctionKind kind = junction_kind(toolpath, segment);
  const bool corner = kind == JunctionKind::corner || kind == JunctionKind::arc_corner;
  return kind == JunctionKind::stop || (stop_at_arc_corners && kind == JunctionKind::arc_corner) ||
         (corner && rules.corner_tolerance(segment - 1) == 0) || rules.stops_at_joint(segment - 1);
}

std::size_t next_begin(const Toolpath& toolpath, const PathRules& rules, std::size_t segment,
                       bool stop_at_arc_corners) {
  while (segment < toolpath.segments.size() &&
         !begins_stretch(toolpath, rules, segment, stop_at_arc_corners)) {
    ++segment;
  }
  return std::min(segment, toolpath.segments.size());
}

/// Starts of the parts of the program that are run separately, and its end.
std::vector<std::size_t> part_borders(const Toolpath& toolpath, const PathRules& rules,
                                      bool stop_at_arc_corners) {
  constexpr std::size_t least_segments = 8192;
  const std::size_t count = toolpath.segments.size();
  std::vector<std::size_t> borders{0};
  while (count - borders.back() > least_segments) {
    borders.push_back(next_begin(toolpath, rules, borders.back() + least_segments, stop_at_arc_corners));
  }
  if (borders.back() < count) {
    borders.push_back(count);
  }
  return borders;
}

}  // namespace

StretchRange next_stretch(const Toolpath& toolpath, const PathRules& rules, std::size_t first,
                          bool stop_at_arc_corners) {
  return {first, next_begin(toolpath, rules, first + 1, stop_at_arc_corners)};
}

void run_stretches(const Toolpath& toolpath, TrajectoryBuilder& builder, Progress* progress,
                   const PathRules& rules, const StretchRunner& runner, bool stop_at_arc_corners) {
  builder.stop_with(progress);
  const auto run_part = [&](const StretchRange& part, TrajectoryBuilder& into, ProgressSteps steps) {
    const StretchRun run = runner(into);
    for (std::size_t first = part.first; first < part.last;) {
      const StretchRange range = next_stretch(toolpath, rules, first, stop_at_arc_corners);
      steps.at(first);
      if (toolpath.segments[first].kind == SegmentKind::dwell) {
        into.add_pause(static_cast<std::uint32_t>(first));
      } else {
        run(range, steps);
      }
      first = range.last;
    }
  };
  const std::size_t count = toolpath.segments.size();
  const std::vector<std::size_t> borders = part_borders(toolpath, rules, stop_at_arc_corners);
  if (borders.size() <= 2) {
    run_part({0, count}, builder, {progress, count});
    return;
  }
  in_order(borders.size() - 1, [&](std::size_t i) -> std::function<void()> {
    const StretchRange range{borders[i], borders[i + 1]};
    const std::size_t size = range.last - range.first;
    const auto share = [&](std::size_t segments) {
      return static_cast<double>(segments) / static_cast<double>(count);
    };
    std::optional<Progress> own;
    if (progress != nullptr) {
      own.emplace(*progress, share(size));
    }
    const auto part = std::make_shared<TrajectoryBuilder>(builder.part());
    run_part(range, *part, {own ? &*own : nullptr, range.first, size});
    if (own) {
      own->report(1);
    }
    return [&builder, part, done = share(range.last)] { builder.append(std::move(*part), done); };
  });
}

void follow_acceleration_mode(Stretch& stretch, const BlendedPath& path, const PathRules& rules,
                              double interpolation_period) {
  if (!rules.has_acceleration_jumps()) {
    return;
  }
  for (std::size_t e = 0; e < stretch.plan.size(); ++e) {
    const std::size_t first = path.base_segment_of(stretch.element(e));
    const std::size_t last = first + (path.in_corner(stretch.element(e)) ? 1 : 0);
    if (rules.acceleration_jumps(first) && rules.acceleration_jumps(last)) {
      stretch.plan[e].set_limits(with_acceleration_jumps(stretch.plan[e].limits(), interpolation_period));
    }
  }
}

namespace {

/// Curvature vector of a line or an arc at `s` from its start [1/mm]. Uses the planned length, because the
/// length stored in the path is rounded by everything before it: a stretch is planned the same wherever it is
/// in the program.
Vec3 bend(const ElementCurve& curve, double s) {
  return curve.is_arc() ? curve.arc.at(s).d2 : Vec3(Vec3::Zero());
}

}  // namespace

void set_junction_ceilings(Stretch& stretch, const BlendedPath& path, const Vec3& axis_jerk,
                           double interpolation_period, std::uint32_t lookahead_blocks) {
  const std::size_t count = stretch.plan.size();
  stretch.ceiling.assign(count + 1, {0, {CauseKind::exact_stop}});
  const bool turns = !path.programmed()->turn_joints.empty();
  for (std::size_t j = 1; j < count; ++j) {
    SpeedBound& ceiling = stretch.ceiling[j];
    ceiling = stretch.plan[j - 1].speed();
    ceiling.lower(stretch.plan[j].speed().value, stretch.plan[j].speed().cause);
    const std::uint32_t before = stretch.element(j - 1);
    const std::uint32_t after = stretch.element(j);
    if (turns && path.segment(after) > path.segment(before)) {
      const SpeedBound turn = turn_ceiling(*path.programmed(), path.segment(after) - std::size_t{1});
      ceiling.lower(turn.value, turn.cause);
    }
    const bool arcs = path.kind(before) == ElementKind::arc || path.kind(after) == ElementKind::arc ||
                      path.kind(before) == ElementKind::connecting_arc ||
                      path.kind(after) == ElementKind::connecting_arc;
    if (arcs && stretch.blend[j - 1] == 0 && stretch.blend[j] == 0) {
      const Vec3 step = bend(path.curve(after), 0) - bend(path.curve(before), stretch.plan[j - 1].length);
      const SpeedBound crossing = crossing_speed(step, axis_jerk, interpolation_period);
      ceiling.lower(crossing.value, crossing.cause);
    }
  }
  apply_lookahead_horizon(stretch.plan, lookahead_blocks, stretch.ceiling);
  stretch.ceiling.front() = stretch.ceiling.back() = {0, {CauseKind::exact_stop}};
  if (turns && count > 0) {
    const Toolpath& toolpath = *path.programmed();
    if (const std::uint32_t first = path.segment(stretch.element(0)); first > 0) {
      stretch.ceiling.front().cause = stop_cause(toolpath, first - std::size_t{1});
    }
    stretch.ceiling.back().cause = stop_cause(toolpath, path.segment(stretch.element(count - 1)));
  }
}

void part_turning(Stretch& stretch, const BlendedPath& path) {
  constexpr double largest_ratio = 2;
  const Toolpath& toolpath = *path.programmed();
  stretch.turning.clear();
  if (toolpath.segment_turns.empty()) {
    return;
  }
  struct Range {
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    bool holds(double value) const {
      return std::max(largest, value) <= largest_ratio * std::min(least, value);
    }
    void add(double value) {
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  };
  Range acceleration;
  Range jerk;
  bool turned = false;
  for (std::uint32_t e = 0; e < stretch.plan.size(); ++e) {
    if (stretch.blend[e] != 0) {
      continue;
    }
    const PlanElement& element = stretch.plan[e];
    const bool turns = toolpath.segment_turn(path.segment(stretch.element(e))) != nullptr;
    const bool same = acceleration.holds(element.acceleration().value) && jerk.holds(element.jerk().value);
    if (!same && (turns || turned) && e > 0) {
      stretch.turning.push_back(e);
    }
    if (!same) {
      acceleration = jerk = {};
    }
    acceleration.add(element.acceleration().value);
    jerk.add(element.jerk().value);
    turned = turns;
  }
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
  if (acceleration == 0) {  // usually only rounding keeps `target` out of reach
    SpeedProfile reached = plan(std::min(target, reachable_speed(speed, span.length, span.ramp())));
    if (reached.feasible) {
      return reached;
    }
  }
  constexpr int halvings = 50;
  return plan(halve({std::max(settled, 0.0), target}, halvings, [&](double speed_wanted) {
                return plan(speed_wanted).feasible;
              }).low);
}

namespace {

std::uint8_t code_of(Cause cause) {
  return static_cast<std::uint8_t>(cause_index(cause));
}

/// Lays pieces over elements [first, last) of a stretch one after the other, and remembers the place.
class ProfileLayer {
 public:
  ProfileLayer(TrajectoryBuilder& builder, const Stretch& stretch, std::size_t first, std::size_t last,
               const Motion1d& start)
      : builder_(builder), stretch_(stretch), element_(first), last_(last), at_(start) {}

  double speed() const { return at_.v; }
  /// True if no blend is run by its parameter: then a piece may cross several elements.
  bool all_by_length() const {
    for (std::size_t e = element_; stretch_.blends_by_parameter && e < last_; ++e) {
      if (stretch_.by_parameter(e)) {
        return false;
      }
    }
    return true;
  }

  /// Constant jerk over one phase, whatever elements it crosses.
  void add(const Phase& phase, Cause cause, std::uint8_t second = Piece::no_cause) {
    double left = phase.duration;
    while (left > 0) {
      const double end = end_of_law();
      const double time =
          std::isfinite(end) ? time_to_reach({at_.s, at_.v, at_.a, phase.jerk}, end, left) : left;
      add_piece(at_.a, phase.jerk, cause, Law::path_length, second, time);
      Motion1d there = advance(at_, phase.jerk, time);
      if (time < left) {
        there.s = end;
      }
      move_to(there);
      left -= time;
    }
  }

  /// Raises the acceleration to `top`, keeps it and lowers it again, as one piece.
  void add_ramp(std::span<const Phase, 3> phases, Cause cause, std::uint8_t second) {
    const double duration = phases[0].duration + phases[1].duration + phases[2].duration;
    const double jerk = phases[0].jerk;
    add_piece(jerk * phases[0].duration, jerk, cause, Law::ramp, second, duration);
    Motion1d end = at_;
    for (const Phase& phase : phases) {
      end = advance(end, phase.jerk, phase.duration);
    }
    end.a = 0;
    move_to(end);
  }

  /// Constant speed; the elements determine why it is not higher.
  void add_cruise(double duration) {
    constexpr std::size_t max_elements = 256;  // of one piece, so that none takes long to search
    at_.a = 0;
    while (duration > 0) {
      const Cause cause = stretch_.plan[element_].speed().cause;
      double end = start_ + stretch_.plan[element_].length;
      for (std::size_t e = element_ + 1;
           e < last_ && e - element_ < max_elements && stretch_.plan[e].speed().cause == cause &&
           !stretch_.by_parameter(e) && !stretch_.by_parameter(element_) && end < at_.s + at_.v * duration;
           ++e) {
        end += stretch_.plan[e].length;
      }
      const double to_end = (end - at_.s) / at_.v;
      const bool rest = to_end >= duration || element_ + 1 == last_;
      const double time = rest ? duration : to_end;
      add_piece(0, 0, cause, Law::path_length, Piece::no_cause, time);
      move_to({rest ? at_.s + at_.v * time : end, at_.v, 0});
      duration = rest ? 0 : duration - time;
    }
  }

 private:
  /// Place where the current law has to give way to another one; infinite if it need not [mm].
  double end_of_law() const {
    if (!stretch_.blends_by_parameter) {
      return std::numeric_limits<double>::infinity();
    }
    double end = start_ + stretch_.plan[element_].length;
    std::size_t e = element_ + 1;
    for (; !stretch_.by_parameter(element_) && e < last_ && !stretch_.by_parameter(e); ++e) {
      end += stretch_.plan[e].length;
    }
    return e < last_ ? end : std::numeric_limits<double>::infinity();
  }

  void add_piece(double a, double j, Cause cause, Law law, std::uint8_t second, double duration) {
    const bool by_parameter = stretch_.by_parameter(element_);
    const double per_length = by_parameter ? 1 / stretch_.plan[element_].length : 1;
    builder_.add_piece({0, (at_.s - start_) * per_length, at_.v * per_length, a * per_length, j * per_length,
                        stretch_.element(element_), cause, by_parameter ? Law::parameter : law, second},
                       duration);
  }

  void move_to(const Motion1d& there) {
    constexpr double rounding = 1e-12;  // mm
    at_ = there;
    while (element_ + 1 < last_ && at_.s >= start_ + stretch_.plan[element_].length - rounding) {
      start_ += stretch_.plan[element_].length;
      ++element_;
    }
    at_.s = std::max(at_.s, start_);
  }

  TrajectoryBuilder& builder_;
  const Stretch& stretch_;
  std::size_t element_;
  std::size_t last_;
  Motion1d at_;       ///< s from the start of the first element
  double start_ = 0;  ///< of the element, likewise
};

Cause acceleration_cause(const SpanLimits& span) {
  return {span.acceleration.by_jerk ? CauseKind::axis_jerk : CauseKind::axis_acceleration,
          span.acceleration.axis};
}

/// Cause that limits the rise of the acceleration; where it may jump, that of the acceleration itself.
Cause jerk_cause(const SpanLimits& span) {
  return span.jerk.axis < 0 ? acceleration_cause(span) : Cause{CauseKind::axis_jerk, span.jerk.axis};
}

/// True if three phases raise or lower the speed symmetrically, from zero acceleration to zero.
bool is_ramp(std::span<const Phase, 3> phases, double acceleration) {
  constexpr double rounding = 1e-12;
  return acceleration == 0 && phases[0].duration > 0 && phases[1].jerk == 0 &&
         phases[2].jerk == -phases[0].jerk &&
         std::abs(phases[2].duration - phases[0].duration) <= rounding * phases[0].duration;
}

}  // namespace

double add_profile(TrajectoryBuilder& builder, const Stretch& stretch, const SpeedProfile& profile,
                   const SpanLimits& span, std::size_t first, std::size_t last, Cause slower_place) {
  const Cause by_jerk = jerk_cause(span);
  const Cause by_acceleration = acceleration_cause(span);
  ProfileLayer layer(builder, stretch, first, last, {0, profile.v0, profile.a0});
  const auto add = [&](std::span<const Phase, 3> phases, double acceleration, bool slows) {
    const Cause outer = slows ? Cause{CauseKind::ramp_down} : by_jerk;
    const Cause inner = slows ? outer : by_acceleration;
    const std::uint8_t second = code_of(slows ? slower_place : by_acceleration);
    if (is_ramp(phases, acceleration) && layer.all_by_length()) {
      layer.add_ramp(phases, outer, second);
      return;
    }
    for (int i = 0; i < 3; ++i) {
      layer.add(phases[static_cast<std::size_t>(i)], i == 1 ? inner : outer,
                slows ? second : Piece::no_cause);
    }
  };
  const std::span phases(profile.phases);
  add(phases.subspan<0, 3>(), profile.a0, profile.peak < profile.v0);
  layer.add_cruise(profile.phases[3].duration);
  add(phases.subspan<4, 3>(), 0, true);
  return layer.speed();
}

void add_planned_motion(TrajectoryBuilder& builder, const Stretch& stretch,
                        const std::vector<PlanNode>& nodes, ProgressSteps& steps) {
  double speed = 0;
  Cause gained;  // cause of the ramp before
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const std::size_t first = nodes[n].junction;
    const std::size_t last = nodes[n + 1].junction;
    steps.at(builder.path().segment(stretch.element(first)));
    if (last == first + 1 && stretch.is_level(first)) {
      const SpeedBound limit = stretch.plan[first].speed();
      const bool below = speed < limit.value * (1 - 1e-9);
      const bool slows_next = n + 2 < nodes.size() && nodes[n + 2].speed < speed;
      const Cause held = slows_next ? Cause{CauseKind::ramp_down} : gained;
      builder.add_piece({0, 0, speed, 0, 0, stretch.element(first), below ? held : limit.cause,
                         Law::path_length, code_of(nodes[n + 1].cause)},
                        stretch.plan[first].length / speed);
      continue;
    }
    const SpanLimits span = span_limits(stretch.plan, first, last);
    gained = jerk_cause(span);
    speed = add_profile(builder, stretch, profile_to(nodes[n + 1].speed, span, speed, 0), span, first, last,
                        nodes[n + 1].cause);
  }
}

}  // namespace feedscope
