#pragma once

#include <memory>
#include <string>
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

/// Opens `options.file`; `more`: the options of the command that a session has of its own, besides those that
/// say how a program is read. Says on standard error what of a session is not known, and whether its program
/// has changed since. Throws InputError naming what is wrong: unreadable file, unusable session, missing
/// program, an option that does not go with a session.
AskedProgram asked_program(const ProgramOptions& options, std::vector<GivenOption> more = {});

}  // namespace feedscope
