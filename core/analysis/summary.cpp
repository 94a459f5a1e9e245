#include "core/analysis/summary.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

// A peak between two samples of an arc is missed by 5e-5 at most. On a blend every axis is a polynomial of
// the parameter; sampled by its length each sample costs an inversion.
constexpr double turn_per_sample = 0.02;          // rad of an arc
constexpr double blend_per_sample = 0.05;         // share of a blend's parameter range
constexpr double blend_length_per_sample = 0.25;  // share of a blend's length
constexpr double filtered_per_filter_time = 16;
constexpr int arc_time_samples = 64;

/// Sum with a running correction, so that a million small times add up as exactly as ten (Neumaier).
class ExactSum {
 public:
  void add(double x) {
    const double sum = sum_ + x;
    correction_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + correction_; }

 private:
  double sum_ = 0;
  double correction_ = 0;
};

/// Speed along `direction` (unit) at which the first axis reaches its rapid speed [mm/s].
double axes_speed(const Vec3& direction, const Vec3& rapid_speed) {
  double speed = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0) {
      speed = std::min(speed, rapid_speed[axis] / std::abs(direction[axis]));
    }
  }
  return speed;
}

double time_at_axes_speed(const Toolpath& toolpath, std::size_t index, const Vec3& rapid_speed) {
  const Segment& segment = toolpath.segments[index];
  if (segment.kind == SegmentKind::line) {
    return segment.length /
           axes_speed((segment.end - toolpath.start_of(index)) / segment.length, rapid_speed);
  }
  const Arc& arc = toolpath.arcs[static_cast<std::size_t>(segment.arc)];
  const double step = segment.length / arc_time_samples;
  double time = 0;
  for (int i = 0; i < arc_time_samples; ++i) {
    time += step / axes_speed(arc.at((i + 0.5) * step).d1.normalized(), rapid_speed);
  }
  return time;
}

double programmed_time(const Toolpath& toolpath, const Vec3& rapid_speed) {
  ExactSum time;
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    if (segment.kind == SegmentKind::dwell) {
      time.add(segment.dwell);
    } else if (!segment.rapid && segment.feed > 0) {
      time.add(segment.length / segment.feed);
    } else {
      time.add(time_at_axes_speed(toolpath, i, rapid_speed));
    }
  }
  return time.value();
}

/// Largest values over the pieces of a trajectory.
class Peaks {
 public:
  explicit Peaks(const Trajectory& trajectory) : trajectory_(trajectory) {}

  void add_piece(std::size_t index) {
    const Piece& piece = trajectory_.pieces()[index];
    const PathElement& element = trajectory_.path().elements[piece.element];
    const double duration = trajectory_.piece_end(index) - piece.time;
    if (element.kind == ElementKind::line) {
      add_straight(piece, (element.end - element.start) / element.length, duration);
    } else if (element.kind != ElementKind::dwell) {
      add_curved(index, samples(index, piece, element, duration), duration);
    }
  }

  double speed() const { return speed_; }
  const std::array<AxisPeaks, 3>& axes() const { return axes_; }

 private:
  /// On a straight line every extreme is one of a polynomial, on each axis at the same time.
  void add_straight(const Piece& piece, const Vec3& direction, double duration) {
    const double end_acceleration = piece.a + piece.j * duration;
    const double end_speed = piece.v + duration * (piece.a + piece.j * duration / 2);
    double speed = std::max(std::abs(piece.v), std::abs(end_speed));
    const double extreme = piece.j != 0 ? -piece.a / piece.j : -1;
    if (extreme > 0 && extreme < duration) {
      speed = std::max(speed, std::abs(piece.v + piece.a * extreme / 2));
    }
    add(speed, direction.cwiseAbs() * speed,
        direction.cwiseAbs() * std::max(std::abs(piece.a), std::abs(end_acceleration)),
        direction.cwiseAbs() * std::abs(piece.j));
  }

  void add_curved(std::size_t index, int count, double duration) {
    for (int i = 0; i <= count; ++i) {
      const Kinematics motion = trajectory_.kinematics_in_piece(index, duration * i / count);
      add(motion.velocity.norm(), motion.velocity.cwiseAbs(), motion.acceleration.cwiseAbs(),
          motion.jerk.cwiseAbs());
    }
  }

  int samples(std::size_t index, const Piece& piece, const PathElement& element, double duration) const {
    if (piece.law == Law::filtered) {
      return trajectory_.filtered_spans(index, filtered_per_filter_time);
    }
    const double travel = duration * (piece.v + duration * (piece.a / 2 + duration * piece.j / 6));
    double share = travel / blend_per_sample;
    if (element.kind == ElementKind::arc) {
      share = travel / trajectory_.path().arcs[element.geometry].length_per_radian() / turn_per_sample;
    } else if (piece.law == Law::path_length) {
      share = travel / element.length / blend_length_per_sample;
    }
    return 1 + static_cast<int>(std::clamp(share, 0.0, 1e6));
  }

  void add(double speed, const Vec3& velocity, const Vec3& acceleration, const Vec3& jerk) {
    speed_ = std::max(speed_, speed);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      axes_[axis].velocity = std::max(axes_[axis].velocity, velocity[i]);
      axes_[axis].acceleration = std::max(axes_[axis].acceleration, acceleration[i]);
      axes_[axis].jerk = std::max(axes_[axis].jerk, jerk[i]);
    }
  }

  const Trajectory& trajectory_;
  double speed_ = 0;
  std::array<AxisPeaks, 3> axes_;
};

}  // namespace

Summary summarise(const Trajectory& trajectory, const Toolpath& toolpath, const Vec3& rapid_speed) {
  Summary summary;
  summary.cycle_time = trajectory.duration();
  summary.programmed_time = programmed_time(toolpath, rapid_speed);

  Peaks peaks(trajectory);
  std::vector<ExactSum> by_cause(all_causes().size());
  ExactSum waiting;
  const auto& elements = trajectory.path().elements;
  for (std::size_t i = 0; i < trajectory.pieces().size(); ++i) {
    const Piece& piece = trajectory.pieces()[i];
    const double duration = trajectory.piece_end(i) - piece.time;
    by_cause[cause_index(piece.cause)].add(duration);
    if (elements[piece.element].kind == ElementKind::dwell) {
      waiting.add(duration);
    }
    peaks.add_piece(i);
  }
  for (const ExactSum& sum : by_cause) {
    summary.time_by_cause.push_back(sum.value());
  }
  summary.max_contour_error = trajectory.compaction_error();
  for (const FilteredMotion& motion : trajectory.motions()) {
    summary.max_contour_error = std::max(summary.max_contour_error, motion.contour_error());
  }
  for (const BlendRecord& blend : trajectory.blends()) {
    summary.max_contour_error = std::max(summary.max_contour_error, blend.epsilon);
  }
  const double moving = summary.cycle_time - waiting.value();
  summary.mean_feed = moving > 0 ? trajectory.path_length() / moving : 0;
  summary.peak_feed = peaks.speed();
  summary.axes = peaks.axes();
  return summary;
}

}  // namespace feedscope
