#pragma once

#include <optional>

#include "core/drives/arc_course.h"
#include "core/drives/blend_course.h"
#include "core/drives/set_span.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Set positions of a trajectory as polynomials in time, span by span.
///
/// Lines, blends by their own parameter, and filtered motion between two knots of its straight pulses are
/// exact; arcs are divided as in ArcCourse. Other curves, and filtered arcs, are polynomials of degree seven
/// with position, velocity, acceleration and jerk of both ends: filtered arcs are divided by a bound of their
/// eighth derivative, other curves until the error in the middle, where it is largest, is within `tolerance`.
class SetWalk {
 public:
  static constexpr double tolerance = 3e-9;  ///< [mm]

  /// Starts at `time`, clamped to the trajectory, which must outlive this [s].
  explicit SetWalk(const Trajectory& trajectory, double time = 0);

  bool done() const { return done_; }
  const SetSpan& span() const { return span_; }
  void next();

 private:
  void enter_part();
  void make_span();
  void make_line_span();
  void make_blend_span();
  void make_filtered_span();
  void make_settled_span(const CommandPart& turn, double at, double duration);
  void make_fitted_span();
  void meet(const Kinematics& from, const Kinematics& to, double duration);

  const Trajectory& trajectory_;
  PartWalk walk_;
  ElementCurve curve_;                    ///< of the part, unless it is filtered
  std::optional<std::uint32_t> element_;  ///< element of that curve
  std::optional<PartMotion> motion_;      ///< for parts on curves other than lines, arcs and blends
  std::optional<ArcCourse> arc_;          ///< for parts on an arc
  BlendCourse blend_{tolerance};          ///< for parts on a blend by path length
  FilterWalk pulses_;
  double from_ = 0;   ///< start of the span in the part [s]
  double guess_ = 0;  ///< duration to try first [s]
  Vec3 reached_ = Vec3::Zero();
  bool first_ = true;
  bool done_ = false;
  SetSpan span_;
};

}  // namespace feedscope
