#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Tree of boxes around the segments of a programmed path, sorted by place: finds the segments near a place
/// without visiting the others.
///
/// A leaf contains up to eight consecutive segments, or a part of one that is long or turns far. The leaves
/// are sorted along a Z-order curve, and every four get a common box, level by level: 5 bytes per segment if
/// blocks have equal lengths, at most some 45, some 40 for every radian of a longer arc.
class SegmentTree {
 public:
  /// `toolpath` must outlive this.
  explicit SegmentTree(const Toolpath& toolpath);

  /// Calls `look(first, count)` for the segments of leaves whose box is nearer to `place` than the root of
  /// `squared` [mm2], roughly the nearest first. `look` returns the new value of `squared`, which never
  /// increases.
  template <typename Look>
  void search(const Vec3& place, double squared, const Look& look) const;

 private:
  static constexpr std::uint32_t fan_out = 4;
  static constexpr std::size_t max_levels = 17;  // 4^16 leaves

  /// Rounded outwards [mm].
  struct Box {
    std::array<float, 3> low;
    std::array<float, 3> high;
    void add(const Box& other);
    double squared_distance(const Vec3& place) const {
      double squared = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double at = place[static_cast<Eigen::Index>(i)];
        const double away =
            std::max({static_cast<double>(low[i]) - at, at - static_cast<double>(high[i]), 0.0});
        squared += away * away;
      }
      return squared;
    }
  };
  struct Leaf {
    std::uint32_t first;
    std::uint32_t count;
  };
  /// Node of a level; level 0 are the leaves.
  struct Node {
    std::uint32_t level;
    std::uint32_t index;
    double squared;
  };

  void make_leaves(const Toolpath& toolpath);
  void add_parts(const Toolpath& toolpath, std::uint32_t segment, std::uint32_t parts);
  void add_leaf(const Leaf& leaf, const Bounds& bounds);
  void sort_leaves();
  void make_levels();

  std::vector<Leaf> leaves_;
  std::vector<std::vector<Box>> levels_;
};

template <typename Look>
void SegmentTree::search(const Vec3& place, double squared, const Look& look) const {
  if (leaves_.empty()) {
    return;
  }
  std::array<Node, max_levels * fan_out> waiting;
  const auto top = static_cast<std::uint32_t>(levels_.size() - 1);
  waiting[0] = {top, 0, levels_[top][0].squared_distance(place)};
  std::size_t count = 1;
  while (count > 0) {
    const Node node = waiting[--count];
    if (node.squared >= squared) {
      continue;
    }
    if (node.level == 0) {
      squared = look(leaves_[node.index].first, leaves_[node.index].count);
      continue;
    }
    const std::vector<Box>& below = levels_[node.level - 1];
    const std::uint32_t first = node.index * fan_out;
    const auto end = std::min(first + fan_out, static_cast<std::uint32_t>(below.size()));
    const std::size_t bottom = count;
    for (std::uint32_t i = first; i < end; ++i) {
      const double away = below[i].squared_distance(place);
      if (away >= squared) {
        continue;
      }
      std::size_t at = count++;  // nearest on top
      for (; at > bottom && waiting[at - 1].squared < away; --at) {
        waiting[at] = waiting[at - 1];
      }
      waiting[at] = {node.level - 1, i, away};
    }
  }
}

}  // namespace feedscope
