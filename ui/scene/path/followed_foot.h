#pragma once

#include <cmath>

#include "core/analysis/contour/path_deviation.h"

namespace feedscope::ui {

/// The programmed point next to the actual or recorded position, followed along the path from its start.
/// Where the path comes close to itself, the nearest point would jump from one pass to the other, which is
/// visible in enlarged deviations.
class FollowedFoot {
 public:
  explicit FollowedFoot(const Toolpath& toolpath) : toolpath_(toolpath), deviation_(toolpath) {}

  /// The motion restarts on `segment`.
  void begin(std::size_t segment) { last_ = {segment, 0, Vec3::Zero(), 0}; }
  /// `segment`: of the set position, `behind`: distance of the axes from it [mm].
  PathDeviation::Result at(const Vec3& position, std::size_t segment, double behind) {
    const double moved = (position - position_).norm();
    position_ = position;
    // A corner is cut by as much as the axes deviate from the path.
    const double reach = corner_reach * std::sqrt(last_.squared) + 2 * moved + rounding;
    PathDeviation::Foot best = deviation_.foot_on(last_.segment, position);
    double ahead = toolpath_.segments[last_.segment].length - last_.s;
    for (std::size_t next = last_.segment + 1; next <= segment && ahead <= reach; ++next) {
      if (const PathDeviation::Foot foot = deviation_.foot_on(next, position); foot.squared < best.squared) {
        best = foot;
      }
      ahead += toolpath_.segments[next].length;
    }
    if (std::sqrt(best.squared) > 2 * behind + lost) {
      best = deviation_.nearest(position, segment, last_.segment);
    }
    last_ = best;
    return deviation_.from_foot(best);
  }

 private:
  static constexpr double corner_reach = 4;
  static constexpr double rounding = 1e-6;  // [mm]
  static constexpr double lost = 0.1;       // [mm], more than controls deviate from the path within a corner

  const Toolpath& toolpath_;
  PathDeviation deviation_;
  PathDeviation::Foot last_;
  Vec3 position_ = Vec3::Zero();
};

}  // namespace feedscope::ui
