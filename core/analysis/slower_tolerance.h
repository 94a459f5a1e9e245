#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/analysis/compare.h"

namespace feedscope {

/// Two runs of a comparison of which the one with the wider contour tolerance takes longer.
struct SlowerTolerance {
  std::size_t narrow = 0;   ///< index of the run
  std::size_t wide = 0;     ///< index of the slower one
  double narrow_value = 0;  ///< contour tolerance [mm]
  double wide_value = 0;
  double more = 0;        ///< by how much its cycle time is longer [s]
  Cause cause;            ///< the one whose time grows most
  double cause_more = 0;  ///< by that much [s]
};

/// What is looked at of a run.
struct ToleranceRun {
  const Setup* setup;
  const Summary* summary;
};
std::vector<ToleranceRun> tolerance_runs(std::span<const ComparedRun> runs);

/// For runs of one machine and model whose settings differ in the contour tolerance alone, the two with the
/// largest growth, if it is above one in ten thousand; groups in the order of their first runs.
std::vector<SlowerTolerance> slower_with_wider_tolerance(std::span<const ToleranceRun> runs);

/// "essid on Spinner MVC 850: a contour tolerance of 0.05 mm takes longer than 0.01 mm, 143.900 s against
/// 101.600 s. Corner blends take 30.200 s more. ..."; `runs` as of the search.
std::string to_string(const SlowerTolerance& slower, std::span<const ToleranceRun> runs);

/// Why that can be, as one sentence for people.
inline constexpr const char* why_slower_with_wider_tolerance =
    "A corner blend can take longer than a narrower one or an exact stop: it is passed at a limited speed "
    "along its whole length.";

}  // namespace feedscope
