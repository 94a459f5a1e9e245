#pragma once

#include "core/drives/set_span.h"
#include "core/toolpath/curve.h"
#include "core/trajectory/piece.h"

namespace feedscope {

/// Set positions on an arc or helix under constant jerk along it, as polynomials in time.
///
/// In the frame of the arc the rotating component is z = R exp(i phi) with a phase of third degree in time,
/// and z' = i phi' z gives each derivative from the previous ones. The error of a Taylor polynomial of degree
/// n about the start is at most R B_(n+1) h^(n+1)/(n+1)!, where B_k bounds |z^(k)|/R: the same sums with the
/// largest |phi'|, |phi''| and |phi'''|. Degree four or nine suffices for short parts. Longer ones are
/// divided into equal spans of degree nine with position and four derivatives of both ends; their error is at
/// most R B_10 (h/2)^10/10!, in the middle.
class ArcCourse {
 public:
  /// `part`: by path length on `arc`. The spans are within `tolerance` of it [mm].
  ArcCourse(const Arc& arc, const Part& part, double tolerance);

  double span_duration() const { return duration_; }  ///< of all spans in the part [s]
  /// Sets `span` to the one that begins `from` after the start of the part [s].
  void fill(SetSpan& span, double from) const;

 private:
  static constexpr std::size_t order = SetCourse::order;
  /// exp(i phi) and its derivatives by time.
  struct Turn {
    SetCourse::Derivatives re;
    SetCourse::Derivatives im;
  };
  using Phase = std::array<double, 4>;  ///< phi [rad] and its derivatives by time

  Phase phase_at(double tau) const;
  std::array<double, order + 2> bounds() const;
  static Turn turn(const Phase& phase, std::size_t highest);

  Arc arc_;
  Phase start_;
  double part_duration_;
  double duration_;
  std::size_t degree_ = order;
  bool meets_end_ = false;
};

}  // namespace feedscope
