#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/analysis/agreement/path_matcher.h"

namespace feedscope {

/// Where on a programmed path the samples of a trace can be, by the program lines that it holds.
class LineGuide {
 public:
  /// `lines`: one a sample, 0 where there is none; `time`: of the samples [s]. Both outlive this.
  LineGuide(const ProgrammedCourse& course, const std::vector<std::uint32_t>& lines,
            const std::vector<double>& time);

  /// Whether most of the lines move or dwell in the program; if not they are of another program, or block
  /// numbers, and say nothing.
  bool usable() const { return usable_; }
  /// Programmed path length, from and to [mm].
  struct Range {
    double from = 0;
    double to = std::numeric_limits<double>::infinity();
  };
  /// Of sample `i`, if it is not before `s` [mm]: the first stretch there of the lines within 0.1 s before
  /// and behind it, since controls give lines and places of different instants. Lines that move nothing allow
  /// all.
  Range range(std::size_t i, double s) const;

 private:
  struct Stretch {
    std::uint32_t line = 0;
    double from = 0;  ///< [mm]
    double to = 0;
  };
  const Stretch* first_of(std::uint32_t line, double s) const;

  const std::vector<std::uint32_t>& lines_;
  const std::vector<double>& time_;
  std::vector<Stretch> stretches_;  ///< by line, then by place
  bool usable_ = false;
};

/// What is known of a record before it is matched.
struct MatchHints {
  const LineGuide* guide = nullptr;
  /// It begins where it first comes onto the path, wherever that is, even if it comes to the start later.
  bool anywhere = false;
};

/// As match_record() without hints; by a guide each sample within what that says of it, and four tolerances:
/// so that of several passes over the same path each is found that the trace holds, and it alone.
MatchedRecord match_record(const ProgrammedCourse& course, const MotionRecord& record,
                           const MatchOptions& options, const MatchHints& hints, std::size_t from = 0,
                           Progress* progress = nullptr);

}  // namespace feedscope
