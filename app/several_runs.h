#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/run_options.h"
#include "app/watch.h"
#include "ui/report/report_input.h"
#include "ui/workbench/run_list.h"

namespace feedscope {

/// A program and the runs that a picture or a report shows: --machine, --model, --tolerance once or more, and
/// --set for all of them. Every machine with every model and every tolerance; without --model each machine's
/// own.
struct SeveralRunsOptions : ProgramOptions {
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<std::string> tolerances;  ///< as typed, mm
  std::vector<std::string> set;
  std::string load;  ///< a load file
};

/// One of these runs, and how people would ask for it alone.
struct AskedRun {
  Setup setup;
  std::string options;  ///< "--machine ID --model ID ...", quoted for a shell
};

/// Adds them to a command; `values` must live as long as the command.
void add_several_runs_options(CLI::App& command, SeveralRunsOptions& values);
/// Of a program in `dialect`. Throws InputError as setups_to_compare.
std::vector<AskedRun> asked_runs(const SeveralRunsOptions& options, Dialect dialect);
/// The options of all of them as they were given, quoted for a shell; the program in front.
std::string options_text(const SeveralRunsOptions& options);

/// Tells on standard error what is to be known of the runs, which of them could not be made, with the
/// tolerances that were asked for, and prints the messages on the program and on what machines cannot do.
/// Returns the exit code.
int tell_of_shown_runs(const ui::ReportInput& input, const std::vector<std::string>& tolerances);
/// Of its runs.
std::vector<Setup> setups_of(const ui::ReportInput& input);

/// Runs of a program in the order that they were asked for.
struct SimulatedRuns {
  std::vector<std::shared_ptr<const ui::ShownRun>> shown;  ///< null where it could not be made
  std::vector<ui::UnmadeRun> unmade;
};
/// Reads the program and simulates `asked` with the tools engaged as `load` says, as many at a time as there
/// are processors, with those `parts` that are to be shown. Throws Cancelled, and InputError where none of
/// them can be made.
SimulatedRuns simulate_all(const ReadOptions& reading, const std::vector<ui::RunItem>& asked,
                           const LoadSetup& load, std::shared_ptr<const SourceText> source, Watch& watch,
                           const ui::ShownParts& parts = {});
/// The same as the input of pictures and reports.
ui::ReportInput simulate_runs(const ReadOptions& reading, const std::vector<AskedRun>& runs,
                              std::shared_ptr<const SourceText> source, Watch& watch,
                              const ui::ShownParts& parts = {});

}  // namespace feedscope
