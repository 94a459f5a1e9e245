#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/compare.h"
#include "core/analysis/fastest_runs.h"

namespace feedscope {

/// Differences of the cycle time below this share are none.
inline constexpr double worthwhile_share = 0.01;

/// The run to take of several.
struct Recommendation {
  enum class Reason : std::uint8_t {
    only,           ///< no other one can be taken
    no_difference,  ///< all take the same time: the one with the smallest contour error
    fastest,
    smallest_error,  ///< of those that take no longer than the fastest
  };

  std::size_t run = 0;      ///< its place
  std::size_t against = 0;  ///< place of the slowest one that could be taken
  Reason reason = Reason::only;
  double gain = 0;           ///< cycle time of that one less its own [s]
  double gain_share = 0;     ///< of the cycle time of that one
  double contour_error = 0;  ///< of its cuts [mm]
};

/// The one with the smallest contour error among those that take at most worthwhile_share longer than the
/// fastest, of those whose contour error is at most `within` [mm]; of equal errors the faster one. None where
/// no run keeps the bound. As in fastest_runs() never one of which more lines are refused than of another.
std::optional<Recommendation> recommend(std::span<const RunTime> runs, std::optional<double> within);

/// The contour error by which runs are chosen: that of their cuts, with drives of what the axes do [mm].
double deciding_error(const Summary& summary);

/// Which of compared runs can be chosen from: all of one model; of several, between which nobody chooses,
/// those with the model of their machine.
std::vector<bool> can_be_chosen(std::span<const ComparedRun> runs);
/// The same of compared runs; none also where none can_be_chosen().
std::optional<Recommendation> recommend(std::span<const ComparedRun> runs, std::optional<double> within);

/// "only", "no-difference", "fastest", "smallest-error-within-1-percent".
std::string to_string(Recommendation::Reason reason);

}  // namespace feedscope
