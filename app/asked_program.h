#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/run_options.h"

namespace feedscope {

/// Input of a command: an NC program, or a session's program with the session's runs.
struct AskedProgram {
  std::string file;  ///< of the program; "-" for standard input
  std::shared_ptr<const SourceText> source;
  ReadOptions reading;
  std::vector<Setup> setups;  ///< of the session; empty for a program
  std::size_t current = 0;    ///< index of the run that the session shows

  bool is_session() const { return !setups.empty(); }
  /// Reads `source` in the chosen dialect, or in the recognised one.
  Dialect dialect() const { return reading.dialect.value_or(recognise(*source)); }
};

/// Decides by the ending of the file name.
inline bool names_session(std::string_view file) {
  return file.ends_with(".feedscope");
}

/// Opens `options.file`. `more`: options of the command that conflict with a session, in addition to those of
/// reading. Prints on standard error the parts of a session that are unknown, and whether its program has
/// changed since. Throws InputError with the reason: unreadable file, unusable session, missing program, an
/// option that conflicts with a session.
AskedProgram asked_program(const ProgramOptions& options, std::vector<GivenOption> more = {});

/// Adds --run, the run of a session that a command with one run uses.
void add_run_number_option(CLI::App& command, std::optional<std::size_t>& number);
/// The setup that the options ask for. Of a session, the setup of run `number` (from 1), or else of its
/// current run, which is named on standard error if there are several. Throws InputError as make_setup, and
/// for a number without session or run.
Setup asked_setup(const RunOptions& options, std::optional<std::size_t> number, const AskedProgram& asked);

}  // namespace feedscope
