#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// The options that every command with a simulation has: FILE --machine --model --tolerance --set.
struct RunOptions {
  std::string file;
  std::string machine;
  std::string model;
  std::string tolerance;  ///< as typed, [mm]
  std::vector<std::string> set;

  /// Throws InputError if the tolerance is no number.
  SetupRequest request() const;
};

/// Reads a --tolerance [mm]. Throws InputError if it is no number or below 0.
double parse_tolerance(const std::string& text);

/// Adds them to a command; `values` must live as long as the command.
void add_run_options(CLI::App& command, RunOptions& values);
/// Adds FILE alone.
void add_program_option(CLI::App& command, std::string& file);
/// Adds --set alone.
void add_set_option(CLI::App& command, std::vector<std::string>& assignments);

/// Tells on standard error when a tolerance was asked for that the model does not read.
void note_unused_tolerance(const RunOptions& options, const Setup& setup);

}  // namespace feedscope
