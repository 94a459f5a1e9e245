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

/// Ramps over one blend in four steps of rising speed: the faster, the more of the axes turning takes and the
/// less is left for ramps. At most at the speed of the last one; above it a blend is passed at one speed.
using BlendRamps = std::array<BlendRamp, 4>;

/// Speed of step `step` of a blend that could be passed at one speed of min(turning, ramping) [mm/s]:
/// `turning` is what limits set that ramps do not share, `ramping` what those set that they do, and of the
/// latter a part is always left.
double blend_ramp_speed(std::size_t step, double turning, double ramping);

/// The ramps over blend `e` of a stretch.
using RampsOfBlend = std::function<BlendRamps(std::size_t e)>;

/// Plans a stretch whose blends are passed at one speed each, except where they follow each other so closely
/// that the tool would never get going: there ramps run over them.
///
///       line      |blend|   line  |blend|blend|..|blend|    line
///     -----------o=======o-------o=======x=====x==x=====o---------     o a node, without acceleration
///       ramps      level    ramps   one speed for all of them, or a ramp over many
///
/// Blends that touch, and short lines between blends on which a ramp of their own would gain less speed than
/// one over line and blends together, make a chain. Its blends begin with their first step of ramps; those
/// that the plan passes faster are given the next one, and at last are level, until the plan keeps all
/// speeds. All other blends are level from the start. Neighbours of different steps are parted by a node.
/// Ramps run over the short lines of a chain too, else over its blends only, where that is faster than all
/// blends level: they never make a stretch slower.
///
/// `stretch`: limits of blends are those at one speed; this function sets those of the plan it returns, and
/// the levels. Cost: one plan, of a stretch that holds a chain three to five; before each `stop` is called,
/// which throws Cancelled if there is to be none.
std::vector<PlanNode> plan_over_blends(Stretch& stretch, const RampsOfBlend& ramps,
                                       const std::function<void()>& stop);

}  // namespace feedscope
