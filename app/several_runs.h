#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/run_options.h"
#include "app/watch.h"
#include "ui/report/report_input.h"
#include "ui/workbench/run_list.h"

namespace feedscope {

/// A program and the runs of a picture or report: --machine, --model, --tolerance once or more, and --set for
/// all of them. Every machine with every model and every tolerance; without --model each machine's own.
struct SeveralRunsOptions : ProgramOptions {
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<std::string> tolerances;  ///< [mm], as typed
  std::vector<std::string> set;
  std::string load;  ///< name of a load file
};

/// One of these runs, and the options that request it alone.
struct AskedRun {
  Setup setup;
  std::string options;  ///< "--machine ID --model ID ...", quoted for a shell
};

/// Adds these options to a command; `values` must live as long as the command.
void add_several_runs_options(CLI::App& command, SeveralRunsOptions& values);
/// The runs of a program in `dialect`. Throws InputError as setups_to_compare.
std::vector<AskedRun> asked_runs(const SeveralRunsOptions& options, Dialect dialect);
/// The program, then all options as given, quoted for a shell.
std::string options_text(const SeveralRunsOptions& options);

/// Prints to standard error the notes on the runs, the failed runs, and the messages on the program and on
/// motions that machines cannot do. `tolerances`: the requested ones. Returns the exit code.
int tell_of_shown_runs(const ui::ReportInput& input, const std::vector<std::string>& tolerances);
/// Setups of the runs of `input`.
std::vector<Setup> setups_of(const ui::ReportInput& input);

/// Runs of a program in the requested order.
struct SimulatedRuns {
  std::vector<std::shared_ptr<const ui::ShownRun>> shown;  ///< null for a failed run
  std::vector<ui::UnmadeRun> unmade;
};
/// Reads the program and simulates `asked` with the engagement of `load`, as many runs at a time as there are
/// processors, each with the `parts` to be shown. Throws Cancelled, and InputError if all runs fail.
SimulatedRuns simulate_all(const ReadOptions& reading, const std::vector<ui::RunItem>& asked,
                           const LoadSetup& load, std::shared_ptr<const SourceText> source, Watch& watch,
                           const ui::ShownParts& parts = {});
/// Simulates as simulate_all(), as input of pictures and reports.
ui::ReportInput simulate_runs(const ReadOptions& reading, const std::vector<AskedRun>& runs,
                              std::shared_ptr<const SourceText> source, Watch& watch,
                              const ui::ShownParts& parts = {});

}  // namespace feedscope
