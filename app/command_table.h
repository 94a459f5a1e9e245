#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace feedscope {

/// An option of a command, as people are told of it.
struct OptionRow {
  std::string name;                  ///< "--machine"; "FILE" of a positional
  std::string value;                 ///< "ID|FILE"; "" for a switch
  std::string text;                  ///< one sentence, without a full stop
  std::vector<std::string> choices;  ///< all that it takes, where these are words
  bool positional = false;
  bool takes_file() const;
};

struct CommandRow {
  std::string name;  ///< "" for the window, which is what comes without a command
  std::string text;
  std::string footer;
  std::vector<OptionRow> options;
};

/// The commands with their options as the parser has them, the one without a name first: what the man page
/// and the completions are made of.
std::vector<CommandRow> command_table(const CLI::App& app);

}  // namespace feedscope
