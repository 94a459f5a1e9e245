#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/explanation/remedies.h"
#include "core/analysis/time_use/time_use.h"

namespace feedscope {

/// A change for the whole program that was simulated.
struct TriedChange {
  Remedy remedy;
  double cycle_time = 0;                        ///< with it [s]
  std::optional<double> max_contour_error;      ///< with it, as in Summary [mm]; of the best alone
  std::optional<double> cutting_contour_error;  ///< the same
  std::string failure;                          ///< why it could not be simulated, else ""
};

/// What was tried on a run, and what helps most.
struct ChangeTrials {
  static constexpr std::size_t most = 3;
  /// A change that gains less of the cycle time does not help.
  static constexpr double worth_it = 0.002;

  std::vector<TriedChange> tried;  ///< that which gains most first, those without result last
  std::vector<std::size_t> best;   ///< places in `tried`: at most `most`, each of another kind
  /// The best that change this machine and the program, all at the same time; none where these are not at
  /// least two.
  std::optional<TriedChange> together;
};

/// Decimals that a gain or a loss is shown with, as many as its size is worth: three below a second, one
/// below 1000 s, else none.
int decimals_of_gain(double seconds);

/// What changes of one kind change by other means: "tolerance", "velocity", "acceleration", "jerk", "feed",
/// "machine", else the key of the first setting.
std::string kind_of(const Remedy& remedy);

/// What is worth trying on a whole run: remedies() of the causes that lose most, the feed, and the shipped
/// machines that run the same programs, of which an axis limit is larger and whose own control refuses no
/// line that is run, with the same model.
std::vector<Remedy> changes_worth_trying(const Run& run, const TimeUse& use);

/// Simulates the changes, as many at a time as there are processors, and finds the contour error of the best
/// of them, whose motions it keeps until then. `tell` hears of each as it is done, with its place in
/// `changes`, from several threads. Throws Cancelled.
ChangeTrials try_changes(const Run& run, const std::vector<Remedy>& changes, Progress* progress = nullptr,
                         const std::function<void(std::size_t, const TriedChange&)>& tell = {});

}  // namespace feedscope
