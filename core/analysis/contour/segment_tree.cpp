#include "core/analysis/contour/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace feedscope {
namespace {

constexpr std::uint32_t max_in_leaf = 8;
constexpr double max_lengths = 2;  // average lengths, of an undivided segment
constexpr double max_turn = 2;     // of an undivided arc [rad]
constexpr double part_turn = 1;

float rounded_down(double value) {
  const auto near = static_cast<float>(value);
  return static_cast<double>(near) <= value ? near
                                            : std::nextafter(near, -std::numeric_limits<float>::infinity());
}

float rounded_up(double value) {
  return -rounded_down(-value);
}

/// Upper bound of the distance of an arc's points from their chord: its sagitta, or half its length.
double bulge(const Arc& arc, double length) {
  const double turn = std::min(length / arc.length_per_radian(), 2 * std::numbers::pi);
  return std::min(length / 2, arc.radius * (1 - std::cos(turn / 2)));
}

Bounds widened(Bounds bounds, double by) {
  bounds.min.array() -= by;
  bounds.max.array() += by;
  return bounds;
}

Bounds bounds_of(const Vec3& from, const Vec3& to) {
  Bounds bounds;
  bounds.add(from);
  bounds.add(to);
  return bounds;
}

/// Bounds of an arc from `from` to `to` along it [mm].
Bounds bounds_of(const Arc& arc, double from, double to) {
  // Rounding of places far from the centre.
  const double rounding = 1e-12 * (arc.radius + arc.center.cwiseAbs().maxCoeff());
  return widened(bounds_of(arc.at(from).position, arc.at(to).position), bulge(arc, to - from) + rounding);
}

/// Number of parts of a segment: long lines and arcs with large turns have mostly empty boxes.
std::uint32_t parts_of(const Toolpath& toolpath, const Segment& segment, double longest) {
  double parts = segment.length > longest ? segment.length / longest : 1;
  if (segment.kind == SegmentKind::arc) {
    const double turn = toolpath.arc_of(segment).sweep;
    parts = std::max(parts, turn > max_turn ? turn / part_turn : 1);
  }
  return static_cast<std::uint32_t>(std::ceil(parts));
}

/// Spreads the lowest 21 bits to every third bit.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1FFFFFU;
  bits = (bits | bits << 32U) & 0x001F00000000FFFFU;
  bits = (bits | bits << 16U) & 0x001F0000FF0000FFU;
  bits = (bits | bits << 8U) & 0x100F00F00F00F00FU;
  bits = (bits | bits << 4U) & 0x10C30C30C30C30C3U;
  return (bits | bits << 2U) & 0x1249249249249249U;
}

}  // namespace

void SegmentTree::Box::add(const Box& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

SegmentTree::SegmentTree(const Toolpath& toolpath) {
  make_leaves(toolpath);
  sort_leaves();
  make_levels();
}

void SegmentTree::make_leaves(const Toolpath& toolpath) {
  const auto segments = static_cast<std::uint32_t>(toolpath.segments.size());
  const double average = toolpath.length() / std::max<std::uint32_t>(segments, 1);
  const double longest = max_lengths * average;
  levels_.emplace_back();
  Leaf leaf{0, 0};
  Bounds bounds;
  double length = 0;
  const auto close = [&](std::uint32_t next) {
    if (leaf.count > 0) {
      add_leaf(leaf, bounds);
    }
    leaf = {next, 0};
    bounds = {};
    length = 0;
  };
  for (std::uint32_t i = 0; i < segments; ++i) {
    const Segment& segment = toolpath.segments[i];
    if (leaf.count == max_in_leaf || length > max_in_leaf * average) {
      close(i);
    }
    if (const std::uint32_t parts = parts_of(toolpath, segment, longest); parts > 1) {
      close(i);
      add_parts(toolpath, i, parts);
      close(i + 1);
      continue;
    }
    const Bounds own = segment.kind == SegmentKind::arc
                           ? bounds_of(toolpath.arc_of(segment), 0, segment.length)
                           : bounds_of(toolpath.start_of(i), segment.end);
    bounds.add(own.min);
    bounds.add(own.max);
    length += segment.length;
    ++leaf.count;
  }
  close(segments);
}

void SegmentTree::add_parts(const Toolpath& toolpath, std::uint32_t segment, std::uint32_t parts) {
  const Segment& whole = toolpath.segments[segment];
  const Vec3& start = toolpath.start_of(segment);
  const auto place = [&](std::uint32_t part) -> Vec3 {
    return part == parts ? whole.end : start + part * ((whole.end - start) / parts);
  };
  for (std::uint32_t i = 0; i < parts; ++i) {
    const double step = whole.length / parts;
    add_leaf({segment, 1}, whole.kind == SegmentKind::arc
                               ? bounds_of(toolpath.arc_of(whole), i * step, (i + 1) * step)
                               : bounds_of(place(i), place(i + 1)));
  }
}

void SegmentTree::add_leaf(const Leaf& leaf, const Bounds& bounds) {
  leaves_.push_back(leaf);
  Box& box = levels_[0].emplace_back();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    box.low[i] = rounded_down(bounds.min[axis]);
    box.high[i] = rounded_up(bounds.max[axis]);
  }
}

void SegmentTree::sort_leaves() {
  if (leaves_.empty()) {
    return;
  }
  std::vector<Box>& boxes = levels_[0];
  Box all = boxes.front();
  for (const Box& box : boxes) {
    all.add(box);
  }
  double extent = std::numeric_limits<double>::min();
  for (std::size_t i = 0; i < 3; ++i) {
    extent = std::max(extent, static_cast<double>(all.high[i]) - static_cast<double>(all.low[i]));
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(boxes.size());
  for (const Box& box : boxes) {
    std::uint64_t place = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double middle = (static_cast<double>(box.low[i]) + static_cast<double>(box.high[i])) / 2;
      const double share = (middle - static_cast<double>(all.low[i])) / extent;
      constexpr double cells = 0x1FFFFF;
      place |= spread(static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * cells)) << i;
    }
    order.emplace_back(place, static_cast<std::uint32_t>(order.size()));
  }
  std::ranges::sort(order);
  std::vector<Leaf> leaves;
  std::vector<Box> sorted;
  leaves.reserve(order.size());
  sorted.reserve(order.size());
  for (const auto& [place, index] : order) {
    leaves.push_back(leaves_[index]);
    sorted.push_back(boxes[index]);
  }
  leaves_ = std::move(leaves);
  boxes = std::move(sorted);
}

void SegmentTree::make_levels() {
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> level;
    level.reserve(below.size() / fan_out + 1);
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (i % fan_out == 0) {
        level.push_back(below[i]);
      } else {
        level.back().add(below[i]);
      }
    }
    levels_.push_back(std::move(level));
  }
}

}  // namespace feedscope
