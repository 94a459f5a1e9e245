#include "core/analysis/difference/toolpath_match.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace feedscope {
namespace {

constexpr double steps_a_mm = 1e4;
constexpr double steps_a_second = 1e6;
constexpr int most_levels = 24;

/// Identity of a motion in 64 bits: two different ones among a million collide with a probability of 3e-8.
class Fingerprint {
 public:
  void add(std::int64_t value) {
    std::uint64_t x = state_ ^ static_cast<std::uint64_t>(value);
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    state_ = x ^ (x >> 31U);
  }
  void add(double value, double steps) { add(static_cast<std::int64_t>(std::llround(value * steps))); }
  void add(const Vec3& place) {
    for (int axis = 0; axis < 3; ++axis) {
      add(place[axis], steps_a_mm);
    }
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15ULL;
};

std::vector<std::uint64_t> fingerprints(const Toolpath& path) {
  std::vector<std::uint64_t> prints;
  prints.reserve(path.segments.size());
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    Fingerprint print;
    print.add(static_cast<std::int64_t>(segment.kind) * 2 + (segment.rapid ? 1 : 0));
    print.add(path.start_of(i));
    print.add(segment.end);
    print.add(segment.length, steps_a_mm);
    if (segment.kind == SegmentKind::arc) {
      print.add(path.arc_of(segment).center);
    } else if (segment.kind == SegmentKind::dwell) {
      print.add(static_cast<std::int64_t>(path.pause_of(segment).kind));
      print.add(path.dwell_of(segment), steps_a_second);
    }
    prints.push_back(print.value());
  }
  return prints;
}

using Index = std::uint32_t;
using Pair = std::pair<Index, Index>;  // index in the old path and in the new one

/// A part of both paths.
struct MatchedPart {
  Index old_begin, old_end, now_begin, now_end;
  int level = 0;
  bool empty() const { return old_begin == old_end || now_begin == now_end; }
};

/// Longest subsequence of `pairs`, which ascend in their first parts, that also ascends in the second parts.
std::vector<Pair> longest_rise(const std::vector<Pair>& pairs) {
  std::vector<std::size_t> last;  // [n]: the pair that ends the best sequence of n + 1 pairs
  std::vector<std::size_t> before(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto place = std::ranges::lower_bound(last, pairs[i].second, {},
                                                [&](std::size_t other) { return pairs[other].second; });
    before[i] = place == last.begin() ? pairs.size() : *std::prev(place);
    if (place == last.end()) {
      last.push_back(i);
    } else {
      *place = i;
    }
  }
  std::vector<Pair> rise(last.size());
  std::size_t at = last.empty() ? pairs.size() : last.back();
  for (auto pair = rise.rbegin(); pair != rise.rend(); ++pair) {
    *pair = pairs[at];
    at = before[at];
  }
  return rise;
}

class Matcher {
 public:
  Matcher(const Toolpath& old, const Toolpath& now) : old_(fingerprints(old)), now_(fingerprints(now)) {}

  std::vector<Pair> match() {
    parts_.push_back({0, static_cast<Index>(old_.size()), 0, static_cast<Index>(now_.size())});
    while (!parts_.empty()) {
      const MatchedPart part = parts_.back();
      parts_.pop_back();
      cut(without_ends(part));
    }
    std::ranges::sort(pairs_);
    return std::move(pairs_);
  }
  Index old_size() const { return static_cast<Index>(old_.size()); }
  Index now_size() const { return static_cast<Index>(now_.size()); }

 private:
  MatchedPart without_ends(MatchedPart part) {
    while (!part.empty() && old_[part.old_begin] == now_[part.now_begin]) {
      pairs_.emplace_back(part.old_begin++, part.now_begin++);
    }
    while (!part.empty() && old_[part.old_end - 1] == now_[part.now_end - 1]) {
      pairs_.emplace_back(--part.old_end, --part.now_end);
    }
    return part;
  }

  void cut(const MatchedPart& part) {
    if (part.empty() || part.level == most_levels) {
      return;
    }
    const std::vector<Pair> anchors = longest_rise(once_in_both(part));
    if (anchors.empty()) {
      return;
    }
    MatchedPart between{part.old_begin, 0, part.now_begin, 0, part.level + 1};
    for (const Pair& anchor : anchors) {
      pairs_.push_back(anchor);
      between.old_end = anchor.first;
      between.now_end = anchor.second;
      parts_.push_back(between);
      between.old_begin = anchor.first + 1;
      between.now_begin = anchor.second + 1;
    }
    between.old_end = part.old_end;
    between.now_end = part.now_end;
    parts_.push_back(between);
  }

  std::vector<Pair> once_in_both(const MatchedPart& part) const {
    struct Found {
      Index old = 0, now = 0;
      int in_old = 0, in_now = 0;
    };
    std::unordered_map<std::uint64_t, Found> found;
    found.reserve(part.old_end - part.old_begin);
    for (Index i = part.old_begin; i < part.old_end; ++i) {
      Found& one = found[old_[i]];
      one.old = i;
      ++one.in_old;
    }
    for (Index i = part.now_begin; i < part.now_end; ++i) {
      if (const auto one = found.find(now_[i]); one != found.end()) {
        one->second.now = i;
        ++one->second.in_now;
      }
    }
    std::vector<Pair> pairs;
    for (const auto& [print, one] : found) {
      if (one.in_old == 1 && one.in_now == 1) {
        pairs.emplace_back(one.old, one.now);
      }
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  std::vector<std::uint64_t> old_;
  std::vector<std::uint64_t> now_;
  std::vector<MatchedPart> parts_;
  std::vector<Pair> pairs_;
};

}  // namespace

std::vector<MatchedStretch> match_toolpaths(const Toolpath& old, const Toolpath& now) {
  Matcher matcher(old, now);
  const std::vector<Pair> pairs = matcher.match();
  std::vector<MatchedStretch> stretches;
  Index old_at = 0;
  Index now_at = 0;
  const auto unlike = [&](Index old_end, Index now_end) {
    if (old_end > old_at || now_end > now_at) {
      stretches.push_back({old_at, old_end, now_at, now_end, false});
    }
  };
  for (const auto& [one, other] : pairs) {
    unlike(one, other);
    if (!stretches.empty() && stretches.back().same) {
      ++stretches.back().old_end;
      ++stretches.back().now_end;
    } else {
      stretches.push_back({one, one + 1, other, other + 1, true});
    }
    old_at = one + 1;
    now_at = other + 1;
  }
  unlike(matcher.old_size(), matcher.now_size());
  return stretches;
}

}  // namespace feedscope
