#pragma once

#include <Eigen/Core>
#include <span>

namespace feedscope {

/// Deviations of a measured circle in its plane, by the definitions of ISO 230-4: radial distances from the
/// centre of the programmed circle, or of a fitted one.
struct Circularity {
  double zone = 0;  ///< G: least radial separation of two concentric circles that enclose the path [mm]
  Eigen::Vector2d zone_center =
      Eigen::Vector2d::Zero();  ///< of these circles, from the programmed centre [mm]
  double by_squares = 0;        ///< separation about the centre of the least-squares circle [mm]
  Eigen::Vector2d squares_center = Eigen::Vector2d::Zero();  ///< [mm]
  double largest = 0;      ///< F_max: largest deviation from the nominal radius at the programmed centre [mm]
  double smallest = 0;     ///< F_min: smallest deviation, negative inside the nominal circle [mm]
  double mean_radius = 0;  ///< about the programmed centre [mm]
};

/// Evaluates places of a circle, relative to its programmed centre, in any order; `radius`: nominal [mm]. The
/// minimum zone is accurate to 1e-9 mm. Throws std::invalid_argument for fewer than three places.
Circularity circularity_of(std::span<const Eigen::Vector2d> places, double radius);

}  // namespace feedscope
