#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/trajectory/stretch.h"

namespace feedscope {

/// Ramps over a corner blend that is passed no faster than `speed`.
struct BlendRamp {
  double speed = 0;        ///< [mm/s]
  AxisBound acceleration;  ///< along the path [mm/s2]
  AxisBound jerk;          ///< along the path [mm/s3]
};

/// Ramps over one blend in four steps of rising speed: the faster, the more of the axes turning uses and the
/// less is left for ramps. Above the speed of the last step a blend is passed at one speed.
using BlendRamps = std::array<BlendRamp, 4>;

/// Speed of step `step` of a blend that could be passed at one speed of min(turning, ramping) [mm/s].
/// `turning`: set by limits that ramps do not share; `ramping`: set by limits that they share, a part of
/// which is always left.
double blend_ramp_speed(std::size_t step, double turning, double ramping);

/// Returns the ramps over blend `e` of a stretch.
using RampsOfBlend = std::function<BlendRamps(std::size_t e)>;

/// Plans a stretch whose blends are passed at one speed each. Where they follow each other so closely that
/// the tool would never gain speed, ramps run over them.
///
///       line      |blend|   line  |blend|blend|..|blend|    line
///     -----------o=======o-------o=======x=====x==x=====o---------     o a node, without acceleration
///       ramps      level    ramps   one speed for all of them, or a ramp over many
///
/// Blends that touch make a chain, and so do short lines between blends if a ramp on the line alone gains
/// less speed than one over line and blends together. The blends of a chain begin with their first step of
/// ramps; those that the plan passes faster take the next one and are level at last, until the plan keeps all
/// speeds. All other blends are level from the start. A node separates neighbours of different steps. Ramps
/// run over the short lines of a chain too, else over its blends only, where that is faster than all blends
/// level: they never make a stretch slower.
///
/// `stretch`: limits of blends are those at one speed; this function sets those of the plan it returns, and
/// the levels. Cost: one plan; three to five for a stretch that contains a chain. Calls `stop` before each
/// plan; it throws Cancelled to prevent it.
std::vector<PlanNode> plan_over_blends(Stretch& stretch, const RampsOfBlend& ramps,
                                       const std::function<void()>& stop);

}  // namespace feedscope
