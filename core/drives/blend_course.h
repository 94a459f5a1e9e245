#pragma once

#include <array>

#include "core/drives/set_span.h"
#include "core/toolpath/curve.h"
#include "core/trajectory/piece.h"

namespace feedscope {

/// Set positions on cubic blends run by path length, as polynomials in time.
///
/// The parameter obeys u' = s'/|S'(u)|, where |S'|^2 is of fourth degree: the power series of u follows term
/// by term. Spans are polynomials of ninth degree with position and four derivatives of both ends. The
/// parameter at the end is that of the end of the blend, or found by Newton steps on a quadrature over the
/// span.
///
/// A span whose error in the middle, where it is largest, exceeds the tolerance is shortened; the number of
/// spans per blend is remembered for the next one.
class BlendCourse {
 public:
  /// `tolerance`: largest error of the spans [mm].
  explicit BlendCourse(double tolerance) : tolerance_(tolerance) {}

  /// Enters `part`, by path length on `blend` of `length` [mm].
  void enter(const CubicBlend& blend, double length, const Part& part);
  /// Sets `span` to the one that begins `from` after the start of the part [s]. Returns false if no span of
  /// any duration is accurate enough, as where the blend is nearly at a standstill.
  bool fill(SetSpan& span, double from);

 private:
  using Parameter = std::array<double, SetCourse::met + 1>;

  struct Place {
    double s = 0;                                      ///< path length from the start of the blend [mm]
    Parameter parameter;                               ///< u and its powers in time
    std::array<Vec3, SetCourse::met + 1> derivatives;  ///< of the position by time [mm/s^k]
  };

  bool is_reached(double s) const;
  Place place_at(double u, const LawPoint& law) const;
  /// Parameter of `law` at `h` [s] after `from`.
  double parameter_at(const LawPoint& law, const Place& from, double h) const;
  double speed_squared(double u) const;  ///< |S'|^2 [mm2]
  double length_between(double from, double to) const;
  double error_of(const SetSpan& span, const Place& start, double from) const;

  double tolerance_;
  double spans_ = 3;  ///< approximate number of spans per blend
  CubicBlend blend_;
  double length_ = 0;
  std::array<double, 5> squared_{};  ///< |S'|^2 by powers of u - 1/2 [mm2]
  Part part_;
  double duration_ = 0;  ///< of the next span to try [s]
  Place reached_;
};

}  // namespace feedscope
