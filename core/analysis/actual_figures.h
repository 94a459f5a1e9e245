#pragma once

#include <cstdint>

#include "core/analysis/actual_path.h"

namespace feedscope {

/// The place where the axes are farthest from the programmed path.
struct ActualPlace {
  double error = 0;       ///< distance of the actual position from the nearest programmed point [mm]
  double of_control = 0;  ///< the same of the set position at that instant: what the control does [mm]
  double time = 0;        ///< [s]
  std::uint32_t line = 0;
  Vec3 position = Vec3::Zero();    ///< actual [mm]
  Vec3 programmed = Vec3::Zero();  ///< the nearest programmed point [mm]
};

/// What the drives make of a run.
struct ActualFigures {
  Vec3 largest_following_error = Vec3::Zero();  ///< by coordinate, absolute [mm]
  ActualPlace worst;                            ///< on cuts; rapids do not count
  double mean_contour_error = 0;                ///< over the time of the cuts [mm]
};

/// Largest values are narrowed down between the looks of SpanLooks; the mean is of their middles. Throws
/// Cancelled.
ActualFigures actual_figures(const ActualPath& path, Progress* progress = nullptr);

}  // namespace feedscope
