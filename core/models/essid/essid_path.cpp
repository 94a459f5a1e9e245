#include <algorithm>
#include <cmath>

#include "core/models/essid/essid_stretch.h"

namespace feedscope {
namespace {

/// Blends that turn by more than this [rad] are level places of the plan: run over within a longer ramp, at a
/// speed that hardly changes, they would exceed the radial jerk share by more than 3.3 (0.66 of the axis).
constexpr double level_turn = 0.5;

CornerRule rule_at(const CornerPlace& place, CornerRule rule) {
  rule.tolerance = place.tolerance;
  return rule;
}

CornerPiece lay_blend(const CornerPlace& place, const Corner& corner, double alpha) {
  const CubicBlend curve = corner_blend(place.point, place.in, place.out, corner.transition, alpha);
  return {ElementKind::blend, corner.transition, curve.length(), {}};
}

}  // namespace

CornerPiece lay_blend(const CornerPlace& place, const CornerRule& rule) {
  return lay_blend(place, lay_corner(place.in, place.out, place.longest, rule_at(place, rule)), rule.alpha);
}

EssidRunner::EssidRunner(const Toolpath& toolpath, const AxisVectors& axes, const EssidSettings& settings,
                         const PathRules& rules, TrajectoryBuilder& builder)
    : toolpath_(toolpath),
      axes_(axes),
      blend_limits_(axes, settings.radial_acceleration_share, settings.radial_jerk_share),
      settings_(settings),
      rules_(rules),
      builder_(builder) {}

void EssidRunner::run(const StretchRange& range, ProgressSteps& steps) {
  lay_path(range);
  follow_acceleration_mode(stretch_, builder_.path(), rules_, settings_.period);
  set_junction_ceilings(stretch_, builder_.path(), axes_.jerk, settings_.period, settings_.lookahead);
  if (settings_.reading == EssidReading::strict) {
    const auto ramps = [&](std::size_t e) { return parameter_ramps(blend_of(e).shape, blend_limits_); };
    move(plan_over_blends(stretch_, ramps), steps);
    return;
  }
  hold_level_blends();
  move(plan_nodes(stretch_.plan, stretch_.ceiling, stretch_.level), steps);
}

void EssidRunner::lay_path(const StretchRange& range) {
  blends_.clear();
  lay_blended_stretch(toolpath_, range, axes_, rules_, builder_, stretch_,
                      [&](const CornerPlace& place) { return blend_corner(place); });
  blend_index_.clear();
  std::int32_t next = 0;
  for (const std::uint8_t blend : stretch_.blend) {
    blend_index_.push_back(blend != 0 ? next++ : no_blend);
  }
  stretch_.blends_by_parameter = settings_.reading == EssidReading::strict;
  for (std::size_t e = 0; e < stretch_.plan.size(); ++e) {
    if (stretch_.by_parameter(e)) {
      stretch_.plan[e].length = blend_of(e).shape.at(0).sigma;
    }
  }
}

CornerPiece EssidRunner::blend_corner(const CornerPlace& place) {
  const Corner corner = lay_corner(place.in, place.out, place.longest, rule_at(place, settings_.corner));
  const BlendShape shape(place.in, place.out, corner.transition, settings_.corner.alpha);
  CornerPiece piece = lay_blend(place, corner, settings_.corner.alpha);

  SpeedBound speed = entry_speed_limit(shape.at(0), place.feed, blend_limits_);
  if (settings_.reading == EssidReading::strict) {
    speed = steady_speed_limit(shape, place.feed, blend_limits_);
  } else if (corner.turn > sharp_turn) {
    const SpeedBound steady = steady_speed_limit(shape, place.feed, blend_limits_);
    speed.lower(steady.value, steady.cause);
  }
  piece.limits = blend_motion_limits(shape, speed, place.feed.value, blend_limits_);
  blends_.push_back({shape, place.feed, corner.turn, piece.limits.jerk.value});
  return piece;
}

void EssidRunner::hold_level_blends() {
  for (std::uint32_t e = 0; e < stretch_.plan.size(); ++e) {
    if (blend_index_[e] != no_blend && blend_of(e).turn > level_turn) {
      stretch_.hold_level(e);
    }
  }
}

}  // namespace feedscope
