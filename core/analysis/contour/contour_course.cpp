#include "core/analysis/contour/contour_course.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

constexpr double spans_a_filter_time = 8;
constexpr int spans_of_corner = 4;
constexpr int spans_of_block = 2;

void divide(double from, double to, int spans, std::vector<double>& ends) {
  for (int i = 0; i <= spans; ++i) {
    ends.push_back(from + (to - from) * i / spans);
  }
}

/// The only block in the filters meanwhile; none if there are several.
std::optional<std::size_t> only_block(const FilteredMotion& motion, double from, double to) {
  const PulseTrain& train = motion.train();
  const double rounding = 1e-9 * train.delay();
  const std::size_t first = train.block_at(from - motion.start() - train.delay() + rounding);
  const std::size_t last = train.block_at(to - motion.start() - rounding);
  const bool one = first == last || (first + 1 == last && last == train.size());
  return one ? std::optional(first) : std::nullopt;
}

bool sees_one_line(const FilteredMotion& motion, double from, double to) {
  const std::optional<std::size_t> block = only_block(motion, from, to);
  return block && motion.train().segment(*block).kind == SegmentKind::line;
}

/// Whether an executed arc is on the programmed one: others are inserted by the control.
bool is_programmed_arc(const BlendedPath& path, std::uint32_t element, const Arc& arc) {
  constexpr double same = 1e-9;  // [mm]
  const Toolpath& programmed = *path.programmed();
  const Segment& block = programmed.segments[path.segment(element)];
  if (block.kind != SegmentKind::arc) {
    return false;
  }
  const Arc& own = programmed.arc_of(block);
  const Vec3 axis = own.x.cross(own.y);
  const Vec3 apart = arc.center - own.center;
  return std::abs(arc.radius - own.radius) <= same && (arc.rise - own.rise).norm() <= same &&
         (arc.x.cross(arc.y) - axis).norm() * arc.radius <= same &&
         (apart - apart.dot(axis) * axis).norm() <= same;
}

}  // namespace

ContourCourse::ContourCourse(const Trajectory& trajectory)
    : trajectory_(trajectory),
      plain_corners_(trajectory.path().empty() ||
                     &trajectory.path().base() == trajectory.path().programmed().get()),
      curve_element_(std::numeric_limits<std::uint32_t>::max()) {}

const ElementCurve& ContourCourse::curve(std::uint32_t element) {
  if (element != curve_element_) {
    curve_ = trajectory_.path().curve(element);
    curve_element_ = element;
  }
  return curve_;
}

void ContourCourse::nodes(std::uint32_t element, std::vector<double>& ends) {
  ends.clear();
  const BlendedPath& path = trajectory_.path();
  switch (path.kind(element)) {
    case ElementKind::filtered:
      filtered_nodes(element, ends);
      break;
    case ElementKind::fitted:
      for (const CourseKnot& knot : curve(element).course) {
        if (!ends.empty()) {
          ends.push_back((ends.back() + knot.s) / 2);
        }
        ends.push_back(knot.s);
      }
      break;
    case ElementKind::curve:
      curve_nodes(element, ends);
      break;
    case ElementKind::blend:
    case ElementKind::connecting_arc:
      if (!plain_corners_) {
        corner_nodes(element, ends);
      }
      break;
    case ElementKind::line:
      if (!plain_corners_) {
        compacted_nodes(element, ends);
      }
      break;
    case ElementKind::arc:
      if (path.is_executed() && !is_programmed_arc(path, element, curve(element).arc)) {
        corner_nodes(element, ends);
      }
      break;
    case ElementKind::dwell:
      break;
  }
}

/// At least two spans for each block on the curve.
void ContourCourse::curve_nodes(std::uint32_t element, std::vector<double>& ends) const {
  const BlendedPath& path = trajectory_.path();
  const std::uint32_t first = path.segment(element);
  const std::uint32_t next = element + 1 < path.size() ? path.segment(element + 1) : first;
  const auto blocks = static_cast<int>(std::max(next, first) - first) + 1;
  divide(0, path.length(element), std::max(spans_of_corner, blocks * spans_of_block), ends);
}

void ContourCourse::corner_nodes(std::uint32_t element, std::vector<double>& ends) const {
  const BlendedPath& path = trajectory_.path();
  ends.clear();
  divide(0, path.kind(element) == ElementKind::blend ? 1 : path.length(element), spans_of_corner, ends);
}

void ContourCourse::filtered_nodes(std::uint32_t element, std::vector<double>& ends) {
  const auto& pieces = trajectory_.pieces();
  const FilteredMotion& motion = trajectory_.motion_of(element);
  while (piece_ < pieces.size() && pieces[piece_].element < element) {
    ++piece_;
  }
  for (; piece_ < pieces.size() && pieces[piece_].element == element; ++piece_) {
    const double from = pieces[piece_].time;
    const double to = trajectory_.piece_end(piece_);
    if (!(to > from)) {
      continue;
    }
    if (ends.empty()) {
      ends.push_back(from);
    }
    divide_filtered(motion, from, to, ends);
  }
}

/// Long parts are mostly steady: there the ends are the instants between which the motion is one polynomial.
void ContourCourse::divide_filtered(const FilteredMotion& motion, double from, double to,
                                    std::vector<double>& ends) {
  constexpr double long_delays = 4;
  const PulseTrain& train = motion.train();
  const auto divide_evenly = [&](double begin, double end) {
    const double share = (end - begin) / motion.filter_time() * spans_a_filter_time;
    const int spans = sees_one_line(motion, begin, end) ? 1 : static_cast<int>(std::ceil(share));
    for (int i = 1; i < spans; ++i) {
      ends.push_back(begin + (end - begin) * i / spans);
    }
    ends.push_back(end);
  };
  if (to - from < long_delays * train.delay()) {
    divide_evenly(from, to);
    return;
  }
  // Far from the start of the program the clock does not resolve shorter steps.
  const double least = std::max(1e-9 * train.delay(), 8 * std::numeric_limits<double>::epsilon() * to);
  for (double begin = from; begin < to;) {
    const double knot = motion.start() + filters_.next_knot(train, begin - motion.start());
    const double end = to - knot > least ? std::max(knot, begin + least) : to;
    if (filters_.is_settled()) {
      ends.push_back(end);
    } else {
      divide_evenly(begin, end);
    }
    begin = end;
  }
}

/// A chord may consist of several elements, each for some of its blocks; for a single block it is the block
/// itself.
void ContourCourse::compacted_nodes(std::uint32_t element, std::vector<double>& ends) const {
  const BlendedPath& path = trajectory_.path();
  const auto blocks = static_cast<std::uint32_t>(path.programmed()->segments.size());
  const std::uint32_t first = path.segment(element);
  if (path.is_executed()) {
    executed_nodes(element, ends);
    return;
  }
  const std::size_t chord = path.base_segment(first);
  std::uint32_t limit = blocks;
  if (element + 1 < path.size()) {
    const std::uint32_t next = path.segment(element + 1);
    limit = path.in_corner(element + 1) ? next + 1 : next;
  }
  std::uint32_t end = first + 1;
  while (end < limit && path.base_segment(end) == chord) {
    ++end;
  }
  const bool several = end - first > 1 || (first > 0 && path.base_segment(first - 1) == chord) ||
                       (end < blocks && path.base_segment(end) == chord);
  if (several) {
    divide(0, path.length(element), static_cast<int>(end - first) * spans_of_block, ends);
  }
}

/// A line of the executed path replaces a part of a block, or several blocks; if it is the block itself it
/// needs no nodes.
void ContourCourse::executed_nodes(std::uint32_t element, std::vector<double>& ends) const {
  const BlendedPath& path = trajectory_.path();
  const Toolpath& programmed = *path.programmed();
  const std::uint32_t first = path.segment(element);
  const ElementCurve line = path.curve(element);
  const Segment& block = programmed.segments[first];
  if (block.kind == SegmentKind::line && line.end == block.end && line.start == programmed.start_of(first)) {
    return;
  }
  std::uint32_t before = first;
  if (element > 0 && path.segment(element - 1) < first) {
    before = path.segment(element - 1) + 1;
  }
  divide(0, path.length(element), static_cast<int>(first - before + 1) * spans_of_block, ends);
}

ContourCourse::Point ContourCourse::at(const CoursePlace& place) {
  if (trajectory_.path().kind(place.element) == ElementKind::filtered) {
    const FilteredMotion& motion = trajectory_.motion_of(place.element);
    const Kinematics there = filters_.motion_at(motion.train(), place.u - motion.start());
    return {there.position, there.velocity, there.acceleration, filters_.is_settled()};
  }
  const ElementCurve& here = curve(place.element);
  const CurvePoint there = here.kind == ElementKind::blend ? here.blend.at(place.u) : here.at(place.u);
  return {there.position, there.d1, there.d2, false};
}

/// On filtered motion the velocities of the pulses are at most F = largest_feed, so the filters keep |p'''|
/// <= 4 F/T1^2 (n = 2) and |p''''| <= 8 F/T1^3 (n = 3), which bounds the deviation of the acceleration from
/// the chord of its values. On a blend it is linear in u, on an arc its amount is constant. A fitted course
/// is within 1e-6 mm of filtered motion, whose curvature peaks little between knots; the curvature of a
/// smooth curve is that of a cubic spline, of which a span is several steps.
double ContourCourse::bend_between(std::uint32_t element, double from, double to, double at_ends) const {
  constexpr double between_knots = 0.25;
  switch (trajectory_.path().kind(element)) {
    case ElementKind::filtered: {
      const PulseTrain& train = trajectory_.motion_of(element).train();
      const double share = (to - from) / train.filter_time;
      const double change = train.largest_feed / train.filter_time;
      return train.filters == 2 ? 2 * change * share : change * share * share;
    }
    case ElementKind::fitted:
    case ElementKind::curve:
      return between_knots * at_ends;
    default:
      return 0;
  }
}

std::optional<std::size_t> ContourCourse::block_seen(std::uint32_t element, double from, double to) const {
  if (trajectory_.path().kind(element) != ElementKind::filtered) {
    return std::nullopt;
  }
  const FilteredMotion& motion = trajectory_.motion_of(element);
  const std::optional<std::size_t> block = only_block(motion, from, to);
  return block ? std::optional(trajectory_.path().first_block(motion.train().first + *block)) : std::nullopt;
}

bool ContourCourse::is_on_one_line(std::uint32_t element, double from, double to) const {
  const BlendedPath& path = trajectory_.path();
  return path.kind(element) == ElementKind::filtered &&
         path.blocks_of_base(path.base_segment_of(element)) == 1 &&
         sees_one_line(trajectory_.motion_of(element), from, to);
}

double ContourCourse::path_length(const CoursePlace& at) {
  const double start = trajectory_.path().s(at.element);
  switch (trajectory_.path().kind(at.element)) {
    case ElementKind::filtered:
      return trajectory_.state(at.u).path_length;
    case ElementKind::blend:
      return start + curve(at.element).blend.length_to(at.u);
    default:
      return start + at.u;
  }
}

double ContourCourse::time(const CoursePlace& at) {
  return trajectory_.path().kind(at.element) == ElementKind::filtered
             ? at.u
             : trajectory_.state_at_path(path_length(at)).time;
}

}  // namespace feedscope
