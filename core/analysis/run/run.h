#pragma once

// Room `analysis`, a folder a topic. Here `run`: a program is loaded once, read by the control, put on the
// machine, simulated and summarised. The other topics read a Run: contour error, time, rotary axes, notes,
// differences, studies, explanations, envelopes for charts, agreement with traces.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/contour/chord_error.h"
#include "core/analysis/notes/unreachable_feed.h"
#include "core/analysis/run/run_sources.h"
#include "core/analysis/run/summary.h"
#include "core/models/control_model.h"

namespace feedscope {

/// A program, read once and shared by all runs on it.
struct LoadedProgram {
  std::shared_ptr<const Program> program;
  std::shared_ptr<const Toolpath> toolpath;
  /// Path controls of the feed motions, each once, in the order of first use.
  std::vector<PathControl> feed_controls;
  std::optional<ChordError> chord_error;  ///< of its short lines, if there are enough
  std::optional<LargestFeed> largest_feed;
  double read_time = 0;  ///< wall clock, text to toolpath [s]
  bool refused = false;  ///< cut off at a limit, and ReadOptions do not request its simulation
};

/// Basis of a simulation: a machine, a control model and the model's settings.
struct Setup {
  Machine machine;
  const ControlModel* model = nullptr;  ///< one of all_models()
  Settings settings;                    ///< as complete_settings, then as requested
  LoadSetup load = {};                  ///< engagement of the tools; empty: no cutting load is computed
  bool operator==(const Setup&) const = default;
};

/// Request for a setup: on the command line, in a session.
struct SetupRequest {
  std::string machine;              ///< id or file; "" for default_machine_of(dialect)
  std::string model;                ///< id; "" for the machine's own
  std::optional<double> tolerance;  ///< contour tolerance [mm] instead of the program's and the machine's
  std::vector<std::string> assignments = {};  ///< KEY=VALUE, applied last and in order
  Dialect dialect = Dialect::iso;             ///< of the program
};

/// Machine for programs of no particular control; default_machine_of() has those for the others.
inline constexpr const char* default_machine = "spinner-mvc850";

/// One program on one machine with one model: the source of everything that is shown or written about it.
/// Cheap to copy; runs of the same program share program and toolpath.
struct Run {
  LoadedProgram input;
  Setup setup;
  MachinePath path;                       ///< of `input`, as the control reads it and the machine runs it
  std::vector<Diagnostic> lines_not_run;  ///< that the control refuses, as notes; `path` excludes them
  std::shared_ptr<const Trajectory> trajectory;
  RunSources sources;
  Summary summary;
  double simulate_time = 0;  ///< wall clock, including the summary [s]
};

/// Valid keys of a machine file, for read_machine(): settings of all models, and "model" with its choices.
std::vector<SettingSpec> machine_file_settings();
/// Machine files of data_folder().
MachineLibrary shipped_machines();

/// Reads a text into program and toolpath. A faulty line becomes a diagnostic of the program. Throws
/// Cancelled when stopped.
LoadedProgram load_program(std::shared_ptr<const SourceText> source, Progress* progress = nullptr,
                           const ReadOptions& options = {});
/// Reads a file, or standard input for "-". Throws InputError as SourceText::from_file does.
LoadedProgram load_program(const std::filesystem::path& file, Progress* progress = nullptr,
                           const ReadOptions& options = {});

/// `options` with the rotary axes of a machine, and its work offsets unless `options` gives them.
ReadOptions reading_on(ReadOptions options, const Machine& machine);

/// Makes a setup. Throws InputError with value, bounds and nearest valid name: unknown machine, model or
/// setting, value out of bounds. A tolerance has no effect on a model that does not read it.
Setup make_setup(const SetupRequest& request);

/// Sets the contour tolerance [mm], replacing the program's own; no effect on a model that reads none. Throws
/// InputError if it is out of bounds.
void set_tolerance(Setup& setup, double tolerance);

/// Contour tolerance [mm] set in a setup whose model reads one. If the program has its own, see
/// tolerance_in_force().
std::optional<double> contour_tolerance(const Setup& setup);
/// Feed override [%] that changes the feeds of the program; none if they run as programmed.
std::optional<double> feed_override(const Setup& setup);

/// Simulates and summarises. Throws as ControlModel::simulate does, and InputError for a program that is
/// refused or lacks something that Setup::load refers to.
Run simulate_run(const LoadedProgram& input, Setup setup, Progress* progress = nullptr);

}  // namespace feedscope
