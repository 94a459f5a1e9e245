#pragma once

#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Distance of places from the executed path of a run.
///
/// Searched around the place of the run that corresponds to the same programmed one, along the path up to
/// twice their distance: a pass next to it does not count, however near. Closed form on lines, elsewhere
/// Newton steps on the slope of the squared distance.
class NearestPlace {
 public:
  /// `trajectory` outlives this.
  explicit NearestPlace(const Trajectory& trajectory) : trajectory_(trajectory) {}

  /// Distance of `place` from the executed path [mm], searched around `tau` after the start of `part` [s].
  double distance(const Vec3& place, const Part& part, double tau);

 private:
  struct Range {
    double low, high;
  };
  void try_element(std::uint32_t element, Range range);
  void try_filtered(const FilteredMotion& motion, Range range);
  void search_elements(std::uint32_t element, double at, double reach);
  template <typename Curve>
  void descend(const Curve& curve, double start, Range range);

  const Trajectory& trajectory_;
  FilterWalk filters_;
  Vec3 place_ = Vec3::Zero();
  double squared_ = 0;  ///< smallest so far [mm2]
};

}  // namespace feedscope
