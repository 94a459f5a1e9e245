#pragma once

#include <array>
#include <optional>

#include "core/drives/drive_law.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Set positions over a short time, a polynomial for each coordinate.
struct SetSpan {
  double time = 0;      ///< start [s]
  double duration = 0;  ///< [s]
  std::array<SetCourse, 3> axes;
  Vec3 start = Vec3::Zero();  ///< [mm]
  /// The motion starts again here, at rest: at the start of the program, and behind a move whose way is not
  /// known.
  bool begins = false;

  double end() const { return time + duration; }  ///< [s]
};

/// The set positions of a trajectory as polynomials in time, one span after the other.
///
/// Lines, and filtered motion between two knots of its straight pulses, are exact; arcs and blends are cut
/// until a polynomial of degree seven, with position, velocity, acceleration and jerk of both ends, is within
/// `tolerance` of them in the middle, where it is farthest.
class SetWalk {
 public:
  static constexpr double tolerance = 1e-8;  ///< [mm]

  /// From `time` on, clamped to the trajectory, which must outlive this [s].
  explicit SetWalk(const Trajectory& trajectory, double time = 0);

  bool done() const { return done_; }
  const SetSpan& span() const { return span_; }
  void next();

 private:
  void enter_part();
  void make_span();
  void make_line_span();
  /// From `from` to `to` of the part. By how much the middle is off [mm].
  double fit(double from, double to);
  double end_of_pulse(double from);

  const Trajectory& trajectory_;
  PartWalk walk_;
  std::optional<PartMotion> motion_;
  FilterWalk knots_;
  double from_ = 0;   ///< where the span begins in the part [s]
  double guess_ = 0;  ///< duration to be tried first [s]
  Vec3 reached_ = Vec3::Zero();
  bool first_ = true;
  bool done_ = false;
  SetSpan span_;
};

}  // namespace feedscope
