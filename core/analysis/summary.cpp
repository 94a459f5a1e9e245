#include "core/analysis/summary.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "core/analysis/programmed_time.h"
#include "core/base/exact_sum.h"
#include "core/base/parallel.h"
#include "core/toolpath/gentle_blend.h"
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
    } else if (const GentleBlend* blend = gentle_blend(part, kind, motion.curve())) {
      add_samples(part, motion.curve(), [&](double tau) {
        const LawPoint law = law_at(part, tau);
        add(law.v, kinematics_of(blend->at(law.q), law));
      });
    } else {
      add_samples(part, motion.curve(), [&](double tau) {
        const Kinematics at = motion.kinematics(tau);
        add(at.velocity.norm(), at);
      });
    }
  }

  void add(const Peaks& other) {
    speed_ = std::max(speed_, other.speed_);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      axes_[i].velocity = std::max(axes_[i].velocity, other.axes_[i].velocity);
      axes_[i].acceleration = std::max(axes_[i].acceleration, other.axes_[i].acceleration);
      axes_[i].jerk = std::max(axes_[i].jerk, other.axes_[i].jerk);
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

  /// Of a part that runs along one by its length; else null. Kept for the next part along the same one.
  const GentleBlend* gentle_blend(const Part& part, ElementKind kind, const ElementCurve& curve) {
    if (kind != ElementKind::blend || part.law != Law::path_length) {
      return nullptr;
    }
    if (part.element != gentle_element_) {
      gentle_element_ = part.element;
      gentle_ = GentleBlend::of(curve.blend, curve.length);
    }
    return gentle_ ? &*gentle_ : nullptr;
  }

  /// `add_at`: adds the motion so long after the beginning of the part [s].
  template <typename AddAt>
  void add_samples(const Part& part, const ElementCurve& curve, const AddAt& add_at) {
    const int count = samples(part, curve);
    for (int i = 0; i <= count; ++i) {
      add_at(part.duration * i / count);
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

  void add(double speed, const Kinematics& at) {
    add(speed, at.velocity.cwiseAbs(), at.acceleration.cwiseAbs(), at.jerk.cwiseAbs());
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
  std::optional<GentleBlend> gentle_;
  std::uint32_t gentle_element_ = std::numeric_limits<std::uint32_t>::max();
  double speed_ = 0;
  AxisVector<AxisPeaks> axes_;
};

/// What the pieces of a trajectory add up to.
class Totals {
 public:
  explicit Totals(const Trajectory& trajectory)
      : trajectory_(trajectory),
        peaks_(trajectory),
        by_cause_(all_causes().size()),
        by_slower_place_(all_causes().size()) {}

  /// Of pieces [first, last).
  void add_pieces(std::size_t first, std::size_t last) {
    for (PartWalk walk(trajectory_, first); !walk.done() && walk.part().piece < last; walk.next()) {
      const Part& part = walk.part();
      by_cause_[cause_index(part.cause)].add(part.duration);
      if (part.cause.kind == CauseKind::ramp_down) {
        by_slower_place_[cause_index(trajectory_.slower_place(part.piece))].add(part.duration);
      }
      if (trajectory_.path().kind(part.element) == ElementKind::dwell) {
        waiting_.add(part.duration);
      }
      peaks_.add_part(part, walk.motion());
    }
  }

  void add(const Totals& other) {
    peaks_.add(other.peaks_);
    for (std::size_t i = 0; i < by_cause_.size(); ++i) {
      by_cause_[i].add(other.by_cause_[i]);
      by_slower_place_[i].add(other.by_slower_place_[i]);
    }
    waiting_.add(other.waiting_);
  }

  const Peaks& peaks() const { return peaks_; }
  double waiting() const { return waiting_.value(); }  ///< [s]
  std::vector<double> time_by_cause() const { return times(by_cause_); }
  std::vector<double> time_by_slower_place() const { return times(by_slower_place_); }

 private:
  std::vector<double> times(const std::vector<ExactSum>& sums) const {
    const double rounding = 1e-14 * trajectory_.duration();  // what pieces leave that end where others begin
    std::vector<double> seconds;
    for (const ExactSum& sum : sums) {
      seconds.push_back(sum.value() < rounding ? 0 : sum.value());
    }
    return seconds;
  }

  const Trajectory& trajectory_;
  Peaks peaks_;
  std::vector<ExactSum> by_cause_;
  std::vector<ExactSum> by_slower_place_;
  ExactSum waiting_;
};

/// The pieces in runs of a length that does not depend on the number of processors, on all of them; `also` is
/// called meanwhile.
Totals totals_of(const Trajectory& trajectory, const std::function<void()>& also) {
  constexpr std::size_t pieces_a_run = 16384;
  const std::size_t pieces = trajectory.pieces().size();
  const std::size_t runs = (pieces + pieces_a_run - 1) / pieces_a_run;
  std::vector<Totals> totals(std::max<std::size_t>(runs, 1), Totals(trajectory));
  in_parallel(runs + 1, [&](std::size_t i) {
    if (i == 0) {
      also();
    } else {
      totals[i - 1].add_pieces((i - 1) * pieces_a_run, std::min(i * pieces_a_run, pieces));
    }
  });
  Totals sum = totals.front();
  for (std::size_t i = 1; i < runs; ++i) {
    sum.add(totals[i]);
  }
  return sum;
}

}  // namespace

Summary summarise(const Trajectory& trajectory, const Toolpath& toolpath, const Vec3& rapid_speed) {
  Summary summary;
  summary.cycle_time = trajectory.duration();
  summary.programmed_time = programmed_time(toolpath, rapid_speed);
  summary.not_counted = not_counted(toolpath);

  ContourErrors errors;
  const Totals totals = totals_of(trajectory, [&] {
    ContourRequest worst;
    worst.places = 1;
    errors = contour_errors(trajectory, worst);
  });
  summary.time_by_cause = totals.time_by_cause();
  summary.time_by_slower_place = totals.time_by_slower_place();
  summary.max_contour_error = errors.largest;
  summary.cutting_contour_error = cutting_contour_error(trajectory, errors);
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
  const double moving = summary.cycle_time - totals.waiting();
  summary.mean_feed = moving > 0 ? trajectory.path_length() / moving : 0;
  summary.peak_feed = totals.peaks().speed();
  summary.axes = totals.peaks().axes();
  return summary;
}

}  // namespace feedscope
