#pragma once

#include <vector>

#include "core/limits/segment_limits.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Turns the path of filtered motion into curves by path length, so that it can be run by another law:
/// its own is known by the time of the filters only, and there p' = p'' = 0 at every standstill.
///
/// Quintic polynomials (CourseSpan) meet position, tangent and curvature of the motion at their ends and are
/// halved until they stay within `error` of it in between. Elements end at standstills; is_stop() tells
/// whether the path has a kink there. Turning back within a nanometre counts as a standstill.
class FilteredPath {
 public:
  /// Largest distance of the curves from the motion [mm].
  static constexpr double usual_error = 1e-6;

  /// `run`: lines and arcs as filtered motion, dwells. `builder`, without any elements, receives those of the
  /// curves.
  FilteredPath(const Trajectory& run, const AxisVectors& axes, double error, TrajectoryBuilder& builder)
      : run_(run), min_acceleration_(axes.acceleration.minCoeff()), error_(error), builder_(builder) {}

  /// Throws InputError if the motion turns so often that the curves would fill the memory.
  void lay();

 private:
  /// The motion at one time.
  struct Place {
    double time = 0;  ///< from the start of the motion [s]
    CourseKnot knot;  ///< at a standstill without direction; s is not used
    bool stands = false;
    double turn_rate = 0;  ///< [rad/s]
  };

  void begin_motion(const FilteredMotion& motion);
  /// Follows the motion of one element up to shortly before `to` [s].
  void follow(double from, double to);
  void follow_to(double time);
  /// Ends the current element at the motion's place at `time`, if it is long enough or at rest.
  void end_block(double time, bool at_rest);
  void end_element();
  void fit_to(const Place& to, int depth);
  /// True if the curve from the last place to that of `time` follows the motion at three places.
  bool is_close(CourseKnot from, const Place& middle, CourseKnot to, double time);
  void put(const Place& place);
  Place place_at(double t);

  const Trajectory& run_;
  double min_acceleration_;
  double error_;
  TrajectoryBuilder& builder_;
  FilterWalk walk_;
  const FilteredMotion* motion_ = nullptr;
  std::uint32_t block_ = 0;
  double feed_ = 0;  ///< programmed [mm/s]
  std::size_t curves_ = 0;
  Place last_;                     ///< where the last curve ends
  Place before_;                   ///< start of that curve
  std::vector<CourseKnot> knots_;  ///< of the current element
};

}  // namespace feedscope
