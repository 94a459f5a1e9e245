#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

enum class Severity : std::uint8_t { info, warning, error };

/// "info", "warning", "error".
std::string_view to_string(Severity severity);

/// What is wrong, or worth knowing, at one place of a program. Reading goes on after it.
struct Diagnostic {
  Severity severity = Severity::error;
  std::uint32_t line = 0;    ///< 1-based; 0: the file as a whole
  std::uint32_t column = 0;  ///< 1-based byte column; 0: the line as a whole
  std::string code;          ///< stable short name, "arc-radius"
  std::string message;       ///< thing and value
  std::string hint;          ///< what to do; may be empty
  std::string file = {};     ///< of a subprogram in a file of its own; empty: the program itself
};

bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// One line as a compiler prints it, `file` being the program's: "part.nc:3:7: error: message [code]",
/// followed by " (hint)" if any.
std::string format(const Diagnostic& diagnostic, std::string_view file);

}  // namespace feedscope
