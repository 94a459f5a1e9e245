#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// The program and how it is read: FILE --dialect --unit --skip-deleted --repeat-limit --call-depth --tool
/// --tools --tools-unit --offset --wear-only --simulate-cut-off.
struct ProgramOptions {
  std::string file;
  std::string dialect;  ///< id; "" to recognise it
  std::string unit;     ///< "inch", "mm"; "" where the program says it, or mm
  bool skip_deleted = false;
  std::uint64_t repeat_limit = ReadOptions().repeat_limit;
  std::size_t call_depth = ReadOptions().call_depth;
  std::vector<std::string> radii;  ///< TOOL=RADIUS, as typed [mm]
  std::string tool_table;
  std::string table_unit = "mm";
  bool wear_only = false;
  bool simulate_cut_off = false;
  std::vector<std::string> offsets;  ///< OFFSET=X,Y,Z, as typed [mm]

  /// Throws InputError for a dialect that is not known, a radius or an offset that is none.
  ReadOptions reading() const;
  /// The options whose reading() is `reading`.
  static ProgramOptions of(const std::string& file, const ReadOptions& reading);
};

/// The options that every command with a simulation has: --machine --model --tolerance --set.
struct RunOptions : ProgramOptions {
  std::string machine;
  std::string model;
  std::string tolerance;  ///< as typed, [mm]
  std::vector<std::string> set;

  /// For a program in `dialect`. Throws InputError if the tolerance is no number.
  SetupRequest request(Dialect program_dialect) const;
};

/// An option and whether it was given.
using GivenOption = std::pair<const char*, bool>;

/// The options of ProgramOptions beside FILE.
std::vector<GivenOption> given_of(const ProgramOptions& options);
/// Those that RunOptions add.
std::vector<GivenOption> given_of_run(const RunOptions& options);

/// The dialect that is asked for, or else recognised.
Dialect dialect_of(const ProgramOptions& options, const SourceText& source);

/// Reads a length [mm] of `option`. Throws InputError if it is no number or below 0.
double parse_length(const std::string& text, const std::string& option);
/// Reads a --tolerance [mm]. Throws InputError if it is no number or below 0.
double parse_tolerance(const std::string& text);

/// Takes `tolerance=MM` out of what --set was given and adds it to `tolerances`: the same as --tolerance.
/// Throws InputError if the tolerance is given twice: --tolerance beside --set tolerance or
/// --set contour_tolerance_mm.
void move_tolerance(std::vector<std::string>& set, std::vector<std::string>& tolerances);
/// The same for a command with one run.
void move_tolerance(RunOptions& options);

/// What --machine says of itself.
std::string machine_help();
/// Adds them to a command, and returns FILE, which is required; `values` must live as long as the command.
/// `name`: of FILE, where another one is meant.
CLI::Option* add_run_options(CLI::App& command, RunOptions& values, const std::string& name = "FILE");
/// Adds those of the program alone.
CLI::Option* add_program_options(CLI::App& command, ProgramOptions& values, const std::string& name = "FILE");
/// Adds --load: how the tools are engaged.
void add_load_option(CLI::App& command, std::string& file);
/// What `load` says, `otherwise` where it is empty. Throws InputError as read_load_file().
LoadSetup asked_load(const std::string& file, LoadSetup otherwise = {});
/// Adds --set alone.
void add_set_option(CLI::App& command, std::vector<std::string>& assignments);

/// Tells on standard error which work offsets and cutter radii that were asked for the program does not use.
void note_unused_reading(const Program& program, const ReadOptions& asked);
/// Tells on standard error when a tolerance was asked for that replaces the program's own in a run of
/// `setups`.
void note_replaced_tolerance(const Toolpath& toolpath, const std::vector<Setup>& setups);
/// Tells on standard error, each once, what follows from the setups alone: a control that does not read the
/// dialect, other work offsets, drives, lines that are refused and path control that is not followed.
void note_runs(const LoadedProgram& program, const std::vector<Setup>& setups);
/// Tells on standard error of each model that does not read the tolerances that were asked for.
void note_unused_tolerances(const std::vector<std::string>& tolerances, const std::vector<Setup>& setups);

}  // namespace feedscope
