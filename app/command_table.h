#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace feedscope {

/// An option of a command as help texts describe it.
struct OptionRow {
  std::string name;                  ///< "--machine"; "FILE" of a positional
  std::string value;                 ///< "ID|FILE"; "" for a switch
  std::string text;                  ///< one sentence, without a full stop
  std::vector<std::string> choices;  ///< all possible values, if they are words
  bool positional = false;
  bool takes_file() const;
};

struct CommandRow {
  std::string name;  ///< "" for the window, which opens without a command
  std::string text;
  std::string footer;
  std::vector<OptionRow> options;
};

/// The commands with their options as in the parser, the one without a name first. Source of the man page and
/// the completions.
std::vector<CommandRow> command_table(const CLI::App& app);

}  // namespace feedscope
