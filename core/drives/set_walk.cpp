#include "core/drives/set_walk.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// Larger distances between the ends of two spans are not rounding [mm].
constexpr double jump = 1e-4;

/// Factor on the duration of a span with `error` [mm] to bring its error within the tolerance: errors rise
/// with the eighth power of the duration.
double fitting_share(double error) {
  constexpr double cautious = 0.9;
  constexpr double nothing = 1e-3;  // of the tolerance
  return cautious * std::pow(SetWalk::tolerance / std::max(error, nothing * SetWalk::tolerance), 1.0 / 8);
}

/// Product of two polynomials without a constant term.
using Powers = std::array<double, SetCourse::order + 1>;
Powers product(const Powers& a, std::size_t a_degree, const Powers& b, std::size_t b_degree) {
  Powers result{};
  for (std::size_t i = 1; i <= a_degree; ++i) {
    for (std::size_t k = 1; k <= b_degree; ++k) {
      result[i + k] += a[i] * b[k];
    }
  }
  return result;
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
  const Part& part = walk_.part();
  from_ = 0;
  guess_ = part.duration;
  motion_.reset();
  arc_.reset();
  if (part.law == Law::filtered) {
    return;
  }
  if (part.element != element_) {
    curve_ = trajectory_.path().curve(part.element);
    element_ = part.element;
  }
  if (curve_.is_arc()) {
    arc_.emplace(curve_.arc, part, tolerance);
  } else if (curve_.kind == ElementKind::blend && part.law == Law::path_length) {
    blend_.enter(curve_.blend, curve_.length, part);
  }
}

void SetWalk::next() {
  from_ += span_.duration;
  if (from_ >= walk_.part().duration * (1 - 1e-12)) {
    reached_ = span_.at(span_.duration);
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
  if (part.law == Law::filtered) {
    make_filtered_span();
  } else if (curve_.kind == ElementKind::line || curve_.kind == ElementKind::dwell) {
    make_line_span();
  } else if (arc_) {
    arc_->fill(span_, from_);
  } else if (part.law == Law::parameter) {
    make_blend_span();
  } else if (curve_.kind != ElementKind::blend || !blend_.fill(span_, from_)) {
    make_fitted_span();
  }
  span_.time = part.time + from_;
  span_.element = part.element;
  span_.begins = first_ || (from_ == 0 && (span_.start - reached_).norm() > jump);
  first_ = false;
}

/// Law of a line, or standstill.
void SetWalk::make_line_span() {
  const Part& part = walk_.part();
  span_.begin(curve_.at(part.q).position, 3, part.duration);
  span_.set_derivative(1, part.v * curve_.direction);
  span_.set_derivative(2, part.a * curve_.direction);
  span_.set_derivative(3, part.j * curve_.direction);
}

/// The blend is of third degree in u, and u of at most third degree in time: with w = u - u0 from the start
/// of the part on, S is S0 + d1 w + d2/2 w^2 + d3/6 w^3.
void SetWalk::make_blend_span() {
  const Part& part = walk_.part();
  const std::size_t law_degree = part.j != 0 ? 3 : part.a != 0 ? 2 : 1;
  const Powers w{0, part.v, part.a / 2, part.j / 6};
  const Powers square = product(w, law_degree, w, law_degree);
  const Powers cube = product(square, 2 * law_degree, w, law_degree);
  const CurvePoint at = curve_.blend.at(std::clamp(part.q, 0.0, 1.0));
  span_.begin(at.position, 3 * law_degree, part.duration);
  double factorial = 1;
  for (std::size_t k = 1; k <= span_.degree(); ++k) {
    factorial *= static_cast<double>(k);
    span_.set_derivative(
        k, factorial * w[k] * at.d1 + factorial * square[k] / 2 * at.d2 + factorial * cube[k] / 6 * at.d3);
  }
}

/// Extends to the next change of the pulses within the filters.
void SetWalk::make_filtered_span() {
  const Part& part = walk_.part();
  const FilteredMotion& motion = trajectory_.motion_of(part.element);
  const PulseTrain& train = motion.train();
  const double at = part.time - motion.start() + from_;
  // Knots separated only by rounding count as one.
  const double rounding = 1e-9 * train.filter_time;
  double duration = pulses_.next_knot(train, at + rounding) - at;
  if (part.duration - from_ < duration + rounding) {
    duration = part.duration - from_;
  }
  if (pulses_.is_polynomial()) {
    const FilterWalk::Derivatives derivatives = pulses_.continued_derivatives(at);
    span_.begin(derivatives[0], derivatives.size() - 1, duration);
    for (std::size_t k = 1; k < derivatives.size(); ++k) {
      span_.set_derivative(k, derivatives[k]);
    }
    return;
  }
  if (pulses_.is_settled()) {
    make_settled_span(pulses_.settled_part(), at, duration);
    return;
  }
  constexpr double factorial = 40320;
  const double longest = 2 * std::pow(factorial * tolerance / pulses_.derivative_bound(8), 1.0 / 8);
  duration /= std::ceil(duration / longest);
  meet(pulses_.continued(at), pulses_.continued(at + duration), duration);
}

/// Circle at constant speed, from `at` of its motion on.
void SetWalk::make_settled_span(const CommandPart& turn, double at, double duration) {
  const double radius = turn.cosine.norm();
  Arc arc{turn.position - turn.cosine,
          turn.cosine / radius,
          turn.sine / radius,
          turn.velocity / turn.rate,
          radius,
          0};
  const double speed = turn.rate * arc.length_per_radian();
  Part part;
  part.duration = duration;
  part.q = speed * (at - turn.time);
  part.v = speed;
  ArcCourse(arc, part, tolerance).fill(span_, 0);
}

void SetWalk::make_fitted_span() {
  if (!motion_) {
    motion_.emplace(walk_.motion());
  }
  const double end = walk_.part().duration;
  double to = std::min(end, from_ + guess_);
  if (end - to < 0.1 * guess_) {
    to = end;  // no sliver after it
  }
  constexpr int most_tries = 40;
  double share = 0;
  for (int tries = 0; tries < most_tries; ++tries) {
    const double h = to - from_;
    meet(motion_->kinematics(from_), motion_->kinematics(to), h);
    const double error =
        (motion_->kinematics(from_ + h / 2).position - span_.at(h / 2)).cwiseAbs().maxCoeff();
    share = fitting_share(error);
    if (error <= tolerance) {
      break;
    }
    to = from_ + std::clamp(share, 0.1, 0.7) * h;
  }
  guess_ = std::clamp(share, 0.5, 4.0) * span_.duration;
}

/// Polynomial with the derivatives up to the third of both ends. With u = t/h, c4 u^4 + ... + c7 u^7 must
/// correct the error of the Taylor polynomial from the start.
void SetWalk::meet(const Kinematics& a, const Kinematics& b, double h) {
  const double square = h * h;
  const double cube = square * h;
  const Vec3 position =
      b.position - a.position - h * a.velocity - square / 2 * a.acceleration - cube / 6 * a.jerk;
  const Vec3 velocity = h * (b.velocity - a.velocity - h * a.acceleration - square / 2 * a.jerk);
  const Vec3 acceleration = square * (b.acceleration - a.acceleration - h * a.jerk);
  const Vec3 jerk = cube * (b.jerk - a.jerk);
  const double fourth = 1 / (square * square);
  span_.begin(a.position, 7, h);
  span_.set_derivative(1, a.velocity);
  span_.set_derivative(2, a.acceleration);
  span_.set_derivative(3, a.jerk);
  span_.set_derivative(4, 24 * fourth * (35 * position - 15 * velocity + 2.5 * acceleration - jerk / 6));
  span_.set_derivative(5, 120 * fourth / h * (-84 * position + 39 * velocity - 7 * acceleration + jerk / 2));
  span_.set_derivative(
      6, 720 * fourth / square * (70 * position - 34 * velocity + 6.5 * acceleration - jerk / 2));
  span_.set_derivative(7,
                       5040 * fourth / cube * (-20 * position + 10 * velocity - 2 * acceleration + jerk / 6));
}

}  // namespace feedscope
