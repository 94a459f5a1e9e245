#pragma once

#include "core/trajectory/part_walk.h"

namespace feedscope {

/// How far places are from the path that a run executes.
///
/// Looked for around the place of the run that stands for the same programmed one, twice as far along the
/// path as that is away: a pass beside it does not count, however near. Closed form on lines, Newton steps
/// on the slope of the squared distance elsewhere.
class NearestPlace {
 public:
  /// `trajectory` outlives this.
  explicit NearestPlace(const Trajectory& trajectory) : trajectory_(trajectory) {}

  /// Distance of `place` from the executed path [mm], looked for around `tau` after the start of `part` [s].
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
  double squared_ = 0;  ///< the least so far [mm2]
};

}  // namespace feedscope
