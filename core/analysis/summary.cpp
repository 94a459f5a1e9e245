#include "core/analysis/summary.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/programmed_time.h"
#include "core/base/exact_sum.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

// A peak between two samples of an arc is missed by 5e-5 at most. On a blend every axis is a polynomial of
// the parameter; sampled by its length each sample costs an inversion.
constexpr double turn_per_sample = 0.02;          // rad of an arc
constexpr double blend_per_sample = 0.05;         // share of a blend's parameter range
constexpr double blend_length_per_sample = 0.25;  // share of a blend's length
constexpr double peak_spans_per_filter_time = 16;

/// Largest values over the pieces of a trajectory.
class Peaks {
 public:
  explicit Peaks(const Trajectory& trajectory) : trajectory_(trajectory) {}

  void add_part(const Part& part, const PartMotion& motion) {
    const ElementKind kind = trajectory_.path().kind(part.element);
    if (kind == ElementKind::dwell) {
      return;
    }
    if (kind == ElementKind::line) {
      add_straight(part, motion.curve().direction);
    } else {
      add_curved(part, motion);
    }
  }

  double speed() const { return speed_; }
  const AxisVector<AxisPeaks>& axes() const { return axes_; }

 private:
  /// On a straight line every extreme is one of a polynomial, on each axis at the same time.
  void add_straight(const Part& part, const Vec3& direction) {
    const double duration = part.duration;
    const double end_acceleration = part.a + part.j * duration;
    const double end_speed = part.v + duration * (part.a + part.j * duration / 2);
    double speed = std::max(std::abs(part.v), std::abs(end_speed));
    const double extreme = part.j != 0 ? -part.a / part.j : -1;
    if (extreme > 0 && extreme < duration) {
      speed = std::max(speed, std::abs(part.v + part.a * extreme / 2));
    }
    add(speed, direction.cwiseAbs() * speed,
        direction.cwiseAbs() * std::max(std::abs(part.a), std::abs(end_acceleration)),
        direction.cwiseAbs() * std::abs(part.j));
  }

  void add_curved(const Part& part, const PartMotion& motion) {
    const int count = samples(part, motion.curve());
    for (int i = 0; i <= count; ++i) {
      const Kinematics at = motion.kinematics(part.duration * i / count);
      add(at.velocity.norm(), at.velocity.cwiseAbs(), at.acceleration.cwiseAbs(), at.jerk.cwiseAbs());
    }
  }

  int samples(const Part& part, const ElementCurve& curve) const {
    if (part.law == Law::filtered) {
      return trajectory_.filtered_spans(part, peak_spans_per_filter_time);
    }
    const double travel = advance({0, part.v, part.a, part.j}, part.duration).q;
    double share = travel / blend_per_sample;
    if (curve.is_arc()) {
      share = travel / curve.arc.length_per_radian() / turn_per_sample;
    } else if (part.law == Law::path_length) {
      share = travel / curve.length / blend_length_per_sample;
    }
    return 1 + static_cast<int>(std::clamp(share, 0.0, 1e6));
  }

  void add(double speed, const Vec3& velocity, const Vec3& acceleration, const Vec3& jerk) {
    speed_ = std::max(speed_, speed);
    for (std::size_t axis = 0; axis < coordinate_names.size(); ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      axes_[axis].velocity = std::max(axes_[axis].velocity, velocity[i]);
      axes_[axis].acceleration = std::max(axes_[axis].acceleration, acceleration[i]);
      axes_[axis].jerk = std::max(axes_[axis].jerk, jerk[i]);
    }
  }

  const Trajectory& trajectory_;
  double speed_ = 0;
  AxisVector<AxisPeaks> axes_;
};

}  // namespace

Summary summarise(const Trajectory& trajectory, const Toolpath& toolpath, const Vec3& rapid_speed) {
  Summary summary;
  summary.cycle_time = trajectory.duration();
  summary.programmed_time = programmed_time(toolpath, rapid_speed);
  summary.not_counted = not_counted(toolpath);

  Peaks peaks(trajectory);
  std::vector<ExactSum> by_cause(all_causes().size());
  std::vector<ExactSum> by_slower_place(all_causes().size());
  ExactSum waiting;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    by_cause[cause_index(part.cause)].add(part.duration);
    if (part.cause.kind == CauseKind::ramp_down) {
      by_slower_place[cause_index(trajectory.slower_place(part.piece))].add(part.duration);
    }
    if (trajectory.path().kind(part.element) == ElementKind::dwell) {
      waiting.add(part.duration);
    }
    peaks.add_part(part, walk.motion());
  }
  const double rounding = 1e-14 * summary.cycle_time;  // what pieces leave that end where others begin
  const auto times = [rounding](const std::vector<ExactSum>& sums) {
    std::vector<double> seconds;
    for (const ExactSum& sum : sums) {
      seconds.push_back(sum.value() < rounding ? 0 : sum.value());
    }
    return seconds;
  };
  summary.time_by_slower_place = times(by_slower_place);
  summary.time_by_cause = times(by_cause);
  ContourRequest worst;
  worst.places = 1;
  const ContourErrors errors = contour_errors(trajectory, worst);
  summary.max_contour_error = errors.largest;
  if (!errors.worst.empty()) {
    summary.worst_place = errors.worst.front();
  }
  summary.max_corner_distance = trajectory.compaction_error();
  for (const FilteredMotion& motion : trajectory.motions()) {
    summary.max_corner_distance = std::max(summary.max_corner_distance, motion.contour_error());
  }
  for (std::size_t i = 0; i < trajectory.path().corner_count(); ++i) {
    summary.max_corner_distance = std::max(summary.max_corner_distance, trajectory.path().corner(i).epsilon);
  }
  const double moving = summary.cycle_time - waiting.value();
  summary.mean_feed = moving > 0 ? trajectory.path_length() / moving : 0;
  summary.peak_feed = peaks.speed();
  summary.axes = peaks.axes();
  return summary;
}

}  // namespace feedscope
