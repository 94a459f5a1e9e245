#include "core/blend/compaction.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace feedscope {
namespace {

/// Rule for lines that may be merged.
class ChordRule {
 public:
  ChordRule(double longest, const PathRules& rules) : longest_(longest), rules_(&rules) {}
  ChordRule(const Toolpath& toolpath, double tolerance) : toolpath_(&toolpath), tolerance_(tolerance) {}

  double longest() const { return longest_; }  ///< of a chord and of any of its blocks [mm]
  double tolerance(std::size_t first) const {
    return rules_ != nullptr ? rules_->tolerance(first) : tolerance_;
  }
  bool joins(std::size_t first, std::size_t i) const {
    if (rules_ != nullptr) {
      return rules_->may_compact(first, i);
    }
    const Segment& a = toolpath_->segments[first];
    const Segment& b = toolpath_->segments[i];
    return a.path_control == b.path_control && a.spindle == b.spindle && !a.on_curve && !b.on_curve &&
           toolpath_->path_control_of(first).mode != PathMode::exact_stop;
  }

 private:
  double longest_ = std::numeric_limits<double>::infinity();
  const PathRules* rules_ = nullptr;  ///< null: collinear lines only
  const Toolpath* toolpath_ = nullptr;
  double tolerance_ = 0;
};

class Compactor {
 public:
  Compactor(const Toolpath& toolpath, const ChordRule& rule)
      : toolpath_(toolpath), longest_(rule.longest()), rule_(rule) {}

  /// Number of segments from `first` on to merge into one; 1 for none.
  std::size_t count_from(std::size_t first) const {
    if (!is_short(first)) {
      return 1;
    }
    std::size_t fits = 1;
    std::size_t fails = 2;
    while (deviation(first, fails)) {
      fits = fails;
      fails *= 2;
    }
    while (fails - fits > 1) {
      const std::size_t middle = (fits + fails) / 2;
      (deviation(first, middle) ? fits : fails) = middle;
    }
    return fits;
  }

  /// Largest distance of the points between `count` segments from their chord [mm]; none if the chord must
  /// not replace them.
  std::optional<double> deviation(std::size_t first, std::size_t count) const {
    constexpr double rounding = 1 + 1e-9;
    constexpr double min_cosine = 0.5;
    if (count > toolpath_.segments.size() - first) {
      return std::nullopt;
    }
    const Vec3& start = toolpath_.start_of(first);
    const Vec3 direction = (toolpath_.segments[first + count - 1].end - start).normalized();
    double length = 0;
    double largest = 0;
    double before = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      const Segment& segment = toolpath_.segments[i];
      length += segment.length;
      if (!is_short(i) || !rule_.joins(first, i) || segment.feed != toolpath_.segments[first].feed ||
          length > longest_ * rounding) {
        return std::nullopt;
      }
      const Vec3 way = segment.end - start;
      const double along = way.dot(direction);
      const double away = (way - along * direction).norm();
      if (away > rule_.tolerance(first) || along - before < min_cosine * segment.length) {
        return std::nullopt;
      }
      largest = std::max(largest, away);
      before = along;
    }
    return largest;
  }

 private:
  bool is_short(std::size_t i) const {
    const Segment& segment = toolpath_.segments[i];
    return segment.kind == SegmentKind::line && !segment.rapid && segment.length < longest_ &&
           toolpath_.segment_turn(i) == nullptr && toolpath_.turn_joint(i) == nullptr &&
           (i == 0 || toolpath_.turn_joint(i - 1) == nullptr);
  }

  const Toolpath& toolpath_;
  double longest_;
  const ChordRule& rule_;
};

CompactedPath with_chords(const Toolpath& toolpath, const ChordRule& rule) {
  const Compactor compactor(toolpath, rule);
  CompactedPath result;
  result.path.start = toolpath.start;
  result.path.arcs = toolpath.arcs;
  result.path.pauses = toolpath.pauses;
  result.path.bounds = toolpath.bounds;
  result.path.path_controls = toolpath.path_controls;
  result.path.spindles = toolpath.spindles;
  result.path.part = toolpath.part;
  result.path.turn_ceiling = toolpath.turn_ceiling;
  result.path.block_time = toolpath.block_time;
  for (std::size_t i = 0; i < toolpath.segments.size();) {
    const std::size_t count = compactor.count_from(i);
    Segment segment = toolpath.segments[i];
    if (count > 1) {
      segment.end = toolpath.segments[i + count - 1].end;
      segment.length = (segment.end - toolpath.start_of(i)).norm();
      result.deviation = std::max(result.deviation, compactor.deviation(i, count).value());
    }
    if (const SegmentTurn* turn = toolpath.segment_turn(i)) {
      result.path.segment_turns.push_back(*turn);
      result.path.segment_turns.back().segment = result.path.segments.size();
    }
    for (const TurnPart& part : toolpath.turn_parts_of(i)) {
      result.path.turn_parts.push_back(part);
      result.path.turn_parts.back().segment = result.path.segments.size();
    }
    if (const TurnJoint* joint = toolpath.turn_joint(i + count - 1)) {
      result.path.turn_joints.push_back(*joint);
      result.path.turn_joints.back().segment = result.path.segments.size();
    }
    result.path.segments.push_back(segment);
    result.first.push_back(static_cast<std::uint32_t>(i));
    i += count;
  }
  result.first.push_back(static_cast<std::uint32_t>(toolpath.segments.size()));
  return result;
}

}  // namespace

CompactedPath compact(const Toolpath& toolpath, double longest, const PathRules& rules) {
  return with_chords(toolpath, {longest, rules});
}

CompactedPath merge_collinear(const Toolpath& toolpath, double tolerance) {
  return with_chords(toolpath, {toolpath, tolerance});
}

}  // namespace feedscope
