#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/run_options.h"

namespace feedscope {

/// What a command reads: an NC program, or that of a session with the session's runs.
struct AskedProgram {
  std::string file;  ///< the program's; "-" for standard input
  std::shared_ptr<const SourceText> source;
  ReadOptions reading;
  std::vector<Setup> setups;  ///< of the session; empty for a program
  std::size_t current = 0;    ///< the one of them that the session shows

  bool is_session() const { return !setups.empty(); }
  /// As it is read.
  Dialect dialect() const { return reading.dialect.value_or(recognise(*source)); }
};

/// By the end of its name.
inline bool names_session(std::string_view file) {
  return file.ends_with(".feedscope");
}

/// Opens `options.file`; `more`: the options of the command that a session has of its own, besides those that
/// say how a program is read. Says on standard error what of a session is not known, and whether its program
/// has changed since. Throws InputError naming what is wrong: unreadable file, unusable session, missing
/// program, an option that does not go with a session.
AskedProgram asked_program(const ProgramOptions& options, std::vector<GivenOption> more = {});

/// Adds --run: which run of a session a command with one run is about.
void add_run_number_option(CLI::App& command, std::optional<std::size_t>& number);
/// What the options ask for, or of a session the run `number`, from 1, else its current one, which is told on
/// standard error where there are several. Throws InputError as make_setup, and for a number without session
/// or run.
Setup asked_setup(const RunOptions& options, std::optional<std::size_t> number, const AskedProgram& asked);

}  // namespace feedscope
