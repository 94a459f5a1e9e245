#include "core/analysis/time/slow_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "core/base/exact_sum.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

const double least_turn = units::from_deg(1);  // of a corner [rad]
constexpr double most_of_it = 0.8;             // of a group's loss: from here one axis is its cause
constexpr double at_border = 1e-3;             // of an element's length
constexpr double close_to_corner = 1 / 2.0;    // of an element's length, over which filters spread a stop

/// In the order of PlaceShape.
constexpr std::array<PlaceShapeInfo, place_shape_count> shapes{{
    {"corner", QT_TRANSLATE_NOOP("core", "corners"), QT_TRANSLATE_NOOP("core", "turn"), Dimension::angle},
    {"arc", QT_TRANSLATE_NOOP("core", "arcs"), QT_TRANSLATE_NOOP("core", "radius"), Dimension::length},
    {"line", QT_TRANSLATE_NOOP("core", "lines"), QT_TRANSLATE_NOOP("core", "block length"),
     Dimension::length},
    {"curve", QT_TRANSLATE_NOOP("core", "smooth curves"), "", Dimension::length},
    {"rapid", QT_TRANSLATE_NOOP("core", "rapids"), QT_TRANSLATE_NOOP("core", "block length"),
     Dimension::length},
    {"stop", QT_TRANSLATE_NOOP("core", "starts and stops"), "", Dimension::length},
}};

/// Shape of the path at one instant.
struct Shape {
  PlaceShape shape = PlaceShape::line;
  double measure = 0;  ///< as SlowGroup::median
};

class ShapeFinder {
 public:
  explicit ShapeFinder(const Trajectory& trajectory) : trajectory_(trajectory), path_(trajectory.path()) {}

  Shape at(double time) const {
    const std::size_t piece = trajectory_.piece_at(time);
    PartWalk walk(trajectory_, piece, time - trajectory_.pieces()[piece].time);
    const std::uint32_t element = walk.done() ? last_element() : walk.part().element;
    if (path_.kind(element) == ElementKind::dwell) {
      return {PlaceShape::stop, 0};
    }
    if (trajectory_.is_rapid(element)) {
      return {PlaceShape::rapid, segment_of(element).length};
    }
    if (path_.in_corner(element)) {
      const std::size_t segment = path_.base_segment_of(element);
      return {PlaceShape::corner, turn_between(segment, segment + 1)};
    }
    if (is_corner_arc(element)) {
      return {PlaceShape::corner, corner_arc_turn(element)};
    }
    const double length = path_.length(element);
    const double from_start = walk.done() ? length : place_in(walk);
    const bool filtered = path_.kind(element) == ElementKind::filtered;
    const double near = length * (filtered ? close_to_corner : at_border);
    if (from_start <= near) {
      if (const auto found = junction(element, -1)) {
        return *found;
      }
    }
    if (length - from_start <= near) {
      if (const auto found = junction(element, +1)) {
        return *found;
      }
    }
    return along(element);
  }

 private:
  std::uint32_t last_element() const { return static_cast<std::uint32_t>(path_.size() - 1); }
  const Segment& segment_of(std::uint32_t element) const {
    return path_.base().segments[path_.base_segment_of(element)];
  }

  /// Whether an open control inserted an arc that the program does not have.
  bool is_corner_arc(std::uint32_t element) const {
    return path_.is_executed() && segment_of(element).kind == SegmentKind::arc &&
           path_.programmed()->segments[path_.segment(element)].kind != SegmentKind::arc;
  }
  double corner_arc_turn(std::uint32_t element) const {
    return path_.length(element) / path_.base().arc_of(segment_of(element)).length_per_radian();
  }

  /// Distance from the start of an element to the start of the part [mm].
  double place_in(PartWalk& walk) const {
    const Part& part = walk.part();
    return part.law == Law::path_length ? part.q : walk.motion().state(0).path_length - path_.s(part.element);
  }

  double turn_between(std::size_t segment, std::size_t next) const {
    const Toolpath& base = path_.base();
    if (next >= base.segments.size()) {
      return 0;
    }
    const Vec3 in = base.tangent_at_end(segment);
    const Vec3 out = base.tangent_at_start(next);
    return std::atan2(in.cross(out).norm(), in.dot(out));
  }

  /// Shape at the start (-1) or the end (+1) of `element`; none where the path continues smoothly.
  std::optional<Shape> junction(std::uint32_t element, int side) const {
    if ((side < 0 && element == 0) || (side > 0 && element == last_element())) {
      return Shape{PlaceShape::stop, 0};
    }
    const auto other = static_cast<std::uint32_t>(static_cast<std::int64_t>(element) + side);
    if (path_.kind(other) == ElementKind::dwell) {
      return Shape{PlaceShape::stop, 0};
    }
    if (path_.in_corner(other)) {
      const std::size_t segment = path_.base_segment_of(other);
      return Shape{PlaceShape::corner, turn_between(segment, segment + 1)};
    }
    if (is_corner_arc(other)) {
      return Shape{PlaceShape::corner, corner_arc_turn(other)};
    }
    const std::uint32_t before = side < 0 ? other : element;
    const std::uint32_t behind = side < 0 ? element : other;
    if (is_smooth(before) || is_smooth(behind)) {
      return std::nullopt;
    }
    const double turn = turn_between(path_.base_segment_of(before), path_.base_segment_of(behind));
    if (turn >= least_turn) {
      return Shape{PlaceShape::corner, turn};
    }
    if (!trajectory_.is_rapid(other) && segment_of(other).kind == SegmentKind::arc &&
        segment_of(element).kind != SegmentKind::arc) {
      return along(other);
    }
    return std::nullopt;
  }

  bool is_smooth(std::uint32_t element) const {
    return path_.kind(element) == ElementKind::curve || path_.kind(element) == ElementKind::fitted;
  }

  Shape along(std::uint32_t element) const {
    if (path_.kind(element) == ElementKind::curve) {
      return {PlaceShape::curve, 0};
    }
    const Segment& segment = segment_of(element);
    return segment.kind == SegmentKind::arc ? Shape{PlaceShape::arc, path_.base().arc_of(segment).radius}
                                            : Shape{PlaceShape::line, segment.length};
  }

  const Trajectory& trajectory_;
  const BlendedPath& path_;
};

/// Slowest instant strictly within a place [s]: a place that ends at a rapid may be slowest at its end, which
/// already belongs to the rapid.
double instant_of(const SlowPlace& place) {
  constexpr double within = 1e-9;                                         // of its time
  constexpr double digits = 16 * std::numeric_limits<double>::epsilon();  // of a sum of times
  const double margin = std::max(within * (place.to - place.from), digits * place.to);
  return std::min(place.slowest, std::max(place.from, place.to - margin));
}

/// Splits a place by the kinds of cause that take at least a hundredth of its loss.
class PartsByKind {
 public:
  /// The place once per kind, with the loss of the kind and its most important cause; valid until the next
  /// call.
  std::span<const SlowPlace> of(const SlowPlace& place, std::span<const std::pair<Cause, double>> losses) {
    constexpr double least_share = 0.01;
    parts_.clear();
    most_.clear();
    for (const auto& [cause, loss] : losses) {
      add(place, cause, loss);
    }
    std::erase_if(parts_, [&](const SlowPlace& part) { return part.loss < least_share * place.loss; });
    return parts_;
  }

 private:
  void add(const SlowPlace& place, Cause cause, double loss) {
    const auto known =
        std::ranges::find(parts_, cause.kind, [](const SlowPlace& part) { return part.cause.kind; });
    const auto kind = static_cast<std::size_t>(known - parts_.begin());
    if (known == parts_.end()) {
      parts_.push_back(place);
      parts_.back().loss = 0;
      parts_.back().cause = cause;
      most_.push_back(loss);
    }
    parts_[kind].loss += loss;
    if (loss > most_[kind]) {
      most_[kind] = loss;
      parts_[kind].cause = cause;
    }
  }

  std::vector<SlowPlace> parts_;
  std::vector<double> most_;  ///< largest loss of one cause of the kind [s]
};

/// Sums of the losses of one kind of cause on one shape of path, while stretches come in.
struct GroupSums {
  SlowGroup group;
  ExactSum loss;
  std::vector<float> measures;
  std::map<int, double> by_axis;

  void add_place(const SlowPlace& place, const Shape& shape) {
    if (group.count == 0) {
      group.shape = shape.shape;
      group.kind = place.cause.kind;
      group.first_line = place.first_line;
    }
    ++group.count;
    group.first_line = std::min(group.first_line, place.first_line);
    group.last_line = std::max(group.last_line, place.last_line);
    measures.push_back(static_cast<float>(shape.measure));
    group.worst.push_back(place);
    if (group.worst.size() >= 4 * SlowGroups::worst_places) {
      keep_worst();
    }
  }

  /// `lost`: below 0 for a gain.
  void add_loss(const Cause& cause, double lost) {
    loss.add(lost);
    by_axis[cause.axis] += lost;
  }

  bool is_group() const { return group.count > 0 && loss.value() > 0; }

  SlowGroup finish() {
    keep_worst();
    const auto most = std::ranges::max_element(by_axis, {}, [](const auto& entry) { return entry.second; });
    group.loss = loss.value();
    group.cause.kind = group.kind;
    if (most->second > most_of_it * group.loss) {
      group.cause.axis = static_cast<std::int8_t>(most->first);
    }
    const auto middle = measures.begin() + static_cast<std::ptrdiff_t>(measures.size() / 2);
    std::ranges::nth_element(measures, middle);
    group.median = static_cast<double>(*middle);
    const auto [smallest, largest] = std::ranges::minmax_element(measures);
    group.smallest = static_cast<double>(*smallest);
    group.largest = static_cast<double>(*largest);
    return std::move(group);
  }

 private:
  void keep_worst() {
    std::ranges::stable_sort(group.worst, std::greater(), &SlowPlace::loss);
    group.worst.resize(std::min(group.worst.size(), SlowGroups::worst_places));
  }
};

/// Gains of causes outside of any group: the feed of short segments, alternately above and below the
/// programmed feed, is a loss at corners and a gain along the lines between them.
class Gains {
 public:
  void add(PlaceShape shape, CauseKind kind, double loss) {
    gains_[{shape == PlaceShape::rapid, kind}].add(loss);
  }

  /// Subtracts the gains from the groups with the same cause, each by its share of their loss.
  void take_from(std::vector<SlowGroup>& groups) const {
    for (const auto& [key, gain] : gains_) {
      const auto is_like = [&like = key](const SlowGroup& group) {
        return std::pair(group.shape == PlaceShape::rapid, group.kind) == like;
      };
      ExactSum lost;
      for (const SlowGroup& group : groups) {
        lost.add(is_like(group) ? group.loss : 0);
      }
      const double left = lost.value() > 0 ? std::max(0.0, 1 + gain.value() / lost.value()) : 0;
      for (SlowGroup& group : groups) {
        group.loss *= is_like(group) ? left : 1;
      }
    }
  }

 private:
  std::map<std::pair<bool, CauseKind>, ExactSum> gains_;  ///< key: whether it is a rapid; below 0 [s]
};

}  // namespace

const PlaceShapeInfo& info_of(PlaceShape shape) {
  return shapes[static_cast<std::size_t>(shape)];
}

std::string lost_to(const SlowGroup& group) {
  return group.kind == CauseKind::programmed_feed
             ? QT_TRANSLATE_NOOP("core", "slowing for a lower programmed feed")
             : cause_title(group.cause);
}

SlowGroups find_slow_groups(const Trajectory& trajectory, Progress* progress) {
  SlowGroups found;
  const ShapeFinder shapes_of(trajectory);
  PartsByKind parts;
  std::map<std::pair<PlaceShape, CauseKind>, GroupSums> groups;
  found.loss = for_slow_stretches(
      trajectory,
      [&](const SlowPlace& stretch, bool is_place, std::span<const std::pair<Cause, double>> losses) {
        const Shape shape = shapes_of.at(instant_of(stretch));
        for (const auto& [cause, loss] : losses) {
          groups[{shape.shape, cause.kind}].add_loss(cause, loss);
        }
        if (is_place) {
          for (const SlowPlace& part : parts.of(stretch, losses)) {
            groups[{shape.shape, part.cause.kind}].add_place(part, shape);
          }
        }
      },
      progress);
  Gains gains;
  for (auto& [key, sums] : groups) {
    if (sums.is_group()) {
      found.groups.push_back(sums.finish());
    } else if (sums.loss.value() < 0) {
      gains.add(key.first, key.second, sums.loss.value());
    }
  }
  gains.take_from(found.groups);
  std::erase_if(found.groups, [](const SlowGroup& group) { return !(group.loss > 0); });
  ExactSum grouped;
  for (const SlowGroup& group : found.groups) {
    grouped.add(group.loss);
  }
  std::ranges::stable_sort(found.groups, std::greater(), &SlowGroup::loss);
  found.other = found.loss - grouped.value();
  return found;
}

}  // namespace feedscope
