#include "core/drives/set_walk.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// Farther apart than rounding leaves the ends of two spans [mm].
constexpr double jump = 1e-4;

/// By which share of a span that is off by `error` [mm] a span is shorter that is off by the tolerance:
/// errors rise with the eighth power of the duration.
double fitting_share(double error) {
  constexpr double cautious = 0.9;
  constexpr double nothing = 1e-3;  // of the tolerance
  return cautious * std::pow(SetWalk::tolerance / std::max(error, nothing * SetWalk::tolerance), 1.0 / 8);
}

void set_derivatives(SetSpan& span, std::size_t order, const Vec3& value) {
  for (std::size_t axis = 0; axis < span.axes.size(); ++axis) {
    span.axes[axis].derivative[order] = value[static_cast<Eigen::Index>(axis)];
  }
}

}  // namespace

SetWalk::SetWalk(const Trajectory& trajectory, double time)
    : trajectory_(trajectory),
      walk_(trajectory, trajectory.pieces().empty() ? 0 : trajectory.piece_at(time),
            trajectory.pieces().empty()
                ? 0
                : std::max(0.0, time - trajectory.pieces()[trajectory.piece_at(time)].time)) {
  while (!walk_.done() && !(walk_.part().duration > 0)) {
    walk_.next();
  }
  done_ = walk_.done();
  if (!done_) {
    enter_part();
    make_span();
  }
}

void SetWalk::enter_part() {
  from_ = 0;
  guess_ = walk_.part().duration;
  motion_.emplace(walk_.motion());
}

void SetWalk::next() {
  from_ += span_.duration;
  if (from_ >= walk_.part().duration * (1 - 1e-12)) {
    walk_.next();
    if (walk_.done()) {
      done_ = true;
      return;
    }
    enter_part();
  }
  make_span();
}

void SetWalk::make_span() {
  const Part& part = walk_.part();
  span_.axes = {};
  span_.time = part.time + from_;
  const ElementKind kind = trajectory_.path().kind(part.element);
  if (kind == ElementKind::dwell || (kind == ElementKind::line && part.law != Law::filtered)) {
    make_line_span();
  } else {
    const double end = part.law == Law::filtered ? end_of_pulse(from_) : part.duration;
    double to = std::min(end, from_ + guess_);
    if (end - to < 0.1 * guess_) {
      to = end;  // no sliver behind
    }
    constexpr int most_tries = 40;
    double error = fit(from_, to);
    for (int tries = 0; error > tolerance && tries < most_tries; ++tries) {
      to = from_ + std::clamp(fitting_share(error), 0.1, 0.7) * (to - from_);
      error = fit(from_, to);
    }
    guess_ = std::clamp(fitting_share(error), 0.5, 4.0) * (to - from_);
  }
  for (SetCourse& course : span_.axes) {
    course.duration = span_.duration;
  }
  for (std::size_t axis = 0; axis < span_.axes.size(); ++axis) {
    span_.start[static_cast<Eigen::Index>(axis)] = span_.axes[axis].derivative[0];
  }
  span_.begins = first_ || (span_.start - reached_).norm() > jump;
  first_ = false;
  for (std::size_t axis = 0; axis < span_.axes.size(); ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    reached_[i] = span_.start[i] + span_.axes[axis].travel(span_.duration);
  }
}

/// The law of a line, or standstill.
void SetWalk::make_line_span() {
  const Part& part = walk_.part();
  const Kinematics at = motion_->kinematics(0);
  span_.duration = part.duration;
  set_derivatives(span_, 0, at.position);
  set_derivatives(span_, 1, at.velocity);
  set_derivatives(span_, 2, at.acceleration);
  set_derivatives(span_, 3, at.jerk);
}

/// Where the pulses that the filters see change next, from the start of the part [s].
double SetWalk::end_of_pulse(double from) {
  const Part& part = walk_.part();
  const FilteredMotion& motion = trajectory_.motion_of(part.element);
  const double start = part.time - motion.start();
  return std::min(part.duration, knots_.next_knot(motion.train(), start + from) - start);
}

/// The polynomial with the derivatives up to the third of both ends. Beyond the Taylor polynomial of the
/// start, c4 u^4 + ... + c7 u^7 with u = t/h must make up for what that misses of the end.
double SetWalk::fit(double from, double to) {
  const double h = to - from;
  const Kinematics a = motion_->kinematics(from);
  const Kinematics b = motion_->kinematics(to);
  const double square = h * h;
  const double cube = square * h;
  const Vec3 position =
      b.position - a.position - h * a.velocity - square / 2 * a.acceleration - cube / 6 * a.jerk;
  const Vec3 velocity = h * (b.velocity - a.velocity - h * a.acceleration - square / 2 * a.jerk);
  const Vec3 acceleration = square * (b.acceleration - a.acceleration - h * a.jerk);
  const Vec3 jerk = cube * (b.jerk - a.jerk);
  const double fourth = 1 / (square * square);
  span_.duration = h;
  set_derivatives(span_, 0, a.position);
  set_derivatives(span_, 1, a.velocity);
  set_derivatives(span_, 2, a.acceleration);
  set_derivatives(span_, 3, a.jerk);
  set_derivatives(span_, 4, 24 * fourth * (35 * position - 15 * velocity + 2.5 * acceleration - jerk / 6));
  set_derivatives(span_, 5,
                  120 * fourth / h * (-84 * position + 39 * velocity - 7 * acceleration + jerk / 2));
  set_derivatives(span_, 6,
                  720 * fourth / square * (70 * position - 34 * velocity + 6.5 * acceleration - jerk / 2));
  set_derivatives(span_, 7,
                  5040 * fourth / cube * (-20 * position + 10 * velocity - 2 * acceleration + jerk / 6));
  const Vec3 middle = motion_->kinematics(from + h / 2).position;
  double off = 0;
  for (std::size_t axis = 0; axis < span_.axes.size(); ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    off = std::max(off, std::abs(a.position[i] + span_.axes[axis].travel(h / 2) - middle[i]));
  }
  return off;
}

}  // namespace feedscope
