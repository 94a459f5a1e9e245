#pragma once

#include <array>

#include "core/analysis/run/axis_peaks.h"
#include "core/machine/axis_vector.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Largest magnitudes of the motion of a trajectory, exact up to rounding. On lines, and between the knots of
/// straight pulses, from the roots of polynomials. Elsewhere a part is divided into spans in which a quantity
/// has at most one extreme: where its derivative changes sign, and the extreme may exceed the value so far,
/// the root of the derivative is narrowed down.
class PeakSearch {
 public:
  /// Adds a part of `trajectory`; fastest for parts in order.
  void add(const Trajectory& trajectory, const Part& part);
  void add(const PeakSearch& other);

  double speed() const { return largest_[speed_place]; }    ///< [mm/s]
  AxisVector<AxisPeaks> axes(bool with_jerk = true) const;  ///< without: jerks are NaN

 private:
  /// Velocity, acceleration, jerk and derivative of the jerk.
  using Rates = std::array<Vec3, 4>;
  struct Look {
    double time = 0;  ///< from the start of the part [s]
    Rates rates;
  };
  /// Indices of the quantities: velocity, acceleration and jerk of X, Y and Z, then the speed.
  static constexpr std::size_t axis_count = 3;
  static constexpr std::size_t speed_place = 3 * axis_count;

  /// Largest speed, acceleration and jerk along the path in a part.
  struct LawPeaks {
    double v = 0;  ///< [mm/s]
    double a = 0;  ///< [mm/s2]
    double j = 0;  ///< [mm/s3]
  };
  static LawPeaks peaks_of(const Part& part);
  bool is_known(const LawPeaks& law, const Arc& arc) const;

  void add_line(const Part& part, const Vec3& direction);
  void add_arc(const Part& part, const Arc& arc);
  void add_blend(const Part& part, const CubicBlend& blend);
  void add_blend_by_length(const Part& part, const ElementCurve& curve);
  void add_course(const Part& part, const CourseKnot& from, const CourseKnot& to);
  void add_filtered(const Part& part, const FilteredMotion& motion);
  void add_polynomial(const Rates& start, double duration);

  static double value(const Look& look, std::size_t quantity);
  static double slope(const Look& look, std::size_t quantity);
  /// Samples `rates_at` at an instant and updates the largest values.
  template <typename RatesAt>
  Look look(const RatesAt& rates_at, double time);
  /// Samples the ends of equal spans and searches between them, for the quantities from `first` on.
  template <typename RatesAt>
  void search(const RatesAt& rates_at, double from, double to, double spans, std::size_t first = 0);
  /// Samples the turning point of the feed.
  template <typename RatesAt>
  void look_at_turn(const RatesAt& rates_at, const Part& part, double from, double to);
  template <typename RatesAt>
  void search_span(const RatesAt& rates_at, const Look& from, const Look& to, std::size_t first = 0);
  template <typename RatesAt>
  void narrow(const RatesAt& rates_at, Look low, Look high, std::size_t quantity);

  std::array<double, speed_place + 1> largest_{};
  FilterWalk filters_;
};

}  // namespace feedscope
