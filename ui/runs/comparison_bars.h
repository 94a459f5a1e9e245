#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/study/compare.h"

namespace feedscope::ui {

/// A part of a bar: the time of one cause.
struct BarPart {
  std::optional<Cause> cause;  ///< none: several with little time, together
  double time = 0;             ///< [s]
};

/// One run as a bar, and the figures next to it.
struct ComparisonBar {
  std::string model;                          ///< id
  std::optional<ToleranceInForce> tolerance;  ///< if the model follows one
  double cycle_time = 0;                      ///< [s]
  double against_cam = 1;                     ///< cycle time over programmed time
  double contour_error = 0;                   ///< deciding_error() [mm]
  bool refused = false;                       ///< ComparedRun::refused
  bool out_of_reach = false;                  ///< ComparedRun::out_of_reach
  std::size_t lines_not_run = 0;              ///< refused by the control
  std::vector<BarPart> parts;  ///< in the order of all_causes(), the rest last; they add up to cycle_time
};

/// Neighbouring runs on one machine.
struct MachineBars {
  std::string machine;         ///< name
  double programmed_time = 0;  ///< promised by `cam` [s]
  std::vector<ComparisonBar> bars;
};

/// A comparison as stacked bars: contents, without layout.
struct ComparisonBars {
  std::vector<MachineBars> machines;  ///< in the order of the runs
  std::vector<CauseKind> kinds;       ///< distinguished kinds, in the order of their parts
  bool rest = false;                  ///< whether any bar has a part without cause that can be seen
  bool lines_refused = false;         ///< whether a control refuses lines of any run
  bool actual = false;                ///< whether contour errors are those of the drives
  double longest = 0;                 ///< longest time that the bars show [s]

  std::size_t count() const;
};

/// Largest number of kinds of causes in a legend, without the rest.
inline constexpr std::size_t max_cause_kinds = 11;

/// Kinds of causes with less than 1 % of every run, and those beyond max_cause_kinds, become one part;
/// a single such kind keeps its name if there is room and it can be seen.
ComparisonBars comparison_bars(std::span<const ComparedRun> runs);

}  // namespace feedscope::ui
