#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// The labels of programs, each found by one pass over its text.
class Labels : private Part {
 public:
  /// The label that a line sets, as read() has it; empty for none and for the end of a subprogram. May throw
  /// ReadFault.
  using OfLine = std::function<std::string(std::string_view line)>;

  Labels(Context& context, OfLine of_line) : Part(context), of_line_(std::move(of_line)) {}

  /// Takes a label's number, name in quotes or text parameter, as a key. Throws ReadFault.
  std::string read(Scanner& scanner) const;
  /// In the text in force; none, and reported, if it does not exist.
  std::optional<std::uint32_t> line_of(const std::string& label, std::uint32_t column);

 private:
  using Lines = std::map<std::string, std::uint32_t, std::less<>>;
  const Lines& of_text();

  OfLine of_line_;
  std::map<const SourceText*, Lines> texts_;
};

}  // namespace feedscope::heidenhain
