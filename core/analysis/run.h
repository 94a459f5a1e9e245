#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/chord_error.h"
#include "core/analysis/run_sources.h"
#include "core/analysis/summary.h"
#include "core/analysis/unreachable_feed.h"
#include "core/models/control_model.h"

namespace feedscope {

/// A program read once; every run on it shares it.
struct LoadedProgram {
  std::shared_ptr<const Program> program;  ///< its motions have become the toolpath
  std::shared_ptr<const Toolpath> toolpath;
  /// Those of the feed motions, each once, in the order of their first use.
  std::vector<PathControl> feed_controls;
  std::optional<ChordError> chord_error;  ///< of its short lines, if it has enough
  std::optional<LargestFeed> largest_feed;
  double read_time = 0;  ///< wall clock, text to toolpath [s]
  /// Of a run: lines that its control refuses, as notes; they are not part of its toolpath.
  std::vector<Diagnostic> lines_not_run;
  bool refused = false;  ///< cut off at a limit, and ReadOptions do not ask to simulate it
};

/// What a program runs on: a machine, one control model and the model's settings.
struct Setup {
  Machine machine;
  const ControlModel* model = nullptr;  ///< one of all_models()
  Settings settings;                    ///< as complete_settings, then what was asked for
  LoadSetup load = {};                  ///< how the tools are engaged; empty: no cutting load is computed
  bool operator==(const Setup&) const = default;
};

/// How people ask for a setup: on the command line, in a session.
struct SetupRequest {
  std::string machine;              ///< id or file; "" for default_machine_of(dialect)
  std::string model;                ///< id; "" for the machine's own
  std::optional<double> tolerance;  ///< contour tolerance [mm] instead of the program's and the machine's
  std::vector<std::string> assignments = {};  ///< KEY=VALUE, applied last and in order
  Dialect dialect = Dialect::iso;             ///< of the program
};

/// For programs of no particular control; default_machine_of() knows those of the others.
inline constexpr const char* default_machine = "spinner-mvc850";

/// One program on one machine with one model: everything that is shown or written of it.
/// Cheap to copy; runs of the same program share program and toolpath.
struct Run {
  LoadedProgram input;  ///< its toolpath as the control reads it and on_machine() makes it
  Setup setup;
  std::shared_ptr<const Trajectory> trajectory;
  RunSources sources;
  Summary summary;
  double simulate_time = 0;  ///< wall clock, summary included [s]
};

/// What a machine file may hold, for read_machine(): settings of all models, and as "model" which there are.
std::vector<SettingSpec> machine_file_settings();
/// The machine files of data_folder().
MachineLibrary shipped_machines();

/// Reads a text into program and toolpath. A wrong line is a diagnostic of the program.
/// Throws Cancelled when stopped.
LoadedProgram load_program(std::shared_ptr<const SourceText> source, Progress* progress = nullptr,
                           const ReadOptions& options = {});
/// Reads a file, or standard input for "-". Throws InputError as SourceText::from_file does.
LoadedProgram load_program(const std::filesystem::path& file, Progress* progress = nullptr,
                           const ReadOptions& options = {});

/// `options` with the work offsets of a machine for those that they do not give, and its rotary axes.
ReadOptions reading_on(ReadOptions options, const Machine& machine);

/// Throws InputError naming the value, its bounds and the nearest valid name: unknown machine, model or
/// setting, value out of bounds. A tolerance has no effect on a model that does not read
/// it.
Setup make_setup(const SetupRequest& request);

/// Sets the contour tolerance [mm] in place of the program's own; a model that reads none stays as it is.
/// Throws InputError if it is out of bounds.
void set_tolerance(Setup& setup, double tolerance);

/// The contour tolerance [mm] that is set, of a setup whose model reads one; where the program has its own
/// another one holds: tolerance_in_force().
std::optional<double> contour_tolerance(const Setup& setup);
/// Feed override [%] that changes the feeds of the program; none where they run as programmed.
std::optional<double> feed_override(const Setup& setup);

/// Simulates and summarises. Throws what ControlModel::simulate throws, and InputError for a program that is
/// refused or does not have what Setup::load speaks of.
Run simulate_run(const LoadedProgram& input, Setup setup, Progress* progress = nullptr);

}  // namespace feedscope
