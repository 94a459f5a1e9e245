#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/explanation/remedies.h"
#include "core/analysis/time/time_use.h"

namespace feedscope {

/// A simulated change for the whole program.
struct TriedChange {
  Remedy remedy;
  double cycle_time = 0;                        ///< with the change [s]
  std::optional<double> max_contour_error;      ///< with the change, as in Summary [mm]; only for the best
  std::optional<double> cutting_contour_error;  ///< likewise
  std::string failure;                          ///< reason why it could not be simulated, else ""
};

/// Changes tried on a run, and the most effective ones.
struct ChangeTrials {
  static constexpr std::size_t most = 3;
  /// Smallest gain that counts, as a share of the cycle time.
  static constexpr double worth_it = 0.002;

  std::vector<TriedChange> tried;  ///< largest gain first, those without result last
  std::vector<std::size_t> best;   ///< indices into `tried`: at most `most`, each of another kind
  /// All of the best changes to this machine and the program together; none if fewer than two.
  std::optional<TriedChange> together;
};

/// Decimals for a gain or a loss, according to its size: three below a second, one below 1000 s, else none.
int decimals_of_gain(double seconds);

/// Kind of a change: "tolerance", "velocity", "acceleration", "jerk", "feed", "machine", else the key of the
/// first setting. Changes of one kind change the same in other ways.
std::string kind_of(const Remedy& remedy);

/// Changes worth trying on a whole run: remedies() of the causes that lose most, the feed, and shipped
/// machines with the same model that run the same programs, have a larger axis limit and whose own control
/// refuses no line of the run.
std::vector<Remedy> changes_worth_trying(const Run& run, const TimeUse& use);

/// Simulates the changes, one per processor at a time, and finds the contour error of the best ones, whose
/// motions it keeps until then. Calls `tell` for each as it is finished, with its index in `changes`, from
/// several threads. Throws Cancelled.
ChangeTrials try_changes(const Run& run, const std::vector<Remedy>& changes, Progress* progress = nullptr,
                         const std::function<void(std::size_t, const TriedChange&)>& tell = {});

}  // namespace feedscope
