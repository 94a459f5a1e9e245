#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/analysis/run.h"
#include "core/analysis/tolerance_in_force.h"
#include "core/analysis/undetermined_limits.h"

namespace feedscope {

/// Figures of one of several runs of a program; its trajectory is given up to save memory.
struct ComparedRun {
  Setup setup;
  Summary summary;
  double path_length = 0;    ///< executed [mm]
  std::size_t blends = 0;    ///< corners that the control rounds
  double simulate_time = 0;  ///< wall clock [s]
  std::optional<ToleranceInForce> tolerance = std::nullopt;
  /// The control refuses the program: no feed motion of it is run, and the figures mean nothing.
  bool refused = false;
  std::size_t lines_not_run = 0;  ///< that the control refuses: the figures are those of the others
  /// is_out_of_reach(): the figures are those of axes that stay, or go beyond their travel.
  bool out_of_reach = false;
  std::vector<UndeterminedLimit> undetermined = {};  ///< undetermined_limits()

  /// Control and machine run the program: its figures may be set beside those of others.
  bool is_possible() const { return !refused && !out_of_reach; }

  /// Cycle time over that of the model `cam`, which is the programmed time; 1 for an empty program.
  double against_cam() const {
    return summary.programmed_time > 0 ? summary.cycle_time / summary.programmed_time : 1;
  }
};

ComparedRun figures_of(const Run& run);

/// Every machine with every model and every tolerance [mm], in that order; none of a kind: the default
/// machine, all models, the machine's own tolerance. A model that reads no tolerance is taken once a machine.
/// An assignment (KEY=VALUE, as of make_setup) goes to every model that knows its key.
/// Throws as make_setup, and InputError with the nearest key for an assignment that no model takes.
std::vector<Setup> setups_to_compare(const std::vector<std::string>& machines,
                                     const std::vector<std::string>& models,
                                     const std::vector<double>& tolerances,
                                     const std::vector<std::string>& assignments = {});

/// Runs `program` on every setup, as many at a time as there are processors, and gives the figures in the
/// order of `setups`; the same as simulate_run one by one. `inspect` sees every run before its trajectory is
/// given up, with its place in `setups`, from several threads at a time.
/// Throws Cancelled when stopped, else what the first run that failed threw.
std::vector<ComparedRun> compare_runs(const LoadedProgram& program, const std::vector<Setup>& setups,
                                      Progress* progress = nullptr,
                                      const std::function<void(std::size_t, const Run&)>& inspect = {});

}  // namespace feedscope
