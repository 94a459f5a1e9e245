#pragma once

#include <string>
#include <vector>

#include "app/run_options.h"

namespace feedscope {

/// `text` as one word of a shell line.
std::string in_quotes(const std::string& text);
/// Adds " OPTION VALUE" for each value, quoted for a shell.
void add_asked(std::string& text, const char* option, const std::vector<std::string>& values);
/// The program and how it is read, as it was given, quoted for a shell.
std::string program_text(const ProgramOptions& options);
/// What RunOptions add to that, each with a space in front: " --machine ID --set KEY=VALUE"; "" for none.
std::string run_text(const RunOptions& options);

}  // namespace feedscope
