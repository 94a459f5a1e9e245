#include "core/trajectory/part_walk.h"

#include <algorithm>
#include <cmath>

namespace feedscope {

Kinematics kinematics_of(const CurvePoint& at, const LawPoint& law) {
  return {at.position, at.d1 * law.v, at.d2 * (law.v * law.v) + at.d1 * law.a,
          at.d3 * (law.v * law.v * law.v) + at.d2 * (3 * law.v * law.a) + at.d1 * law.j};
}

LawPoint law_at(const Part& part, double tau) {
  return advance({part.q, part.v, part.a, part.j}, tau);
}

PartWalk::PartWalk(const Trajectory& trajectory, std::size_t piece) : PartWalk(trajectory, piece, 0) {}

PartWalk::PartWalk(const Trajectory& trajectory, std::size_t piece, double tau)
    : trajectory_(trajectory), piece_(piece), phases_({}, 0) {
  enter_piece(tau);
}

void PartWalk::enter_piece(double tau) {
  if (done()) {
    return;
  }
  const Piece& piece = trajectory_.pieces()[piece_];
  duration_ = trajectory_.piece_end(piece_) - piece.time;
  phases_ = PiecePhases(piece, duration_);
  last_element_ = trajectory_.last_element(piece_);
  tau_ = tau;
  phase_ = phases_.at_time(tau);
  part_ = {};
  part_.piece = static_cast<std::uint32_t>(piece_);
  part_.element = piece.element;
  part_.law = piece.law == Law::ramp ? Law::path_length : piece.law;
  part_.cause = piece.cause;
  if (piece.law == Law::filtered) {
    part_.time = piece.time + tau;
    part_.duration = duration_ - tau;
    part_.q = tau > 0 ? trajectory_.filtered_q(piece_, tau, filters_) : piece.q;
    return;
  }
  if (tau > 0 && last_element_ > piece.element) {
    const BlendedPath& path = trajectory_.path();
    const auto there = static_cast<std::uint32_t>(path.element_at(path.s(piece.element) + phases_.at(tau).q));
    part_.element = std::clamp(there, piece.element, last_element_);
  }
  find_part();
}

/// Finds the part that begins at tau_ in phase_ on part_.element.
void PartWalk::find_part() {
  const Piece& piece = trajectory_.pieces()[piece_];
  const BlendedPath& path = trajectory_.path();
  LawPoint at = advance(phases_.at_begin(phase_), tau_ - phases_.begin(phase_));
  const double offset = path.s(part_.element) - path.s(piece.element);
  at.q = std::max(at.q - offset, part_.element == piece.element ? piece.q : 0.0);
  part_.time = piece.time + tau_;
  part_.q = at.q;
  part_.v = at.v;
  part_.a = at.a;
  part_.j = at.j;
  part_.duration = phases_.end(phase_) - tau_;
  if (part_.element < last_element_) {
    // A part no longer than the rounding of the clock or of path lengths is not a part of its own.
    constexpr double rounding = 4e-15;
    const double length = path.length(part_.element);
    const double reached = time_to_reach(at, length, part_.duration);
    if (part_.duration - reached > rounding * (1 + part_.time) &&
        advance(at, part_.duration).q - length > rounding * (1 + path.s(part_.element))) {
      part_.duration = reached;
    }
  }
  const bool holds = piece.law == Law::ramp && phase_ == 1 && piece.cause.kind != CauseKind::ramp_down;
  part_.cause = holds ? all_causes()[piece.second] : piece.cause;
}

void PartWalk::next() {
  do {
    step();
  } while (!done() && !(part_.duration > 0));
}

void PartWalk::step() {
  const double left = phases_.end(phase_) - tau_ - part_.duration;
  if (part_.law != Law::filtered && left > 0) {  // the element ended
    tau_ += part_.duration;
    ++part_.element;
    find_part();
  } else if (part_.law != Law::filtered && phase_ + 1 < phases_.count()) {
    tau_ = phases_.end(phase_);
    ++phase_;
    find_part();
  } else {
    ++piece_;
    enter_piece(0);
  }
}

Cause limiting_cause(const Trajectory& trajectory, const Part& part) {
  return part.cause.kind == CauseKind::ramp_down ? trajectory.slower_place(part.piece) : part.cause;
}

PartMotion PartWalk::motion() {
  return {trajectory_, part_, &filters_};
}

PartMotion::PartMotion(const Trajectory& trajectory, const Part& part, FilterWalk* filters)
    : trajectory_(trajectory),
      part_(part),
      curve_(trajectory.path().curve(part.element)),
      filters_(filters) {}

CurvePoint PartMotion::curve_point(double q) const {
  return part_.law == Law::parameter ? curve_.blend.at(std::clamp(q, 0.0, 1.0)) : curve_.at(q);
}

Kinematics PartMotion::kinematics(double tau) const {
  if (part_.law == Law::filtered) {
    return filtered_kinematics(tau);
  }
  const LawPoint law = law_at(part_, tau);
  return kinematics_of(curve_point(law.q), law);
}

State PartMotion::state(double tau) const {
  State state = state_without_length(tau);
  state.path_length = length_at(tau);
  return state;
}

/// Executed path length from the start of the trajectory.
double PartMotion::length_at(double tau) const {
  const double start = trajectory_.path().s(part_.element);
  if (part_.law == Law::filtered) {
    const double passed = part_.time - trajectory_.pieces()[part_.piece].time + tau;
    FilterWalk own;
    return start + trajectory_.filtered_q(part_.piece, passed, filters_ != nullptr ? *filters_ : own);
  }
  const double q = law_at(part_, tau).q;
  return start + (part_.law == Law::parameter ? curve_.blend.length_to(std::clamp(q, 0.0, 1.0))
                                              : std::clamp(q, 0.0, curve_.length));
}

State PartMotion::state_without_length(double tau) const {
  State state;
  state.time = part_.time + tau;
  state.line = trajectory_.line_of(part_.element);
  state.element = part_.element;
  state.programmed_feed = trajectory_.feed_of(part_.element);
  state.cause = part_.cause;
  state.slower_place = trajectory_.slower_place(part_.piece);
  if (part_.law == Law::filtered) {
    return filtered_state(state, tau);
  }

  const LawPoint law = law_at(part_, tau);
  const CurvePoint at = curve_point(law.q);
  const Kinematics motion = kinematics_of(at, law);
  state.position = motion.position;
  state.velocity = motion.velocity;
  state.acceleration = motion.acceleration;
  state.jerk = motion.jerk;
  state.speed = law.v;
  state.tangential_acceleration = law.a;
  state.tangential_jerk = law.j;
  if (part_.law == Law::parameter) {
    const double sigma = at.d1.norm();
    const double dsigma = at.d1.dot(at.d2) / sigma;
    const double ddsigma = (at.d2.squaredNorm() + at.d1.dot(at.d3) - dsigma * dsigma) / sigma;
    state.speed = sigma * law.v;
    state.tangential_acceleration = dsigma * law.v * law.v + sigma * law.a;
    state.tangential_jerk = ddsigma * law.v * law.v * law.v + 3 * dsigma * law.v * law.a + sigma * law.j;
  }
  return state;
}

Kinematics PartMotion::filtered_kinematics(double tau) const {
  const FilteredMotion& motion = trajectory_.motion_of(part_.element);
  const double time = part_.time - motion.start() + tau;
  return filters_ != nullptr ? filters_->at(motion.train(), time) : motion.at(time);
}

State PartMotion::filtered_state(State state, double tau) const {
  const Kinematics at = filtered_kinematics(tau);
  state.position = at.position;
  state.velocity = at.velocity;
  state.acceleration = at.acceleration;
  state.jerk = at.jerk;
  state.speed = at.velocity.norm();
  if (state.speed > 0) {
    const double along = at.acceleration.dot(at.velocity) / state.speed;
    state.tangential_acceleration = along;
    state.tangential_jerk =
        (at.jerk.dot(at.velocity) + at.acceleration.squaredNorm() - along * along) / state.speed;
  } else {
    state.tangential_acceleration = at.acceleration.norm();
    state.tangential_jerk = at.jerk.norm();
  }
  return state;
}

}  // namespace feedscope
