#include "core/analysis/difference/course_walk.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr int spans_of_blend_part = 4;
constexpr int spans_of_fitted_part = 4;
constexpr double steps_a_filter_time = 8;

/// Cubic from 0 to `length` with the speeds at both ends, lowered where the cubic would decrease in between.
LawPoint rising_law(double duration, double length, double speed_from, double speed_to) {
  if (!(duration > 0) || !(length > 0)) {
    return {};
  }
  const double most = 3 * length / duration;
  const double from = std::clamp(speed_from, 0.0, most);
  const double to = std::clamp(speed_to, 0.0, most);
  const double jerk = 12 * ((from + to) * duration / 2 - length) / (duration * duration * duration);
  return {0, from, (to - from) / duration - jerk * duration / 2, jerk};
}

}  // namespace

double ProgressSpan::offset_at(double tau) const {
  return tau >= duration ? end - begin : std::clamp(advance(law, tau).q, 0.0, end - begin);
}

double ProgressSpan::tau_at(double offset) const {
  return offset >= end - begin ? duration : time_to_reach(law, offset, duration);
}

bool ProgressSpan::same_law(const ProgressSpan& other) const {
  return begin == other.begin && end == other.end && duration == other.duration && law.v == other.law.v &&
         law.a == other.law.a && law.j == other.law.j;
}

std::vector<double> lengths_before(const Toolpath& programmed) {
  std::vector<double> lengths{0};
  lengths.reserve(programmed.segments.size() + 1);
  for (const Segment& segment : programmed.segments) {
    lengths.push_back(lengths.back() + segment.length);
  }
  return lengths;
}

CourseWalk::CourseWalk(const Trajectory& trajectory, const std::vector<double>& lengths)
    : trajectory_(trajectory),
      lengths_(lengths),
      parts_(trajectory),
      deviation_(*trajectory.path().programmed()) {
  gather();
}

bool CourseWalk::next() {
  if (at_ + 1 < spans_.size()) {
    ++at_;
    return true;
  }
  if (parts_.done()) {
    return false;
  }
  gather();
  return true;
}

void CourseWalk::gather() {
  raw_.clear();
  spans_.clear();
  at_ = 0;
  element_ = parts_.part().element;
  is_filtered(element_) ? gather_filtered() : gather_curve();
}

/// Gathers all parts of one element: together they correspond to the programmed length there.
void CourseWalk::gather_curve() {
  for (; !parts_.done() && parts_.part().element == element_; parts_.next()) {
    const Part& part = parts_.part();
    if (part.law == Law::parameter) {
      gather_blend_part();
    } else {
      const LawPoint end = advance({0, part.v, part.a, part.j}, part.duration);
      raw_.push_back({part.time, part.duration, std::max(0.0, end.q), part.v, end.v});
    }
  }
  double executed = 0;
  for (const RawSpan& raw : raw_) {
    executed += raw.length;
  }
  const double end = std::max(reached_, end_of(element_));
  const double scale = executed > 0 ? (end - reached_) / executed : 0;
  for (const RawSpan& raw : raw_) {
    add_span(raw, &raw == &raw_.back() ? end : std::min(end, reached_ + scale * raw.length), scale);
  }
}

void CourseWalk::gather_blend_part() {
  const Part& part = parts_.part();
  const CubicBlend blend = parts_.motion().curve().blend;
  const double step = part.duration / spans_of_blend_part;
  double length = 0;
  double speed = 0;
  for (int i = 0; i <= spans_of_blend_part; ++i) {
    const LawPoint law = advance({part.q, part.v, part.a, part.j}, i * step);
    const double u = std::clamp(law.q, 0.0, 1.0);
    const double length_here = blend.length_to(u);
    const double speed_here = blend.at(u).d1.norm() * law.v;
    if (i > 0) {
      raw_.push_back(
          {part.time + (i - 1) * step, step, std::max(0.0, length_here - length), speed, speed_here});
    }
    length = length_here;
    speed = speed_here;
  }
}

void CourseWalk::gather_filtered() {
  for (; !parts_.done() && parts_.part().element == element_; parts_.next()) {
    follow_part();
  }
  const BlendedPath& path = trajectory_.path();
  if (path.kind(element_) == ElementKind::curve) {
    spans_.back().end = std::max(reached_, end_of(element_));
    reached_ = spans_.back().end;
  } else if (parts_.done() || !is_filtered(parts_.part().element)) {  // it stops at the end of its last block
    spans_.back().end = std::max(reached_, programmed_until(path.segment(element_) + std::size_t{1}));
    reached_ = spans_.back().end;
  }
}

/// Divides a part into short steps, each with the programmed points nearest to its ends.
void CourseWalk::follow_part() {
  const Part& part = parts_.part();
  const PartMotion motion = parts_.motion();
  const std::uint32_t segment = trajectory_.path().segment(part.element);
  constexpr int max_spans = 256;  // a part is short where blocks meet
  const int count = part.law == Law::filtered
                        ? std::min(trajectory_.filtered_spans(part, steps_a_filter_time), max_spans)
                        : spans_of_fitted_part;
  const double step = part.duration / count;
  Kinematics from = motion.kinematics(0);
  for (int i = 0; i < count; ++i) {
    const Kinematics to = motion.kinematics((i + 1) * step);
    const double speed_from = from.velocity.norm();
    const double speed_to = to.velocity.norm();
    const double gone = step * std::max(speed_from, speed_to);
    const PathDeviation::Foot foot = deviation_.foot_near(segment, to.position);
    add_span({part.time + i * step, step, gone, speed_from, speed_to}, lengths_[foot.segment] + foot.s, 1);
    from = to;
  }
}

/// Adds a span from the end of the previous one to `end` [mm], or at rest. `scale`: programmed over executed
/// length.
void CourseWalk::add_span(const RawSpan& raw, double end, double scale) {
  ProgressSpan& span = spans_.emplace_back();
  span.time = raw.time;
  span.duration = raw.duration;
  span.begin = reached_;
  span.end = reached_ = std::max(reached_, end);
  span.law = rising_law(raw.duration, span.end - span.begin, scale * raw.speed_from, scale * raw.speed_to);
  span.segment = trajectory_.path().segment(element_);
  span.dwell = trajectory_.path().kind(element_) == ElementKind::dwell;
}

double CourseWalk::programmed_until(std::size_t segment) const {
  return lengths_[std::min(segment, lengths_.size() - 1)];
}

bool CourseWalk::is_filtered(std::size_t element) const {
  const ElementKind kind = trajectory_.path().kind(element);
  return kind == ElementKind::filtered || kind == ElementKind::fitted || kind == ElementKind::curve;
}

/// End of the element on the programmed path [mm].
double CourseWalk::end_of(std::uint32_t element) const {
  const BlendedPath& path = trajectory_.path();
  if (path.in_corner(element)) {
    return programmed_until(path.segment(element) + std::size_t{1}) +
           path.corner_transition(path.index(element));
  }
  const std::size_t next = std::size_t{element} + 1;
  if (next >= path.size()) {
    return lengths_.back();
  }
  const bool in_between = path.kind(next) == ElementKind::curve ||
                          (path.kind(next) == ElementKind::line && path.kind(element) == ElementKind::curve);
  if (in_between) {  // a curve may begin or end anywhere on a line
    const Toolpath& programmed = *path.programmed();
    const std::uint32_t segment = path.segment(next);
    const Vec3 way = path.curve(next).start - programmed.start_of(segment);
    return programmed_until(segment) + way.dot(programmed.tangent_at_start(segment));
  }
  return path.in_corner(next) ? programmed_until(path.segment(next) + std::size_t{1}) -
                                    path.corner_transition(path.index(next))
                              : programmed_until(path.segment(next));
}

}  // namespace feedscope
