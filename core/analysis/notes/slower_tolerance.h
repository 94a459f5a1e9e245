#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/analysis/study/compare.h"

namespace feedscope {

/// Two runs of a comparison, of which the one with the wider contour tolerance takes longer.
struct SlowerTolerance {
  std::size_t narrow = 0;   ///< index of the run
  std::size_t wide = 0;     ///< index of the slower one
  double narrow_value = 0;  ///< contour tolerance [mm]
  double wide_value = 0;
  double more = 0;        ///< excess of its cycle time [s]
  Cause cause;            ///< cause whose time grows most
  double cause_more = 0;  ///< growth of that time [s]
};

/// Data of a run that the search needs.
struct ToleranceRun {
  const Setup* setup;
  const Summary* summary;
};
std::vector<ToleranceRun> tolerance_runs(std::span<const ComparedRun> runs);

/// Pairs of runs on one machine with one model whose settings differ only in the contour tolerance: per group
/// the pair with the largest growth of time, if above one in ten thousand; groups in the order of their first
/// runs.
std::vector<SlowerTolerance> slower_with_wider_tolerance(std::span<const ToleranceRun> runs);

/// Message such as "essid on Spinner MVC 850: a contour tolerance of 0.05 mm takes longer than 0.01 mm,
/// 143.900 s against 101.600 s. Corner blends take 30.200 s more. ..."; `runs`: those of the search.
std::string to_string(const SlowerTolerance& slower, std::span<const ToleranceRun> runs);

/// Explanation as one sentence for display.
inline constexpr const char* why_slower_with_wider_tolerance =
    "A corner blend can take longer than a narrower one or an exact stop: it is passed at a limited speed "
    "along its whole length.";

}  // namespace feedscope
