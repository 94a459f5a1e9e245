#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// The program and how it is read: FILE --dialect --unit --skip-deleted --repeat-limit --call-depth --tool
/// --tools --tools-unit --offset --wear-only --simulate-cut-off.
struct ProgramOptions {
  std::string file;
  std::string dialect;  ///< id; "" for automatic detection
  std::string unit;     ///< "inch", "mm"; "" for the program's own, or mm
  bool skip_deleted = false;
  std::uint64_t repeat_limit = ReadOptions().repeat_limit;
  std::size_t call_depth = ReadOptions().call_depth;
  std::vector<std::string> radii;  ///< TOOL=RADIUS, as typed [mm]
  std::string tool_table;
  std::string table_unit = "mm";
  bool wear_only = false;
  bool simulate_cut_off = false;
  std::vector<std::string> offsets;  ///< OFFSET=X,Y,Z, as typed [mm]

  /// Throws InputError for an unknown dialect, an invalid radius or offset.
  ReadOptions reading() const;
  /// The inverse of reading().
  static ProgramOptions of(const std::string& file, const ReadOptions& reading);
};

/// The options of all commands with a simulation: --machine --model --tolerance --set.
struct RunOptions : ProgramOptions {
  std::string machine;
  std::string model;
  std::string tolerance;  ///< [mm], as typed
  std::vector<std::string> set;

  /// For a program in `dialect`. Throws InputError if the tolerance is not a number.
  SetupRequest request(Dialect program_dialect) const;
};

/// An option and whether it was given.
using GivenOption = std::pair<const char*, bool>;

/// The options of ProgramOptions except FILE.
std::vector<GivenOption> given_of(const ProgramOptions& options);
/// The options that RunOptions add.
std::vector<GivenOption> given_of_run(const RunOptions& options);

/// The chosen dialect, or else the recognised one.
Dialect dialect_of(const ProgramOptions& options, const SourceText& source);

/// Reads a length [mm] of `option`. Throws InputError if it is not a number or below 0.
double parse_length(const std::string& text, const std::string& option);
/// Reads a --tolerance [mm]. Throws InputError if it is not a number or below 0.
double parse_tolerance(const std::string& text);

/// Moves `tolerance=MM` from the assignments of --set to `tolerances`: it equals --tolerance. Throws
/// InputError if the tolerance is given twice: --tolerance with --set tolerance or
/// --set contour_tolerance_mm.
void move_tolerance(std::vector<std::string>& set, std::vector<std::string>& tolerances);
/// As above, for a command with one run.
void move_tolerance(RunOptions& options);

/// Help text of --machine.
std::string machine_help();
/// Adds the options to a command and returns FILE, which is required; `values` must live as long as the
/// command. `name`: another name for FILE.
CLI::Option* add_run_options(CLI::App& command, RunOptions& values, const std::string& name = "FILE");
/// Adds the options of the program only.
CLI::Option* add_program_options(CLI::App& command, ProgramOptions& values, const std::string& name = "FILE");
/// Adds --load, the engagement of the tools.
void add_load_option(CLI::App& command, std::string& file);
/// Reads the load file; `otherwise` if `file` is empty. Throws InputError as read_load_file().
LoadSetup asked_load(const std::string& file, LoadSetup otherwise = {});
/// Adds --set only.
void add_set_option(CLI::App& command, std::vector<std::string>& assignments);

/// Reports on standard error the requested work offsets and cutter radii that the program does not use.
void note_unused_reading(const Program& program, const ReadOptions& asked);
/// Reports on standard error a requested tolerance that replaces the program's own in a run of `setups`.
void note_replaced_tolerance(const Toolpath& toolpath, const std::vector<Setup>& setups);
/// Prints to standard error each model that does not read the requested tolerances.
void note_unused_tolerances(const std::vector<std::string>& tolerances, const std::vector<Setup>& setups);

}  // namespace feedscope
