#pragma once

#include <cstdint>

#include "core/analysis/contour/actual_path.h"

namespace feedscope {

/// Place where the axes are farthest from the programmed path.
struct ActualPlace {
  double error = 0;       ///< distance of the actual position from the nearest programmed point [mm]
  double of_control = 0;  ///< same distance of the set position at that instant: the control's share [mm]
  double time = 0;        ///< [s]
  std::uint32_t line = 0;
  Vec3 position = Vec3::Zero();    ///< actual [mm]
  Vec3 programmed = Vec3::Zero();  ///< nearest programmed point [mm]
};

/// Largest deviations of the axes with their drives in a run.
struct ActualFigures {
  Vec3 largest_following_error = Vec3::Zero();  ///< by coordinate, absolute [mm]
  ActualPlace worst;                            ///< on cuts; rapids do not count
  double mean_contour_error = 0;                ///< over the time of the cuts [mm]
};

/// Searches the largest values between the samples of SpanLooks; the mean is taken at their midpoints. Throws
/// Cancelled.
ActualFigures actual_figures(const ActualPath& path, Progress* progress = nullptr);

}  // namespace feedscope
