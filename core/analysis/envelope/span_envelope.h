#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/envelope/pyramid.h"
#include "core/analysis/time/rapid_times.h"
#include "core/base/progress.h"

namespace feedscope {

/// Level of detail for charts, of values over time that are sampled span by span: extents in every pixel
/// column.
///
/// A pyramid of extents over groups of spans, built in one pass. A group shorter than 1/8 of a column counts
/// as a whole in each column that it overlaps: a column may include that much beyond its borders, and never
/// less than its own content. Longer groups are sampled within the column.
///
/// `Walk` passes over the spans in order:
///   Walk(source, time)  begins at the first span that ends after `time` [s], else at the last one
///   done()              after the last span
///   begin(), end()      of the span [s]
///   looks()             the instants of the span to sample, as SpanLooks
///   add(band, time)     adds the values at an instant of the span; instants never decrease
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
    pyramid_ = Pyramid<Band>(std::move(groups));
  }

  /// Calls use(column, band) for each pair of neighbours in `times` [s], ascending, except for columns
  /// outside the run.
  template <typename Use>
  void columns(std::span<const double> times, Use use) const {
    if (pyramid_.empty()) {
      return;
    }
    Looker looker(source_);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      if (times[i + 1] >= 0 && times[i] <= source_.duration()) {
        use(i, column(times[i], times[i + 1], whole_group_share, looker));
      }
    }
  }
  /// As columns() for each of `stretches`, in order of time, without anything beyond their borders.
  template <typename Use>
  void exact_columns(std::span<const ColumnStretch> stretches, Use use) const {
    if (pyramid_.empty()) {
      return;
    }
    Looker looker(source_);
    for (const ColumnStretch& stretch : stretches) {
      if (stretch.to >= 0 && stretch.from <= source_.duration()) {
        use(stretch.column, column(stretch.from, stretch.to, 0, looker));
      }
    }
  }

  /// Band of the whole run.
  Band overall() const { return pyramid_.overall(); }

 private:
  static constexpr std::size_t spans_a_group = 8;
  static constexpr std::size_t groups_a_report = 512;
  static constexpr double whole_group_share = 1.0 / 8;
  static constexpr double far = 64;  ///< spans; to skip more, a new walk is cheaper than continuing

  /// Samples stretches in order, each of which begins within the sampled time or after it.
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

  /// Adds the part of the current span between both times [s].
  static void add_span(Walk& walk, Band& band, double from, double to) {
    walk.add(band, from);
    const auto looks = walk.looks();
    for (int i = looks.first_after(from); i < looks.count() && looks.at(i) < to; ++i) {
      walk.add(band, looks.at(i));
    }
    walk.add(band, std::max(from, to));
  }

  std::size_t group_at(double time) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end() - 1, time);
    return after == starts_.begin() ? 0 : static_cast<std::size_t>(after - starts_.begin()) - 1;
  }
  double duration_of(std::size_t group) const { return starts_[group + 1] - starts_[group]; }

  Band column(double from, double to, double whole_share, Looker& looker) const {
    Band band;
    const std::size_t first = group_at(from);
    const std::size_t last = group_at(to);
    std::size_t first_whole = first;
    std::size_t end_whole = last + 1;
    const double short_enough = (to - from) * whole_share;
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
      pyramid_.add(band, first_whole, end_whole);
    }
    if (cut_at_end) {
      look(last);
    }
    return band;
  }

  Source source_;
  std::vector<double> starts_;  ///< of each group, and the end [s]
  Pyramid<Band> pyramid_;       ///< by group
};

}  // namespace feedscope
