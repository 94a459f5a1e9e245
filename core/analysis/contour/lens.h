#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/contour/programmed_place.h"
#include "core/analysis/run/run.h"

namespace feedscope {

/// A place in the lens: along and across the programmed direction, from the centre [mm].
using LensPoint = Eigen::Vector2d;

struct LensRun {
  std::vector<LensPoint> path;  ///< executed, in order
  LensPoint cursor = LensPoint::Zero();
  double error = 0;          ///< at the cursor, from the nearest programmed point [mm]
  double largest_error = 0;  ///< within half of the lens's width around its centre [mm]
  double feed = 0;           ///< at the cursor [mm/s]
};

/// A small part of the plane of a corner, stretched across the programmed direction to make deviations
/// visible. An affine map: positions are exact, only the scale differs.
struct Lens {
  Vec3 centre = Vec3::Zero();   ///< programmed: the corner, or the place without one [mm]
  Vec3 along = Vec3::UnitX();   ///< unit tangent of the programmed path, before a corner
  Vec3 across = Vec3::UnitY();  ///< unit; the corner opens to this side
  std::uint32_t line = 0;       ///< source line of the block that ends at the corner, or is under way
  double width = 0;             ///< along [mm]
  double height = 0;            ///< across [mm]
  double tolerance = 0;         ///< contour tolerance in force in the shown run; 0: none [mm]
  std::vector<std::vector<LensPoint>> programmed;  ///< continuous pieces
  std::vector<LensRun> runs;
  bool deviates = false;  ///< a run leaves the programmed path there by at least least_deviation

  /// How many times larger lengths across are than along, in a square picture.
  double stretch() const { return width / height; }
  LensPoint seen(const Vec3& position) const {
    return {(position - centre).dot(along), (position - centre).dot(across)};
  }
};

/// Smaller deviations are rounding [mm].
inline constexpr double least_deviation = 1e-6;

/// Runs of one program near the place of `runs[shown]` at `time` [s].
///
/// The centre is the nearest corner within the lens, else the programmed place. The longest rounding of the
/// corner takes two thirds of the width, the largest deviation a third of the height. Every run must have a
/// path. Logarithmic cost in the length of the run.
Lens lens_at(std::span<const Run* const> runs, std::size_t shown, double time);

/// Time for which the lens shows a line of the program: at the sharpest corner at which one of its blocks
/// ends, else in the middle of its first block [s]. None for a line without motion.
std::optional<double> lens_time(const Run& run, std::uint32_t line);

}  // namespace feedscope
