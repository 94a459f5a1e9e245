#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/analysis/agreement/path_matcher.h"

namespace feedscope {

/// Where on a programmed path the samples of a trace can be, by their recorded program lines.
class LineGuide {
 public:
  /// `lines`: one per sample, 0 if unknown; `time`: of the samples [s]. Both outlive this.
  LineGuide(const ProgrammedCourse& course, const std::vector<std::uint32_t>& lines,
            const std::vector<double>& time);

  /// Whether most of the lines move or dwell in the program. Otherwise they belong to another program or are
  /// block numbers, and give no information.
  bool usable() const { return usable_; }
  /// Programmed path length, from and to [mm].
  struct Range {
    double from = 0;
    double to = std::numeric_limits<double>::infinity();
  };
  /// Range of sample `i`, provided it is not before `s` [mm]: the next stretch of the lines recorded within
  /// 0.1 s of it, since controls record lines and positions of different instants. Lines without motion allow
  /// the whole path.
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

/// Information about a record before it is matched.
struct MatchHints {
  const LineGuide* guide = nullptr;
  /// The record may begin anywhere: it starts where it first reaches the path, even if it passes the start
  /// later.
  bool anywhere = false;
};

/// As match_record() without hints. With a guide, each sample is searched within its range and four
/// tolerances, so that of several passes over the same path exactly those in the trace are found.
MatchedRecord match_record(const ProgrammedCourse& course, const MotionRecord& record,
                           const MatchOptions& options, const MatchHints& hints, std::size_t from = 0,
                           Progress* progress = nullptr);

}  // namespace feedscope
