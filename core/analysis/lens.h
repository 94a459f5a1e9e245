#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/programmed_place.h"
#include "core/analysis/run.h"

namespace feedscope {

/// A place of the lens: along the programmed direction and across it from the centre [mm].
using LensPoint = Eigen::Vector2d;

/// A run through the lens.
struct LensRun {
  std::vector<LensPoint> path;  ///< executed, in order
  LensPoint cursor = LensPoint::Zero();
  double error = 0;          ///< at the cursor, from the nearest programmed point [mm]
  double largest_error = 0;  ///< within half of the lens's width around its centre [mm]
  double feed = 0;           ///< at the cursor [mm/s]
};

/// A small part of the plane of a corner, stretched across the programmed direction so that deviations of
/// runs are visible. An affine map: every point is where it is, seen in another scale.
struct Lens {
  Vec3 centre = Vec3::Zero();   ///< programmed: the corner, or the place itself [mm]
  Vec3 along = Vec3::UnitX();   ///< unit tangent of the programmed path, before a corner
  Vec3 across = Vec3::UnitY();  ///< unit; to this side the corner opens
  std::uint32_t line = 0;       ///< source line of the block that ends at the corner, or is under way
  double width = 0;             ///< along [mm]
  double height = 0;            ///< across [mm]
  double tolerance = 0;         ///< contour tolerance in force in the run that is shown; 0: none [mm]
  std::vector<std::vector<LensPoint>> programmed;  ///< without gaps each
  std::vector<LensRun> runs;
  bool deviates = false;  ///< one of the runs leaves the programmed path there, by least_deviation or more

  double stretch() const { return width / height; }
  LensPoint seen(const Vec3& position) const {
    return {(position - centre).dot(along), (position - centre).dot(across)};
  }
};

/// Less is rounding [mm].
inline constexpr double least_deviation = 1e-6;

/// Runs of one program near the place where `runs[shown]` is at `time` [s].
///
/// The centre is the nearest corner that is within the lens, or else the programmed place. The longest
/// rounding of the corner takes two thirds of the width, the largest deviation a third of the height. A run
/// has a path. Cost in the order of the logarithm of the run.
Lens lens_at(std::span<const Run* const> runs, std::size_t shown, double time);

/// Where the lens shows a line of the program: the sharpest corner at which a block of it ends, or where
/// there is none, the middle of its first block [s]. None where the line moves nothing.
std::optional<double> lens_time(const Run& run, std::uint32_t line);

}  // namespace feedscope
