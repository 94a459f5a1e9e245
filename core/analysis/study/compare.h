#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run.h"
#include "core/analysis/run/tolerance_in_force.h"

namespace feedscope {

/// Figures of one of several runs of a program; its trajectory is released to save memory.
struct ComparedRun {
  Setup setup;
  Summary summary;
  double path_length = 0;    ///< executed [mm]
  std::size_t blends = 0;    ///< corners rounded by the control
  double simulate_time = 0;  ///< wall clock [s]
  std::optional<ToleranceInForce> tolerance = std::nullopt;
  /// The control refuses the program: none of its feed motions is run, and the figures have no meaning.
  bool refused = false;
  std::size_t lines_not_run = 0;  ///< refused by the control: the figures are those of the others
  /// is_out_of_reach(): the figures belong to axes that do not move, or leave their travel.
  bool out_of_reach = false;
  std::vector<Remark> remarks = {};  ///< on the run, in metric units

  /// Whether control and machine run the program, so that its figures are comparable.
  bool is_possible() const { return !refused && !out_of_reach; }

  /// Cycle time relative to that of the model `cam`, which is the programmed time; 1 for an empty program.
  double against_cam() const {
    return summary.programmed_time > 0 ? summary.cycle_time / summary.programmed_time : 1;
  }
};

ComparedRun figures_of(const Run& run);

/// Every machine with every model and every tolerance [mm], in that order. Default for an empty list: the
/// default machine, all models, the machine's own tolerance. A model that reads no tolerance is used once per
/// machine. An assignment (KEY=VALUE, as for make_setup) applies to every model that has its key. Throws as
/// make_setup does, and InputError with the nearest key for an assignment that no model takes.
std::vector<Setup> setups_to_compare(const std::vector<std::string>& machines,
                                     const std::vector<std::string>& models,
                                     const std::vector<double>& tolerances,
                                     const std::vector<std::string>& assignments = {});

/// Runs `program` on every setup, one per processor at a time, and returns the figures in the order of
/// `setups`; they equal those of simulate_run one by one. `inspect` is called for every run before its
/// trajectory is released, with its index in `setups`, from several threads. Throws Cancelled when stopped,
/// else the exception of the first failed run.
std::vector<ComparedRun> compare_runs(const LoadedProgram& program, const std::vector<Setup>& setups,
                                      Progress* progress = nullptr,
                                      const std::function<void(std::size_t, const Run&)>& inspect = {});

}  // namespace feedscope
