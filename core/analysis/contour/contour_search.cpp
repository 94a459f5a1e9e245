#include "core/analysis/contour/contour_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace feedscope {
namespace {

/// Maximum from 0 to 1 of the lower of two straight lines; the first is the lower one at 0, the second at 1.
double largest_of_lower(double first_from, double first_to, double second_from, double second_to) {
  const double before = std::max(second_from - first_from, 0.0);
  const double after = std::max(first_to - second_to, 0.0);
  const double crossing = before + after > 0 ? before / (before + after) : 0;
  return std::max({first_from, second_to, first_from + crossing * (first_to - first_from)});
}

}  // namespace

const Toolpath& programmed_path(const Trajectory& trajectory) {
  static const Toolpath none;
  return trajectory.path().empty() ? none : *trajectory.path().programmed();
}

ContourSearch::ContourSearch(const Trajectory& trajectory)
    : ContourSearch(trajectory, PathDeviation(programmed_path(trajectory))) {}

ContourSearch::ContourSearch(const Trajectory& trajectory, const PathDeviation& deviation)
    : trajectory_(trajectory), course_(trajectory), deviation_(deviation) {}

double ContourSearch::sagitta(const ContourNode& from, const ContourNode& to) const {
  const double bend = std::max(from.point.d2.norm(), to.point.d2.norm());
  const double step = to.place.u - from.place.u;
  return (bend + course_.bend_between(to.place.element, from.place.u, to.place.u, bend)) * step * step / 8;
}

PathDeviation::Foot ContourSearch::foot_of(const Vec3& position, std::size_t segment) const {
  const double enough = of_interest_ * of_interest_;
  const std::size_t segments = programmed_path(trajectory_).segments.size();
  for (const std::size_t near : {segment, last_segment_, segment + 1, last_segment_ + 1}) {
    if (enough > 0 && near < segments) {
      const PathDeviation::Foot foot = deviation_.foot_on(near, position);
      if (foot.squared <= enough) {
        return foot;
      }
    }
  }
  return deviation_.nearest(position, segment, last_segment_);
}

ContourNode ContourSearch::node(const CoursePlace& at) {
  ContourNode node;
  node.place = at;
  node.point = course_.at(at);
  node.foot = foot_of(node.point.position, trajectory_.path().segment(at.element));
  node.error = std::sqrt(node.foot.squared);
  last_segment_ = node.foot.segment;
  return node;
}

/// Largest amount by which the second derivative of the distance from a line is below 0.
double ContourSearch::bend_from_line(std::size_t index, const PathDeviation::Foot& at_from,
                                     const PathDeviation::Foot& at_to, const ContourSpan& span) const {
  const double from = std::sqrt(at_from.squared);
  const double to = std::sqrt(at_to.squared);
  const ElementKind kind = trajectory_.path().kind(span.from.place.element);
  constexpr double min_cosine = 0.9;
  const double cosine = at_from.offset.dot(at_to.offset) / (from * to);
  if (kind == ElementKind::connecting_arc || !(cosine > min_cosine)) {
    return bend_across_line(index, at_from, at_to, span);
  }
  // A unit vector between the two is their sum with weights that add up to at most 1 / cos(half their angle).
  return std::max({-at_from.offset.dot(span.from.point.d2) / from, -at_to.offset.dot(span.to.point.d2) / to,
                   0.0}) /
         std::sqrt((1 + std::min(cosine, 1.0)) / 2);
}

/// As bend_from_line() for offsets of any direction: across the line, unless a foot in between is an end of
/// it.
double ContourSearch::bend_across_line(std::size_t index, const PathDeviation::Foot& at_from,
                                       const PathDeviation::Foot& at_to, const ContourSpan& span) const {
  const Toolpath& path = programmed_path(trajectory_);
  const double sag = sagitta(span.from, span.to);
  const bool inside =
      std::min(at_from.s, at_to.s) > sag && std::max(at_from.s, at_to.s) < path.segments[index].length - sag;
  const Vec3 along = inside ? path.tangent_at_start(index) : Vec3(Vec3::Zero());
  const auto across = [&along](const Vec3& d2) { return (d2 - d2.dot(along) * along).norm(); };
  return std::max(across(span.from.point.d2), across(span.to.point.d2));
}

/// Largest second derivative of the distance from the axis of a flat arc. Between the ends its own derivative
/// (3 p' p'' - 3 r' r'' + (p - c) p''')/r counts, with the mean p'''.
double ContourSearch::bend_from_arc(const Arc& arc, const ContourSpan& span) const {
  const Vec3 axis = arc.x.cross(arc.y);
  const double step = span.to.place.u - span.from.place.u;
  const Vec3 d3 = (span.to.point.d2 - span.from.point.d2) / step;
  double bend = 0;
  double change = 0;
  for (const ContourNode* node : {&span.from, &span.to}) {
    const auto in_plane = [&](const Vec3& v) -> Vec3 { return v - v.dot(axis) * axis; };
    const Vec3 out = in_plane(node->point.position - arc.center);
    const Vec3 d1 = in_plane(node->point.d1);
    const Vec3 d2 = in_plane(node->point.d2);
    const double r = out.norm();
    const double dr = out.dot(d1) / r;
    const double ddr = (d1.squaredNorm() - dr * dr + out.dot(d2)) / r;
    bend = std::max(bend, std::abs(ddr));
    change = std::max(change, std::abs(3 * d1.dot(d2) - 3 * dr * ddr + out.dot(d3)) / r);
  }
  return bend + change * step / 2;
}

/// With the offset o = p - c from the foot c(s), f = |o|^2/2 has f' = o p' and, since the foot moves, f'' =
/// |p'|^2 + o p'' - (p' c')^2/(1 - o c''). The change of the second derivative of |o| between the ends is
/// added as a margin for its values in between.
double ContourSearch::bend_from_helix(const Arc& arc, const PathDeviation::Foot& at_from,
                                      const PathDeviation::Foot& at_to, const ContourSpan& span) const {
  const auto second_derivative = [&arc](const PathDeviation::Foot& foot, const ContourCourse::Point& at) {
    const CurvePoint there = arc.at(foot.s);
    const Vec3& offset = foot.offset;
    const double distance = std::sqrt(foot.squared);
    const double along = at.d1.dot(there.d1);
    const double slope = offset.dot(at.d1) / distance;
    const double half_square =
        at.d1.squaredNorm() + offset.dot(at.d2) - along * along / (1 - offset.dot(there.d2));
    return (half_square - slope * slope) / distance;
  };
  const double from = second_derivative(at_from, span.from.point);
  const double to = second_derivative(at_to, span.to.point);
  const double bend = std::max(std::abs(from), std::abs(to)) + std::abs(to - from);
  return std::isfinite(bend) ? bend : std::numeric_limits<double>::infinity();
}

double ContourSearch::rise_above_chord(std::size_t index, const PathDeviation::Foot& at_from,
                                       const PathDeviation::Foot& at_to, const ContourSpan& span) const {
  const Toolpath& path = programmed_path(trajectory_);
  const Segment& segment = path.segments[index];
  const double step = span.to.place.u - span.from.place.u;
  const auto rise = [&](double bend) {
    return (bend + course_.bend_between(span.to.place.element, span.from.place.u, span.to.place.u, bend)) *
           step * step / 8;
  };
  if (segment.kind != SegmentKind::arc) {
    return rise(bend_from_line(index, at_from, at_to, span));
  }
  const Arc& arc = path.arc_of(segment);
  // The foot jumps from one end of an open circle to the other, or from turn to turn of a helix.
  const bool closed = arc.rise.isZero() && arc.sweep >= 2 * std::numbers::pi * (1 - 1e-12);
  if (!closed && std::abs(at_to.s - at_from.s) > std::numbers::pi * arc.length_per_radian()) {
    return std::numeric_limits<double>::infinity();
  }
  const auto is_inside = [&](const PathDeviation::Foot& foot) {
    return foot.s > 0 && foot.s < segment.length;
  };
  if (is_inside(at_from) && is_inside(at_to)) {
    return rise(arc.rise.isZero() ? bend_from_arc(arc, span) : bend_from_helix(arc, at_from, at_to, span));
  }
  const double chord = (span.to.point.position - span.from.point.position).norm();
  const double gap = std::sqrt(std::max(at_from.squared, at_to.squared));
  const double sag = sagitta(span.from, span.to);
  const double nearest = 1 / arc.curvature() - gap - chord - sag;
  return nearest > 0 ? sag + chord * chord / 8 / nearest : std::numeric_limits<double>::infinity();
}

/// Largest distance of a straight span from the flat arc that contains its feet, if it is at an end: the
/// distance from the axis is convex along the span. That is the case for halves of chords, each of which
/// would need many halvings with bounds by bends.
std::optional<double> ContourSearch::largest_on_chord(const ContourSpan& span) const {
  constexpr double rounding = 1e-10;  // [mm]
  const ContourNode& from = span.from;
  const ContourNode& to = span.to;
  const Toolpath& path = programmed_path(trajectory_);
  const Segment& segment = path.segments[from.foot.segment];
  if (segment.kind != SegmentKind::arc || trajectory_.path().kind(from.place.element) != ElementKind::line) {
    return std::nullopt;
  }
  const Arc& arc = path.arc_of(segment);
  const auto is_inside = [&](const ContourNode& node) {
    return (node.foot.s > 0 && node.foot.s < segment.length) || node.error < PathDeviation::as_near;
  };
  const bool turns_far = std::abs(to.foot.s - from.foot.s) > std::numbers::pi / 2 * arc.length_per_radian();
  if (!arc.rise.isZero(0) || turns_far || !is_inside(from) || !is_inside(to)) {
    return std::nullopt;
  }
  const Vec3 axis = arc.x.cross(arc.y);
  const Vec3 start = from.point.position - arc.center;
  const Vec3 along = to.point.position - from.point.position;
  const double beside = std::max(std::abs(start.dot(axis)), std::abs((start + along).dot(axis)));
  const Vec3 flat_start = start - start.dot(axis) * axis;
  const Vec3 flat_along = along - along.dot(axis) * axis;
  const double squared = flat_along.squaredNorm();
  const double share = squared > 0 ? std::clamp(-flat_start.dot(flat_along) / squared, 0.0, 1.0) : 0;
  const double inwards = std::max(arc.radius - (flat_start + share * flat_along).norm(), 0.0);
  const double at_ends = std::max(from.error, to.error);
  return std::hypot(inwards, beside) <= at_ends + rounding ? std::optional(at_ends) : std::nullopt;
}

/// On one arc at constant speed the filters produce another arc, at a constant distance.
bool ContourSearch::is_steady(const ContourSpan& span) const {
  constexpr double same = 1e-9;
  return span.from.point.steady && span.to.point.steady && std::abs(span.from.error - span.to.error) < same &&
         course_.block_seen(span.to.place.element, span.from.place.u, span.to.place.u) ==
             span.to.foot.segment;
}

double ContourSearch::bound_of(const ContourSpan& span) const {
  const ContourNode& from = span.from;
  const ContourNode& to = span.to;
  const std::size_t first = from.foot.segment;
  const std::size_t second = to.foot.segment;
  const double chord = (to.point.position - from.point.position).norm();
  const double never_above = (from.error + to.error + chord) / 2 + sagitta(from, to);
  if (first == second) {
    if (course_.is_on_one_line(to.place.element, from.place.u, to.place.u) || is_steady(span)) {
      return std::max(from.error, to.error);
    }
    if (const std::optional<double> largest = largest_on_chord(span)) {
      return *largest;
    }
    return std::min(std::max(from.error, to.error) + rise_above_chord(first, from.foot, to.foot, span),
                    never_above);
  }
  const PathDeviation::Foot first_at_to = deviation_.foot_on(first, to.point.position);
  const PathDeviation::Foot second_at_from = deviation_.foot_on(second, from.point.position);
  const double lower = largest_of_lower(from.error, std::sqrt(first_at_to.squared),
                                        std::sqrt(second_at_from.squared), to.error);
  const double rise = std::max(rise_above_chord(first, from.foot, first_at_to, span),
                               rise_above_chord(second, second_at_from, to.foot, span));
  return std::min(lower + rise, never_above);
}

void ContourSearch::for_spans(std::uint32_t first, std::uint32_t last, Progress* progress,
                              const std::function<void(const ContourSpan&)>& visit) {
  ProgressSteps steps(progress, std::max<std::size_t>(last - first, 1));
  ContourSpan span;
  bool goes_on = false;  // continues from an element that was not exact
  for (std::uint32_t element = first; element < last; ++element) {
    steps.at(element - first);
    course_.nodes(element, ends_);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const CoursePlace at{element, ends_[i]};
      if (i == 0 && !goes_on) {
        span.to = node(at);
      } else if (i == 0) {
        span.to.place = at;
        span.to.point = course_.at(at);
      } else {
        span.from = span.to;
        span.to = node(at);
        span.bound = bound_of(span);
        visit(span);
      }
    }
    goes_on = !ends_.empty();
  }
}

void ContourSearch::corner_spans(std::uint32_t element, std::vector<ContourSpan>& spans) {
  course_.corner_nodes(element, ends_);
  ContourSpan span;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    span.from = span.to;
    span.to = node({element, ends_[i]});
    if (i > 0) {
      span.bound = bound_of(span);
      spans.push_back(span);
    }
  }
}

double ContourSearch::largest_in(std::vector<ContourSpan>& spans, ContourNode& best) {
  std::size_t halvings = 1000 + 16 * spans.size();
  double left = 0;
  while (!spans.empty()) {
    const ContourSpan span = spans.back();
    spans.pop_back();
    if (span.bound <= best.error + precision) {
      continue;
    }
    const double middle = (span.from.place.u + span.to.place.u) / 2;
    if (halvings == 0 || !(middle > span.from.place.u && middle < span.to.place.u)) {
      left = std::max(left, span.bound);
      continue;
    }
    --halvings;
    const ContourNode half = node({span.from.place.element, middle});
    if (half.error > best.error) {
      best = half;
    }
    ContourSpan first{span.from, half, 0};
    ContourSpan second{half, span.to, 0};
    first.bound = std::min(bound_of(first), span.bound);
    second.bound = std::min(bound_of(second), span.bound);
    const bool second_first = second.bound > first.bound;  // process the more promising half first
    spans.push_back(second_first ? first : second);
    spans.push_back(second_first ? second : first);
  }
  return std::max(left, best.error + precision);
}

}  // namespace feedscope
