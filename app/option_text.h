#pragma once

#include <string>
#include <vector>

#include "app/run_options.h"

namespace feedscope {

/// `text` as one word of a shell line.
std::string in_quotes(const std::string& text);
/// Adds " OPTION VALUE" for each value, quoted for a shell.
void add_asked(std::string& text, const char* option, const std::vector<std::string>& values);
/// The program and its reading options as given, quoted for a shell.
std::string program_text(const ProgramOptions& options);
/// The options that RunOptions add, each after a space: " --machine ID --set KEY=VALUE"; "" for none.
std::string run_text(const RunOptions& options);

}  // namespace feedscope
