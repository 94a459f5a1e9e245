#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace feedscope {

enum class Severity : std::uint8_t { info, warning, error };

/// "info", "warning", "error".
std::string_view to_string(Severity severity);

/// An error or remark about one place of a program. Reading continues after it.
struct Diagnostic {
  Severity severity = Severity::error;
  std::uint32_t line = 0;    ///< 1-based; 0: the file as a whole
  std::uint32_t column = 0;  ///< 1-based byte column; 0: the line as a whole
  std::string code;          ///< stable short name, "arc-radius"
  Message message;           ///< thing and value
  Message hint;              ///< what to do; may be empty
  std::string file = {};     ///< of a subprogram in its own file; empty: the program itself
  /// Number of places: more than one in a final message that counts unlisted ones.
  std::uint64_t count = 1;
  std::uint32_t last_line = 0;  ///< line of the last of these places; 0 for a single one
  int detail = 0;               ///< distinguishes kinds with the same code; places are counted by kind
};

/// A message with all places that it applies to.
struct RepeatedDiagnostic {
  const Diagnostic* first = nullptr;
  std::vector<std::uint32_t> further_lines = {};  ///< without repeats
  std::uint64_t unlisted = 0;                     ///< number of further places
  std::uint32_t last_line = 0;                    ///< of the unlisted ones; 0 without any
};

bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// Total number of places with this severity.
std::uint64_t count_of(const std::vector<Diagnostic>& diagnostics, Severity severity);

/// Merges equal messages about several places of a file, in the order of their first places. A final message
/// that counts the rest of a kind is merged with the message of this kind if there is only one.
std::vector<RepeatedDiagnostic> without_repeats(const std::vector<Diagnostic>& diagnostics);
/// Text such as "also in lines 5, 7 and 12; 20 more up to line 90", with the first ten lines; empty for a
/// message without repeats.
Message repeats_text(const RepeatedDiagnostic& diagnostic);

/// One line in the style of a compiler; `file` is the program's: "part.nc:3:7: error: message [code]",
/// followed by " (hint)" if any.
std::string format(const Diagnostic& diagnostic, std::string_view file);

}  // namespace feedscope
