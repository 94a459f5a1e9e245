#include "core/analysis/circularity/circularity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/roots.h"

namespace feedscope {
namespace {

using Eigen::Vector2d;

/// Smallest and largest distance of the places from a centre [mm].
Bracket radii_about(std::span<const Vector2d> places, const Vector2d& center) {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const Vector2d& place : places) {
    const double squared = (place - center).squaredNorm();
    least = std::min(least, squared);
    largest = std::max(largest, squared);
  }
  return {std::sqrt(least), std::sqrt(largest)};
}

double separation(std::span<const Vector2d> places, const Vector2d& center) {
  const Bracket radii = radii_about(places, center);
  return radii.high - radii.low;
}

/// Centre of the circle with the least sum of squared radial distances: Gauss-Newton from the origin, whose
/// steps shrink with the deviation relative to the radius.
Vector2d squares_center(std::span<const Vector2d> places) {
  Vector2d center = Vector2d::Zero();
  double radius = 0;
  constexpr int steps = 20;
  for (int step = 0; step < steps; ++step) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Vector2d& place : places) {
      const Vector2d from_center = place - center;
      const double distance = from_center.norm();
      const Eigen::Vector3d row(from_center.x() / distance, from_center.y() / distance, 1);
      normal += row * row.transpose();
      right += row * (distance - radius);
    }
    const Eigen::Vector3d change = normal.ldlt().solve(right);
    center += change.head<2>();
    radius += change.z();
    if (change.norm() < 1e-13 * (1 + radius)) {
      break;
    }
  }
  return center;
}

/// The separation is, up to the square of the deviations over the radius, the largest minus the smallest of
/// linear functions of the centre, so it has a single valley: a golden-section search in one coordinate over
/// the results of one in the other.
Vector2d zone_center(std::span<const Vector2d> places, const Vector2d& near, double around) {
  constexpr double width = 1e-10;  // [mm]
  constexpr int steps = 80;
  const auto best_y = [&](double x) {
    return least_place({near.y() - around, near.y() + around}, width, steps, [&](double y) {
      return separation(places, {x, y});
    });
  };
  const Least x = least_place({near.x() - around, near.x() + around}, width, steps,
                              [&](double at) { return best_y(at).value; });
  return {x.place.middle(), best_y(x.place.middle()).place.middle()};
}

}  // namespace

Circularity circularity_of(std::span<const Vector2d> places, double radius) {
  if (places.size() < 3) {
    throw std::invalid_argument("a circle needs three places");
  }
  Circularity result;
  const Bracket nominal = radii_about(places, Vector2d::Zero());
  result.largest = nominal.high - radius;
  result.smallest = nominal.low - radius;
  double sum = 0;
  for (const Vector2d& place : places) {
    sum += place.norm();
  }
  result.mean_radius = sum / static_cast<double>(places.size());
  result.squares_center = squares_center(places);
  result.by_squares = separation(places, result.squares_center);
  // A zone as narrow as that of the least squares has its centre within its width.
  const double around = std::max(result.by_squares, 1e-9);
  result.zone_center = zone_center(places, result.squares_center, around);
  result.zone = separation(places, result.zone_center);
  return result;
}

}  // namespace feedscope
