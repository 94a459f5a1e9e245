#include "core/compressor/smoothing_run.h"

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"

namespace feedscope {
namespace {

class RunFinder {
 public:
  RunFinder(const Toolpath& toolpath, std::size_t first, std::size_t last, const PathRules& rules,
            const CompressorRule& rule, const std::vector<std::size_t>& corners)
      : toolpath_(toolpath), first_(first), last_(last), rules_(rules), rule_(rule), corners_(corners) {}

  std::vector<SmoothingRun> find() {
    std::vector<SmoothingRun> runs;
    for (std::size_t i = first_; i + 1 < last_;) {
      if (const std::size_t end = end_of_curve(i); end > i) {
        runs.push_back({i, end, 0, toolpath_.segments[end].length, i == first_, end + 1 == last_, true});
        i = end;
        continue;
      }
      if (!rule_.lines) {
        ++i;
        continue;
      }
      std::size_t end = i;
      bool bends = false;
      while (end + 1 < last_ && (end == i || !is_long(end)) && is_smoothed(end + 1, bends)) {
        ++end;
      }
      std::size_t from = i;
      std::size_t to = end;
      for (; from < to && is_tiny(from); ++from) {
      }
      for (; to > from && is_tiny(to); --to) {
      }
      if (to > from && bends) {
        runs.push_back({from, to, begin_on(from), end_on(to), begins_at_rest(from), ends_at_rest(to)});
      }
      i = std::max(end, i + 1);
    }
    return runs;
  }

 private:
  /// Last segment of the program's curve that begins with `i` or contains it; `i` if there is none.
  std::size_t end_of_curve(std::size_t i) const {
    std::size_t end = i;
    while (end + 1 < last_ && toolpath_.segments[end].on_curve && toolpath_.segments[end + 1].on_curve &&
           junction_kind(toolpath_, end + 1) == JunctionKind::pass) {
      ++end;
    }
    return end;
  }

  bool is_long(std::size_t i) const { return toolpath_.segments[i].length > rule_.longest_block; }

  /// Whether it is too short for its direction to be that of the path.
  bool is_tiny(std::size_t i) const { return toolpath_.segments[i].length < 2 * rules_.tolerance(i); }

  /// Whether the junction before segment `i` is smoothed; sets `bends` if it turns.
  bool is_smoothed(std::size_t i, bool& bends) {
    const Segment& before = toolpath_.segments[i - 1];
    const Segment& after = toolpath_.segments[i];
    if (before.on_curve || after.on_curve || before.kind != SegmentKind::line ||
        after.kind != SegmentKind::line || before.rapid || after.rapid ||
        !rules_.may_compress(i - 1, i, rule_.everywhere)) {
      return false;
    }
    while (next_corner_ < corners_.size() && corners_[next_corner_] < i) {
      ++next_corner_;
    }
    if (next_corner_ < corners_.size() && corners_[next_corner_] == i) {
      return false;
    }
    const Vec3 in = toolpath_.tangent_at_end(i - 1);
    const Vec3 out = toolpath_.tangent_at_start(i);
    const double half_sine = (out - in).norm() / 2;
    if (half_sine > std::sin(rule_.largest_turn / 2) || in.dot(out) <= 0) {
      return false;
    }
    const double shorter = std::min({before.length, after.length, rule_.longest_block});
    const double transition = 4 * rules_.corner_tolerance(i - 1) / 1.5;  // times half_sine
    if (transition <= half_sine * shorter / 2) {
      return false;
    }
    bends = bends || half_sine > straight_angle / 2;
    return true;
  }

  double room(std::size_t i) const { return std::min(toolpath_.segments[i].length, rule_.longest_block) / 2; }
  bool begins_at_rest(std::size_t i) const { return i == first_ && !is_long(i); }
  bool ends_at_rest(std::size_t i) const { return i + 1 == last_ && !is_long(i); }
  double begin_on(std::size_t i) const {
    return begins_at_rest(i) ? 0 : toolpath_.segments[i].length - room(i);
  }
  double end_on(std::size_t i) const { return ends_at_rest(i) ? toolpath_.segments[i].length : room(i); }

  const Toolpath& toolpath_;
  std::size_t first_;
  std::size_t last_;
  const PathRules& rules_;
  const CompressorRule& rule_;
  const std::vector<std::size_t>& corners_;
  std::size_t next_corner_ = 0;
};

}  // namespace

std::vector<SmoothingRun> find_smoothing_runs(const Toolpath& toolpath, std::size_t first, std::size_t last,
                                              const PathRules& rules, const CompressorRule& rule,
                                              const std::vector<std::size_t>& corners) {
  return RunFinder(toolpath, first, last, rules, rule, corners).find();
}

}  // namespace feedscope
