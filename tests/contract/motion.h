#pragma once

#include <vector>

#include "core/trajectory/part_walk.h"

namespace feedscope::contract {

/// What kind of place of the path a part of a motion is on.
enum class Place : std::uint8_t { line, arc, blend, curve, dwell };

/// A part of a motion on one path element with one law; its duration reaches to the next one.
struct Part {
  std::size_t number = 0;
  double time = 0;      ///< [s]
  double duration = 0;  ///< [s]
  std::uint32_t element = 0;
  std::uint32_t segment = 0;  ///< of the programmed path; of a blend the one that ends at its corner
  Place place = Place::line;
};

/// A trajectory as the checks see it: the one place that knows how it is stored.
class Motion {
 public:
  Motion(const Toolpath& toolpath, const Trajectory& run);

  const Toolpath& toolpath() const { return toolpath_; }
  const Trajectory& run() const { return run_; }
  const std::vector<Part>& parts() const { return parts_; }
  /// At `share` of the part's duration; at 0 and 1 its own limits, not those of its neighbours.
  State at(const Part& part, double share) const;
  /// The same without the path length, which costs a quadrature.
  Kinematics kinematics(const Part& part, double share) const;
  /// Position at a time of the whole run [s], [mm].
  Vec3 position(double time) const;
  /// First part on segment `segment` or behind it; parts().size() if there is none.
  std::size_t first_part_of(std::size_t segment) const;
  /// Path length at the start of a part's element [mm].
  double element_start(const Part& part) const;
  /// Size of the coordinates that its positions are computed from, which says how they are rounded [mm].
  double size(const Part& part) const;
  double length(const Part& part) const;  ///< of its element [mm]
  /// Whether the path is one that filters drew: it passes a point while many blocks later may be under way.
  bool lags() const;
  /// Shares of its duration between which it follows one law on one curve, 0 and 1 among them; filters and
  /// the knots of a fitted course change that within a part.
  std::vector<double> law_borders(const Part& part) const;
  /// Shortest time in which its law may change its character: a filter's length; else its duration [s].
  double time_scale(const Part& part) const;
  /// Fastest turn that its law may hold [rad/s]; 0: nothing but polynomials and its own arc.
  double turn_rate(const Part& part) const;
  /// How far the filters reach: what happens this long before counts as well; 0 without filters [s].
  double memory(const Part& part) const;
  /// Largest speed that its states are computed from; 0: nothing beyond its own [mm/s].
  double commanded_speed(const Part& part) const;
  /// What rounding may be on a velocity from filters, a difference of integrals over many filter times
  /// (filter_walk.h) [mm/s].
  double velocity_rounding(const Part& part) const;

 private:
  const FilteredMotion* filtered(const Part& part) const;  ///< nullptr: not filtered

  const Toolpath& toolpath_;
  const Trajectory& run_;
  mutable FilterWalk filters_;  ///< shared by instants near each other
  std::vector<feedscope::Part> laws_;
  std::vector<Part> parts_;
};

/// Whether every number of both is the same, bit by bit.
bool same_bits(const Trajectory& a, const Trajectory& b);

}  // namespace feedscope::contract
