#include "core/blend/blended_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/make_room.h"
#include "core/blend/junction.h"

namespace feedscope {
CurvePoint ElementCurve::at(double s) const {
  s = std::clamp(s, 0.0, length);
  switch (kind) {
    case ElementKind::arc:
    case ElementKind::connecting_arc:
      return arc.at(s);
    case ElementKind::blend:
      return by_path_length(blend.at(blend.parameter_at(s)));
    case ElementKind::fitted:
      return course_at(course, s);
    case ElementKind::curve:
      return span->at(s);
    case ElementKind::line:
    case ElementKind::filtered:
    case ElementKind::dwell:
      break;
  }
  // From the nearer end, so that both ends are exact.
  const Vec3 position = s <= length / 2 ? Vec3(start + s * direction) : Vec3(end - (length - s) * direction);
  return {position, direction, Vec3::Zero(), Vec3::Zero()};
}

BlendedPath::BlendedPath(std::shared_ptr<const Toolpath> programmed,
                         std::shared_ptr<const CompactedPath> compacted)
    : programmed_(std::move(programmed)), compacted_(std::move(compacted)) {}

BlendedPath::BlendedPath(std::shared_ptr<const Toolpath> programmed,
                         std::shared_ptr<const ExecutedPath> executed)
    : programmed_(std::move(programmed)), executed_(std::move(executed)) {}

BlendedPath BlendedPath::without_elements() const {
  BlendedPath path(programmed_, compacted_);
  path.executed_ = executed_;
  path.alpha_ = alpha_;
  return path;
}

BlendedPath BlendedPath::cut(std::shared_ptr<const Toolpath> programmed,
                             std::shared_ptr<const CompactedPath> compacted,
                             std::span<const ElementPart> parts) const {
  BlendedPath path(std::move(programmed), std::move(compacted));
  path.transitions_ = transitions_;
  path.corners_ = corners_;
  path.knots_ = knots_;
  path.curves_ = curves_;
  path.length_ = length_;
  path.alpha_ = alpha_;
  path.entries_.reserve(parts.size());
  for (const ElementPart& part : parts) {
    Entry entry = entries_[part.element];
    entry.s += part.q;
    entry.block = part.block;
    if (in_corner(part.element)) {
      path.corners_[entry.index] = static_cast<std::uint32_t>(path.entries_.size());
    }
    path.entries_.push_back(entry);
  }
  return path;
}

void BlendedPath::append(const BlendedPath& part, std::uint32_t motions, double done) {
  make_room(entries_, part.entries_.size(), done);
  make_room(transitions_, part.transitions_.size(), done);
  make_room(corners_, part.corners_.size(), done);
  make_room(knots_, part.knots_.size(), done);
  const auto elements = static_cast<std::uint32_t>(entries_.size());
  const auto corners = static_cast<std::uint32_t>(corners_.size());
  const std::uint32_t knots = knot_count();
  const auto index_grows = [&](ElementKind kind) -> std::uint32_t {
    switch (kind) {
      case ElementKind::blend:
      case ElementKind::connecting_arc:
        return corners;
      case ElementKind::fitted:
      case ElementKind::curve:
      case ElementKind::dwell:
        return executed_ ? 0 : knots;
      case ElementKind::filtered:
        return motions;
      case ElementKind::line:
      case ElementKind::arc:
        break;
    }
    return 0;
  };
  for (Entry entry : part.entries_) {
    entry.s += length_;
    entry.index = (entry.index + index_grows(entry.kind)) & 0x1fffffff;
    entries_.push_back(entry);
  }
  transitions_.insert(transitions_.end(), part.transitions_.begin(), part.transitions_.end());
  for (const std::uint32_t element : part.corners_) {
    corners_.push_back(elements + element);
  }
  knots_.insert(knots_.end(), part.knots_.begin(), part.knots_.end());
  curves_ += part.curves_;
  length_ += part.length_;
}

void BlendedPath::reserve(std::size_t elements) {
  entries_.reserve(elements);
}

void BlendedPath::shrink() {
  entries_.shrink_to_fit();
  transitions_.shrink_to_fit();
  corners_.shrink_to_fit();
  knots_.shrink_to_fit();
}

std::uint32_t BlendedPath::add(ElementKind kind, std::uint32_t block, double length, std::uint32_t index) {
  if (kind == ElementKind::line && !entries_.empty() && entries_.back().kind == kind &&
      entries_.back().block == block) {
    index = entries_.back().index + 1;
  }
  Entry& entry = entries_.emplace_back();
  entry.s = length_;
  entry.block = block;
  entry.index = (kind == ElementKind::dwell ? knot_count() : index) & 0x1fffffff;
  entry.kind = kind;
  length_ += length;
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

std::uint32_t BlendedPath::add_corner(ElementKind kind, std::uint32_t block, double transition,
                                      double length) {
  const std::uint32_t element = add(kind, block, length, static_cast<std::uint32_t>(corners_.size()));
  transitions_.push_back(transition);
  corners_.push_back(element);
  return element;
}

std::uint32_t BlendedPath::add_fitted(std::uint32_t block, std::span<const CourseKnot> course) {
  const std::uint32_t element = add(ElementKind::fitted, block, course.back().s, knot_count());
  knots_.insert(knots_.end(), course.begin(), course.end());
  return element;
}

std::uint32_t BlendedPath::add_curve(std::uint32_t block, const CourseKnot& to) {
  const std::uint32_t element = add(ElementKind::curve, block, to.s - knots_.back().s, knot_count() - 1);
  knots_.push_back(to);
  return element;
}

std::uint32_t BlendedPath::add_executed(std::uint32_t i) {
  const Segment& segment = executed_->path.segments[i];
  const ElementKind kind = segment.kind == SegmentKind::arc     ? ElementKind::arc
                           : segment.kind == SegmentKind::dwell ? ElementKind::dwell
                                                                : ElementKind::line;
  const std::uint32_t element = add(kind, executed_->block[i], segment.length);
  entries_[element].index = i & 0x1fffffff;
  return element;
}

std::span<const CourseKnot> BlendedPath::course(std::size_t i) const {
  const std::size_t first = entries_[i].index;
  const std::size_t last = i + 1 < size() ? entries_[i + 1].index : knots_.size();
  return std::span(knots_).subspan(first, last - first);
}

std::size_t BlendedPath::base_segment(std::uint32_t block) const {
  if (!compacted_) {
    return block;
  }
  const auto& first = compacted_->first;
  return static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), block) - first.begin()) - 1;
}

double BlendedPath::line_offset(std::size_t i) const {
  if (executed_) {
    return 0;
  }
  if (const std::size_t parts = entries_[i].index; parts > 0) {
    return line_offset(i - parts) + entries_[i].s - entries_[i - parts].s;
  }
  if (i > 0 && in_corner(i - 1)) {
    return transitions_[entries_[i - 1].index];
  }
  const std::size_t chord = base_segment(entries_[i].block);
  if (i > 0 && kind(i - 1) == ElementKind::curve) {
    const Vec3& end = knots_[entries_[i - 1].index + 1].position;
    return (end - base().start_of(chord)).dot(base().tangent_at_start(chord));
  }
  if (!compacted_ || compacted_->first[chord] == entries_[i].block) {
    return 0;
  }
  const Vec3 passed = programmed_->start_of(entries_[i].block) - base().start_of(chord);
  return passed.dot(base().tangent_at_start(chord));
}

BlendedPath::CornerPlan BlendedPath::plan_of(std::size_t corner) const {
  const std::size_t segment = base_segment(entries_[corners_[corner]].block);
  return {base().segments[segment].end, base().tangent_at_end(segment), base().tangent_at_start(segment + 1)};
}

const Vec3& BlendedPath::corner_point(std::size_t corner) const {
  return programmed_->segments[entries_[corners_[corner]].block].end;
}

Corner BlendedPath::corner(std::size_t corner) const {
  const CornerPlan plan = plan_of(corner);
  Corner laid;
  laid.turn = turn_angle(plan.in, plan.out);
  laid.transition = transitions_[corner];
  laid.epsilon = kind(corners_[corner]) == ElementKind::blend
                     ? blend_epsilon(plan.in, plan.out, laid.transition, alpha_)
                     : laid.transition * std::tan(laid.turn / 4);
  return laid;
}

double BlendedPath::turn(std::size_t corner) const {
  const CornerPlan plan = plan_of(corner);
  return turn_angle(plan.in, plan.out);
}

double BlendedPath::min_radius(std::size_t corner) const {
  const CornerPlan plan = plan_of(corner);
  return kind(corners_[corner]) == ElementKind::blend
             ? feedscope::min_radius(BlendShape(plan.in, plan.out, transitions_[corner], alpha_))
             : transitions_[corner] / std::tan(turn_angle(plan.in, plan.out) / 2);
}

ElementCurve BlendedPath::curve(std::size_t i) const {
  const Entry& entry = entries_[i];
  ElementCurve curve;
  curve.kind = entry.kind;
  curve.length = length(i);
  if (in_corner(i)) {
    const CornerPlan plan = plan_of(entry.index);
    const double transition = transitions_[entry.index];
    curve.start = plan.point - transition * plan.in;
    curve.end = plan.point + transition * plan.out;
    if (entry.kind == ElementKind::blend) {
      curve.blend = {curve.start, plan.point, curve.end, alpha_};
    } else {
      curve.arc = corner_arc(plan.point, plan.in, plan.out, transition);
    }
    return curve;
  }
  if (entry.kind == ElementKind::fitted) {
    curve.course = course(i);
    curve.start = curve.course.front().position;
    curve.end = curve.course.back().position;
    curve.direction = Vec3::Zero();
    return curve;
  }
  if (entry.kind == ElementKind::curve) {
    const CourseKnot& from = knots_[entry.index];
    const CourseKnot& to = knots_[entry.index + 1];
    curve.course = std::span(knots_).subspan(entry.index, 2);
    curve.span.emplace(from, to);
    curve.start = from.position;
    curve.end = to.position;
    curve.direction = Vec3::Zero();
    return curve;
  }
  const std::size_t segment = base_segment_of(i);
  curve.start = base().start_of(segment);
  curve.end = base().segments[segment].end;
  switch (entry.kind) {
    case ElementKind::line: {
      curve.direction = base().tangent_at_start(segment);
      curve.start += line_offset(i) * curve.direction;
      const bool next_on_it = i + 1 < size() && base_segment_of(i + 1) == segment;
      if (next_on_it) {  // its corner, or the next part of a chord
        curve.end = curve.start + curve.length * curve.direction;
      }
      break;
    }
    case ElementKind::arc:
      curve.arc = base().arc_of(base().segments[segment]);
      break;
    case ElementKind::filtered:
      curve.direction =
          curve.length > 0 ? Vec3((curve.end - curve.start) / curve.length) : Vec3(Vec3::Zero());
      break;
    default:
      curve.direction = Vec3::Zero();
  }
  return curve;
}

PathElement BlendedPath::element(std::size_t i) const {
  const ElementCurve course = curve(i);
  return {course.start,      course.end,        entries_[i].s,   course.length,
          entries_[i].block, entries_[i].index, entries_[i].kind};
}

std::size_t BlendedPath::element_at(double s) const {
  const auto after = std::lower_bound(entries_.begin(), entries_.end(), s,
                                      [](const Entry& entry, double value) { return entry.s < value; });
  return after == entries_.begin() ? 0 : static_cast<std::size_t>(after - entries_.begin()) - 1;
}

}  // namespace feedscope
