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
  /// Returns the label set by a line, in the form of read(); empty for none and for the end of a subprogram.
  /// May throw ReadFault.
  using OfLine = std::function<std::string(std::string_view line)>;

  Labels(Context& context, OfLine of_line) : Part(context), of_line_(std::move(of_line)) {}

  /// Takes a label's number, name in quotes or text parameter, as a key. Throws ReadFault.
  std::string read(Scanner& scanner) const;
  /// Line of a label in the current text; none, with a report, if it does not exist.
  std::optional<std::uint32_t> line_of(const std::string& label, std::uint32_t column);

 private:
  using Lines = std::map<std::string, std::uint32_t, std::less<>>;
  const Lines& of_text();

  OfLine of_line_;
  std::map<const SourceText*, Lines> texts_;
};

}  // namespace feedscope::heidenhain
