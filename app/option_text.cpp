#include "app/option_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace feedscope {

void add_asked(std::string& text, const char* option, const std::vector<std::string>& values) {
  for (const std::string& value : values) {
    text += fmt::format(" {} {}", option, in_quotes(value));
  }
}

std::string in_quotes(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_./=,+:@%").find(c) != std::string_view::npos;
  });
  if (plain) {
    return text;
  }
  std::string word = "'";
  for (const char c : text) {
    word += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return word + "'";
}

std::string program_text(const ProgramOptions& options) {
  std::string text = in_quotes(options.file);
  if (!options.dialect.empty()) {
    text += " --dialect " + options.dialect;
  }
  if (!options.unit.empty()) {
    text += " --unit " + options.unit;
  }
  if (options.skip_deleted) {
    text += " --skip-deleted";
  }
  const ProgramOptions usual;
  if (options.repeat_limit != usual.repeat_limit) {
    text += fmt::format(" --repeat-limit {}", options.repeat_limit);
  }
  if (options.call_depth != usual.call_depth) {
    text += fmt::format(" --call-depth {}", options.call_depth);
  }
  add_asked(text, "--tool", options.radii);
  if (!options.tool_table.empty()) {
    text += " --tools " + in_quotes(options.tool_table);
  }
  if (options.table_unit != usual.table_unit) {
    text += " --tools-unit " + options.table_unit;
  }
  add_asked(text, "--offset", options.offsets);
  if (options.wear_only) {
    text += " --wear-only";
  }
  if (options.simulate_cut_off) {
    text += " --simulate-cut-off";
  }
  return text;
}

std::string run_text(const RunOptions& options) {
  std::string text;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) {
      add_asked(text, option, {value});
    }
  };
  add("--machine", options.machine);
  add("--model", options.model);
  add("--tolerance", options.tolerance);
  add_asked(text, "--set", options.set);
  return text;
}

}  // namespace feedscope
