#include "core/analysis/difference/program_difference.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/difference/course_walk.h"
#include "core/analysis/difference/toolpath_match.h"
#include "core/base/exact_sum.h"
#include "core/base/translatable.h"

namespace feedscope {
namespace {

struct ChangeTexts {
  std::string_view key;
  std::string_view title;
};
/// In the order of ProgramChange.
constexpr std::array<ChangeTexts, program_change_count> texts{{
    {"none", QT_TRANSLATE_NOOP("core", "same motions, same feed")},
    {"feed", QT_TRANSLATE_NOOP("core", "same motions, other feed")},
    {"path", QT_TRANSLATE_NOOP("core", "other motions")},
    {"removed", QT_TRANSLATE_NOOP("core", "removed")},
    {"added", QT_TRANSLATE_NOOP("core", "added")},
}};

/// A run, by the segments of its program.
class Side {
 public:
  explicit Side(const Trajectory& trajectory)
      : path_(*trajectory.path().programmed()), times_(path_.segments.size()) {
    if (trajectory.pieces().empty()) {
      return;
    }
    const std::vector<double> lengths = lengths_before(path_);
    CourseWalk walk(trajectory, lengths);
    do {
      times_[walk.span().segment] += walk.span().duration;
    } while (walk.next());
  }

  const Toolpath& path() const { return path_; }
  double feed(std::uint32_t segment) const { return path_.segments[segment].feed; }

  StretchSide of(std::uint32_t begin, std::uint32_t end) const {
    StretchSide side;
    ExactSum time;
    ExactSum length;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t line = path_.segments[i].line;
      side.first_line = i == begin ? line : std::min(side.first_line, line);
      side.last_line = std::max(side.last_line, line);
      time.add(times_[i]);
      length.add(path_.segments[i].length);
    }
    side.time = time.value();
    side.length = length.value();
    return side;
  }

 private:
  const Toolpath& path_;
  std::vector<double> times_;  // of each segment [s]
};

bool same_feed(double a, double b) {
  constexpr double rounding = 1e-9;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

void add(ProgramDifference& difference, ProgramChange change, const StretchSide& old,
         const StretchSide& now) {
  difference.stretches.push_back({change, old, now});
  ProgramDifference::Sum& sum = difference.sums[static_cast<std::size_t>(change)];
  ++sum.count;
  for (const auto& [to, from] : {std::pair(&sum.old, &old), std::pair(&sum.now, &now)}) {
    to->time += from->time;
    to->length += from->length;
  }
}

}  // namespace

std::string_view program_change_key(ProgramChange change) {
  return texts[static_cast<std::size_t>(change)].key;
}

std::string_view program_change_title(ProgramChange change) {
  return texts[static_cast<std::size_t>(change)].title;
}

double ProgramDifference::same_share() const {
  double all = 0;
  for (const Sum& sum : sums) {
    all += sum.now.length;
  }
  return all > 0 ? (of(ProgramChange::none).now.length + of(ProgramChange::feed).now.length) / all : 0;
}

std::vector<std::size_t> largest_changes(const ProgramDifference& difference, std::size_t most) {
  constexpr double nothing = 1e-6;  // [s]
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < difference.stretches.size(); ++i) {
    if (std::abs(difference.stretches[i].gained()) > nothing) {
      places.push_back(i);
    }
  }
  std::ranges::stable_sort(places, std::greater(),
                           [&](std::size_t i) { return std::abs(difference.stretches[i].gained()); });
  places.resize(std::min(places.size(), most));
  std::ranges::sort(places);
  return places;
}

ProgramDifference compare_programs(const Run& old_run, const Run& new_run) {
  const Side old(*old_run.trajectory);
  const Side now(*new_run.trajectory);
  ProgramDifference difference;
  for (const MatchedStretch& stretch : match_toolpaths(old.path(), now.path())) {
    if (!stretch.same) {
      const ProgramChange change = stretch.now_begin == stretch.now_end   ? ProgramChange::removed
                                   : stretch.old_begin == stretch.old_end ? ProgramChange::added
                                                                          : ProgramChange::path;
      add(difference, change, old.of(stretch.old_begin, stretch.old_end),
          now.of(stretch.now_begin, stretch.now_end));
      continue;
    }
    const std::uint32_t count = stretch.old_end - stretch.old_begin;
    const auto same = [&](std::uint32_t i) {
      return same_feed(old.feed(stretch.old_begin + i), now.feed(stretch.now_begin + i));
    };
    for (std::uint32_t from = 0; from < count;) {
      std::uint32_t to = from + 1;
      while (to < count && same(to) == same(from)) {
        ++to;
      }
      add(difference, same(from) ? ProgramChange::none : ProgramChange::feed,
          old.of(stretch.old_begin + from, stretch.old_begin + to),
          now.of(stretch.now_begin + from, stretch.now_begin + to));
      from = to;
    }
  }
  return difference;
}

}  // namespace feedscope
