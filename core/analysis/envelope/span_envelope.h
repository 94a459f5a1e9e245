#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace feedscope {

/// Level of detail of values over time that are looked at span by span, for charts: the extents in every
/// pixel column.
///
/// A pyramid of extents over groups of spans, built in one pass. A group that lasts less than 1/8 of a column
/// counts as a whole in each column that it reaches into, so a column may show what happens that much beyond
/// its borders, never less than what it holds; of longer groups the part within the column is looked at.
///
/// `Walk` goes through the spans in order:
///   Walk(source, time)  begins at the first span that ends after `time` [s], at the last if none does
///   done()              behind the last span
///   begin(), end()      of the span [s]
///   looks()             into how many equal parts the span is cut by the instants that are looked at, > 0
///   add(band, time)     adds the values at an instant of the span; instants never fall
///   next()
/// and names `Source`, which is cheap to copy and has duration() [s], and `Band`, a kind of Extents.
template <typename Walk>
class SpanEnvelope {
 public:
  using Source = typename Walk::Source;
  using Band = typename Walk::Band;

  /// Throws Cancelled if `progress` is cancelled.
  explicit SpanEnvelope(Source source, Progress* progress = nullptr) : source_(std::move(source)) {
    std::vector<Band> groups;
    std::size_t count = 0;
    for (Walk walk(source_, 0); !walk.done(); walk.next(), ++count) {
      if (count % spans_a_group == 0) {
        starts_.push_back(walk.begin());
        groups.emplace_back();
        if (progress != nullptr && starts_.size() % groups_a_report == 0) {
          progress->report(walk.begin() / source_.duration());
        }
      }
      add_span(walk, groups.back(), walk.begin(), walk.end());
    }
    starts_.push_back(source_.duration());
    while (groups.size() > fan_out) {
      std::vector<Band> merged((groups.size() + fan_out - 1) / fan_out);
      for (std::size_t i = 0; i < groups.size(); ++i) {
        merged[i / fan_out].add(groups[i]);
      }
      levels_.push_back(std::exchange(groups, std::move(merged)));
    }
    levels_.push_back(std::move(groups));
  }

  /// Calls use(column, band) for each pair of neighbours in `times` [s], ascending; columns outside the run
  /// are omitted.
  template <typename Use>
  void columns(std::span<const double> times, Use use) const {
    if (levels_.front().empty()) {
      return;
    }
    Looker looker(source_);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      if (times[i + 1] >= 0 && times[i] <= source_.duration()) {
        use(i, column(times[i], times[i + 1], looker));
      }
    }
  }

  /// Of the whole run.
  Band overall() const {
    Band band;
    for (const Band& part : levels_.back()) {
      band.add(part);
    }
    return band;
  }

 private:
  static constexpr std::size_t spans_a_group = 8;
  static constexpr std::size_t fan_out = 4;
  static constexpr std::size_t groups_a_report = 512;
  static constexpr double whole_group_share = 1.0 / 8;
  static constexpr double far = 64;  ///< spans, of which a walk is rather begun anew

  /// Looks at stretches in order, each of which begins within what was seen or behind it.
  class Looker {
   public:
    explicit Looker(const Source& source) : source_(source) {}

    void look(Band& band, double from, double to, double group) {
      const double skipped = from - reached_;
      if (!walk_ || skipped < 0 || skipped > far / spans_a_group * group) {
        walk_.emplace(source_, from);
      }
      while (!walk_->done() && walk_->end() <= from && walk_->end() < source_.duration()) {
        walk_->next();
      }
      while (!walk_->done()) {
        add_span(*walk_, band, std::max(from, walk_->begin()), std::min(to, walk_->end()));
        if (walk_->end() >= to) {
          break;
        }
        walk_->next();
      }
      reached_ = to;
    }

   private:
    const Source& source_;
    std::optional<Walk> walk_;
    double reached_ = 0;
  };

  /// What of the span of `walk` lies between both [s].
  static void add_span(Walk& walk, Band& band, double from, double to) {
    const double begin = walk.begin();
    const double duration = walk.end() - begin;
    walk.add(band, from);
    const int looks = walk.looks();
    const auto first = duration > 0 ? static_cast<int>((from - begin) / duration * looks) + 1 : looks;
    for (int i = first; i < looks; ++i) {
      const double time = begin + duration * i / looks;
      if (time >= to) {
        break;
      }
      walk.add(band, std::max(from, time));
    }
    walk.add(band, std::max(from, to));
  }

  std::size_t group_at(double time) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end() - 1, time);
    return after == starts_.begin() ? 0 : static_cast<std::size_t>(after - starts_.begin()) - 1;
  }
  double duration_of(std::size_t group) const { return starts_[group + 1] - starts_[group]; }

  Band column(double from, double to, Looker& looker) const {
    Band band;
    const std::size_t first = group_at(from);
    const std::size_t last = group_at(to);
    std::size_t first_whole = first;
    std::size_t end_whole = last + 1;
    const double short_enough = (to - from) * whole_group_share;
    const auto look = [&](std::size_t group) {
      looker.look(band, std::max(from, starts_[group]), std::min(to, starts_[group + 1]), duration_of(group));
    };
    if (duration_of(first) > short_enough) {
      look(first);
      ++first_whole;
    }
    const bool cut_at_end = end_whole > first_whole && duration_of(last) > short_enough;
    if (cut_at_end) {
      --end_whole;
    }
    if (end_whole > first_whole) {
      add_groups(band, first_whole, end_whole);
    }
    if (cut_at_end) {
      look(last);
    }
    return band;
  }

  void add_groups(Band& band, std::size_t first, std::size_t last) const {
    for (std::size_t level = 0; first < last; ++level) {
      const std::vector<Band>& bands = levels_[level];
      const bool top = level + 1 == levels_.size();
      while (first < last && (top || first % fan_out != 0)) {
        band.add(bands[first++]);
      }
      while (first < last && last % fan_out != 0) {
        band.add(bands[--last]);
      }
      first /= fan_out;
      last /= fan_out;
    }
  }

  Source source_;
  std::vector<double> starts_;             ///< of each group, and the end [s]
  std::vector<std::vector<Band>> levels_;  ///< [0]: one band a group; each next level merges a few
};

}  // namespace feedscope
