#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/study/compare.h"
#include "core/analysis/study/fastest_runs.h"

namespace feedscope {

/// Relative difference of the cycle time below which runs are equally fast.
inline constexpr double worthwhile_share = 0.01;

/// The recommended one of several runs.
struct Recommendation {
  enum class Reason : std::uint8_t {
    only,           ///< no other run is eligible
    no_difference,  ///< all take the same time: the smallest contour error decides
    fastest,
    smallest_error,  ///< among those as fast as the fastest
  };

  std::size_t run = 0;      ///< its index
  std::size_t against = 0;  ///< index of the slowest eligible run
  Reason reason = Reason::only;
  double gain = 0;           ///< cycle time of that run minus its own [s]
  double gain_share = 0;     ///< relative to the cycle time of that run
  double contour_error = 0;  ///< of its cuts [mm]
};

/// Recommends the run with the smallest contour error among those at most worthwhile_share slower than the
/// fastest, all with a contour error of at most `within` [mm]; of equal errors the faster one. None if no run
/// is within the bound. As in fastest_runs(), never a run with more refused lines than another.
std::optional<Recommendation> recommend(std::span<const RunTime> runs, std::optional<double> within);

/// Contour error that decides between runs: that of the cuts, of the actual path if there are drives [mm].
double deciding_error(const Summary& summary);

/// Which of the compared runs are eligible: all if they have one model; if they have several and none is
/// selected, those with the model of their machine.
std::vector<bool> can_be_chosen(std::span<const ComparedRun> runs);
/// Recommends one of the compared runs; also none if no run can_be_chosen().
std::optional<Recommendation> recommend(std::span<const ComparedRun> runs, std::optional<double> within);

/// Index of the run that results are about: the recommended one; if none is within the bound, the one with
/// the smallest contour error of those that could be chosen without it. None if no run can be chosen.
std::optional<std::size_t> leading_run(std::span<const ComparedRun> runs, std::optional<double> within);

/// Whether a run with another model than its machine's own would be faster than the recommended run.
bool another_model_is_faster(std::span<const ComparedRun> runs, const Recommendation& taken);

/// Why no other run can be chosen than the recommended one.
enum class OnlyChoice : std::uint8_t {
  within_bound,             ///< the others have a larger contour error
  within_bound_of_machine,  ///< so do those of the machine's own model
  of_machine,               ///< the others have other models than the machine's own
  possible,                 ///< the control or the machine cannot run the others
};
/// Of runs for which recommend() has Reason::only.
OnlyChoice why_only(std::span<const ComparedRun> runs, std::optional<double> within);

/// Keys "only", "no-difference", "fastest", "smallest-error-within-1-percent".
std::string to_string(Recommendation::Reason reason);

}  // namespace feedscope
