#include "core/program/iso/language/subprograms.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

namespace feedscope::iso {

namespace {

/// File names for a program number in the program's folder: O0100, O100, 0100, 100, without an extension and
/// with the usual ones, the program's own first.
std::vector<std::string> file_names(std::uint32_t number, const std::string& own_ending) {
  std::vector<std::string> names;
  for (const std::string& stem : {fmt::format("O{:04}", number), fmt::format("O{}", number),
                                  fmt::format("{}", number), fmt::format("{:04}", number)}) {
    for (const std::string_view ending :
         {std::string_view(own_ending), std::string_view(), std::string_view(".nc"), std::string_view(".ngc"),
          std::string_view(".cnc"), std::string_view(".tap"), std::string_view(".txt")}) {
      names.push_back(stem + std::string(ending));
    }
  }
  return names;
}

}  // namespace

bool is_program_number(double value) {
  return value >= 0 && value <= 999999999 && value == std::floor(value);
}

Subprogram Subprograms::program(double number) {
  if (!is_program_number(number)) {
    return {};
  }
  const auto program = static_cast<std::uint32_t>(number);
  const std::string label = std::to_string(program);
  for (const std::shared_ptr<const SourceText>& candidate : {lines_.text_in_force(), lines_.main_text()}) {
    const FlowIndex& index = indexes_.of(*candidate);
    if (const std::uint32_t line = index.program(program); line > 0) {
      return {candidate, line};
    }
    if (const std::uint32_t line = index.sub(label); line > 0) {
      return {candidate, line + 1};
    }
  }
  const auto [known, is_new] = program_files_.try_emplace(program);
  if (is_new) {
    const std::string ending = std::filesystem::path(lines_.main_text()->name()).extension().string();
    known->second = files_.find(file_names(program, ending));
  }
  if (known->second == nullptr) {
    return {};
  }
  const std::uint32_t line = indexes_.of(*known->second).program(program);
  return {known->second, std::max(line, 1U)};
}

Subprogram Subprograms::sub(const std::string& label) {
  for (const std::shared_ptr<const SourceText>& candidate : {lines_.text_in_force(), lines_.main_text()}) {
    if (const std::uint32_t line = indexes_.of(*candidate).sub(label); line > 0) {
      return {candidate, line + 1};
    }
  }
  const std::string name = label.front() == '<' ? label.substr(1, label.size() - 2) : label;
  const std::shared_ptr<const SourceText> file = files_.find({name + ".ngc", name + ".nc"});
  const std::uint32_t line = file == nullptr ? 0 : indexes_.of(*file).sub(label);
  return line > 0 ? Subprogram{file, line + 1} : Subprogram{};
}

Subprogram Subprograms::file(const std::string& name) {
  const std::shared_ptr<const SourceText> found = files_.find({name, name + ".nc"});
  return found == nullptr ? Subprogram{} : Subprogram{found, 1};
}

}  // namespace feedscope::iso
