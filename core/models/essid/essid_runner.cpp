#include "core/models/essid/essid_runner.h"

#include <algorithm>
#include <cmath>

#include "core/trajectory/curve_motion.h"

namespace feedscope {
namespace {

/// Blends that turn by more than this [rad] are level places of the plan: within a longer ramp, at an almost
/// constant speed, they would exceed the radial jerk share by more than 3.3 (0.66 of the axis).
constexpr double level_turn = 0.5;

CornerRule rule_at(const CornerPlace& place, CornerRule rule) {
  rule.tolerance = place.tolerance;
  return rule;
}

CornerPiece lay_blend(const CornerPlace& place, const Corner& corner, double alpha,
                      const GentleBlendLength& gentle) {
  const double h = (place.out - place.in).squaredNorm() / 2;  // 1 - cos of the turn
  const auto over_transition = gentle.over_transition(h);
  const double length =
      over_transition ? corner.transition * *over_transition
                      : corner_blend(place.point, place.in, place.out, corner.transition, alpha).length();
  return {ElementKind::blend, corner.transition, length, {}};
}

}  // namespace

CornerPiece lay_blend(const CornerPlace& place, const CornerRule& rule, const GentleBlendLength& gentle) {
  return lay_blend(place, lay_corner(place.in, place.out, place.longest, rule_at(place, rule)), rule.alpha,
                   gentle);
}

EssidRunner::EssidRunner(const Toolpath& toolpath, const AxisVectors& axes, const EssidSettings& settings,
                         const PathRules& rules, const CompressorSettings& compressor,
                         TrajectoryBuilder& builder)
    : toolpath_(toolpath),
      gentle_length_(settings.corner.alpha),
      axes_(axes),
      blend_limits_(axes, settings.radial_acceleration_share, settings.radial_jerk_share),
      settings_(settings),
      rules_(rules),
      compressor_(toolpath, rules, compressor),
      builder_(builder) {}

void EssidRunner::run(const StretchRange& range, ProgressSteps& steps) {
  lay_path(range);
  follow_acceleration_mode(stretch_, builder_.path(), rules_, settings_.period);
  move_over_curves(builder_, stretch_, axes_, [&] { plan_and_move(range, steps); });
}

void EssidRunner::plan_and_move(const StretchRange& range, ProgressSteps& steps) {
  stretch_.level.clear();
  set_junction_ceilings(stretch_, builder_.path(), axes_.jerk, settings_.period, settings_.lookahead);
  part_turning(stretch_, builder_.path());
  if (settings_.reading == EssidReading::strict) {
    const auto ramps = [&](std::size_t e) { return parameter_ramps(blend_of(e).shape, blend_limits_); };
    move(plan_over_blends(stretch_, ramps, [&] { steps.at(range.first); }), steps);
    return;
  }
  hold_level_blends();
  move(plan_nodes(stretch_.plan, stretch_.ceiling, stretch_.held()), steps);
}

void EssidRunner::lay_path(const StretchRange& range) {
  turns_much_.clear();
  lay_blended_stretch(toolpath_, range, axes_, rules_, compressor_, builder_, stretch_,
                      [&](const CornerPlace& place) { return blend_corner(place, range); });
  stretch_.blends_by_parameter = settings_.reading == EssidReading::strict;
  for (std::size_t e = 0; e < stretch_.plan.size(); ++e) {
    if (stretch_.by_parameter(e)) {
      stretch_.plan[e].length = blend_of(e).shape.at(0).sigma;
    }
  }
}

CornerPiece EssidRunner::blend_corner(const CornerPlace& place, const StretchRange& range) {
  const Corner corner = lay_corner(place.in, place.out, place.longest, rule_at(place, settings_.corner));
  const BlendShape shape(place.in, place.out, corner.transition, settings_.corner.alpha);
  CornerPiece piece = lay_blend(place, corner, settings_.corner.alpha, gentle_length_);

  SpeedBound speed = entry_speed_limit(shape.at(0), place.feed, blend_limits_);
  turns_much_.push_back(corner.turn > level_turn ? 1 : 0);
  if (settings_.reading == EssidReading::strict) {
    speed = steady_speed_limit(shape, place.feed, blend_limits_);
  } else if (corner.turn > sharp_turn) {
    const SpeedBound steady = steady_speed_limit(shape, place.feed, blend_limits_);
    speed.lower(steady.value, steady.cause);
  }
  piece.limits = blend_motion_limits(shape, speed, place.feed.value, blend_limits_);
  if (!toolpath_.segment_turns.empty() && corner.turn > level_turn) {
    hold_turns_by_parameter(shape, place.segment, range, piece);
  }
  return piece;
}

/// A level blend may be run at constant du/dt, where the speed changes by itself, within the acceleration
/// that rotary axes allow.
void EssidRunner::hold_turns_by_parameter(const BlendShape& shape, std::size_t segment,
                                          const StretchRange& range, CornerPiece& piece) const {
  constexpr int places = 16;
  const double sigma = shape.at(0).sigma;
  double change = 0;  // of the speed, per square of the entry speed [1/mm]
  for (int i = 0; i <= places; ++i) {
    change = std::max(change, std::abs(shape.at(static_cast<double>(i) / places).dsigma) / (sigma * sigma));
  }
  const AxisBound free{HUGE_VAL, -1};
  const AxisBound held = with_turns_in_corner({{}, free, free}, toolpath_, segment, range.first, range.last,
                                              piece.transition, piece.length)
                             .acceleration;
  piece.limits.speed.lower(std::sqrt(held.value / change),
                           {held.by_jerk ? CauseKind::axis_jerk : CauseKind::axis_acceleration, held.axis});
}

EssidRunner::Blend EssidRunner::blend_of(std::size_t element) const {
  const BlendedPath& path = builder_.path();
  const std::size_t segment = path.segment(stretch_.element(element));
  const Vec3 in = toolpath_.tangent_at_end(segment);
  const Vec3 out = toolpath_.tangent_at_start(segment + 1);
  const double transition = path.corner_transition(path.index(stretch_.element(element)));
  const SpeedBound feed = corner_ceiling(toolpath_, segment, axes_.velocity);
  return {BlendShape(in, out, transition, settings_.corner.alpha), feed, turn_angle(in, out)};
}

void EssidRunner::hold_level_blends() {
  std::size_t blend = 0;
  for (std::uint32_t e = 0; e < stretch_.plan.size(); ++e) {
    if (is_blend(e) && turns_much_[blend++] != 0) {
      stretch_.hold_level(e);
    }
  }
}

void EssidRunner::move(const std::vector<PlanNode>& nodes, ProgressSteps& steps) {
  constexpr std::size_t reserve_each = 4096;  // nodes
  std::size_t next_reserve = reserve_each;
  speed_ = 0;
  for (std::size_t n = 0; n + 1 < nodes.size();) {
    const std::size_t first = nodes[n].junction;
    steps.at(builder_.path().segment(stretch_.element(first)));
    if (n >= next_reserve) {
      builder_.reserve_for_path(4 * reserve_each, stretch_.element(first));
      next_reserve += reserve_each;
    }
    if (is_blend(first)) {
      if (const auto reached = move_over_blend(nodes, n)) {
        n = *reached;
        continue;
      }
      if (stretch_.is_level(first)) {
        pass_level(first);
        ++n;
        continue;
      }
    }
    const std::size_t last = nodes[n + 1].junction;
    const SpanLimits span = span_limits(stretch_.plan, first, last);
    speed_ = add_profile(builder_, stretch_, profile_to(nodes[n + 1].speed, span, speed_, 0), span, first,
                         last, nodes[n + 1].cause);
    ++n;
  }
}

std::optional<std::size_t> EssidRunner::move_over_blend(const std::vector<PlanNode>& nodes, std::size_t n) {
  const std::size_t e = nodes[n].junction;
  if (settings_.reading == EssidReading::strict) {
    return std::nullopt;
  }
  const Blend blend = blend_of(e);
  const std::size_t segment = builder_.path().segment(stretch_.element(e));
  const bool turns =
      toolpath_.segment_turn(segment) != nullptr || toolpath_.segment_turn(segment + 1) != nullptr;
  if (blend.turn > sharp_turn || turns) {  // the law does not cover rotary axes
    return std::nullopt;
  }
  std::size_t target = n + 1;
  // The node at the blend's end only repeats its entry speed: use a later one, unless another blend starts
  // there.
  if (nodes[target].junction == e + 1 && !is_blend(e + 1)) {
    ++target;
  }
  const std::size_t last = nodes[target].junction;
  const double end_speed = nodes[target].speed;
  const SpanLimits span = span_limits(stretch_.plan, e + 1, last);

  SpeedBound ceiling = blend.feed;
  ceiling.lower(last == e + 1 ? end_speed : reachable_speed(end_speed, span.length, span.ramp()),
                {CauseKind::ramp_down});
  constexpr double same = 1e-7;  // of a speed: a difference from rounding of the coordinates must not matter
  if (ceiling.value < speed_ * (1 - same)) {
    return std::nullopt;
  }
  ceiling.value = std::max(ceiling.value, speed_);
  if (ceiling.value <= speed_ * (1 + same) && keeps_rows_at(blend.shape, speed_, blend_limits_)) {
    return std::nullopt;  // nothing to gain
  }
  // The law is worth its samples if the second half of the blend gains some speed when used to accelerate. It
  // is meaningful if the parametric jerk required by constant speed alone hardly changes in a sample.
  constexpr double min_gain = 0.05;
  constexpr double min_samples = 40;
  const double time = stretch_.plan[e].length / speed_;
  const double samples = std::max(time / settings_.period, min_samples);
  const BlendShape::Point entry = blend.shape.at(0);
  const double steady_jerk = std::abs(entry.ddsigma) * std::pow(speed_ / entry.sigma, 3);
  const double jerk = axis_share(blend_limits_.tangential_jerk, blend.shape.largest_tangent()).value;
  if (jerk * time * time / 8 < min_gain * speed_ || 16 * steady_jerk > samples * jerk) {
    return std::nullopt;
  }
  const double period = time / samples;
  const double fastest = ceiling.value;
  constexpr double rounding = 1e-12;
  for (const double share : {1.0, 0.5, 0.0}) {
    if (share < 1 && fastest <= speed_ * (1 + rounding)) {
      break;  // the same ceiling again
    }
    ceiling.value = speed_ + share * (fastest - speed_);
    const BlendMotion motion = run_blend(blend.shape, speed_, ceiling, blend_limits_, period, fastest);
    if (!motion.complete) {
      continue;
    }
    const double carried = settings_.reading == EssidReading::published ? 0 : motion.exit_acceleration;
    if (last == e + 1) {  // the next blend begins without acceleration, eq 25
      if (motion.exit_speed > end_speed * (1 + same)) {
        continue;
      }
      add_blend_steps(motion.steps, e, nodes[target].cause);
      speed_ = motion.exit_speed;
      return target;
    }
    if (std::abs(carried) > span.acceleration.value) {
      continue;
    }
    const SpeedProfile profile = profile_to(end_speed, span, motion.exit_speed, carried);
    if (profile.feasible && first_too_fast(stretch_.plan, stretch_.ceiling, e + 1, last, profile) == last) {
      add_blend_steps(motion.steps, e, nodes[target].cause);
      speed_ = add_profile(builder_, stretch_, profile, span, e + 1, last, nodes[target].cause);
      return target;
    }
  }
  return std::nullopt;
}

void EssidRunner::pass_level(std::size_t element) {
  const Blend blend = blend_of(element);
  const Cause cause = stretch_.plan[element].speed().cause;
  if (settings_.reading != EssidReading::strict && keeps_rows_at(blend.shape, speed_, blend_limits_)) {
    builder_.add_piece({0, 0, speed_, 0, 0, stretch_.element(element), cause},
                       stretch_.plan[element].length / speed_);
  } else {
    const double du = speed_ / blend.shape.at(0).sigma;
    add_blend_steps({{1 / du, 0, du, 0, 0, cause}}, element, cause);
  }
}

void EssidRunner::add_blend_steps(const std::vector<BlendStep>& blend_steps, std::size_t element,
                                  Cause slower_place) {
  for (const BlendStep& step : blend_steps) {
    builder_.add_piece({0, step.u, step.du, step.ddu, step.dddu, stretch_.element(element), step.cause,
                        Law::parameter, static_cast<std::uint8_t>(cause_index(slower_place))},
                       step.duration);
  }
}

}  // namespace feedscope
