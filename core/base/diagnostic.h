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

/// What is wrong, or worth knowing, at one place of a program. Reading goes on after it.
struct Diagnostic {
  Severity severity = Severity::error;
  std::uint32_t line = 0;    ///< 1-based; 0: the file as a whole
  std::uint32_t column = 0;  ///< 1-based byte column; 0: the line as a whole
  std::string code;          ///< stable short name, "arc-radius"
  Message message;           ///< thing and value
  Message hint;              ///< what to do; may be empty
  std::string file = {};     ///< of a subprogram in a file of its own; empty: the program itself
  /// Places that it stands for: more than one where a closing line counts what is not listed.
  std::uint64_t count = 1;
  std::uint32_t last_line = 0;  ///< of the last of these places; 0: there is one
  int detail = 0;               ///< tells kinds with one code apart; places are counted by kind
};

/// A message with every place that it applies to.
struct RepeatedDiagnostic {
  const Diagnostic* first = nullptr;
  std::vector<std::uint32_t> further_lines = {};  ///< without repeats
  std::uint64_t unlisted = 0;                     ///< places more
  std::uint32_t last_line = 0;                    ///< of those that are not listed; 0: there are none
};

bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// Places in all with this severity.
std::uint64_t count_of(const std::vector<Diagnostic>& diagnostics, Severity severity);

/// Those that say the same of several places of a file as one, in the order of their first places. A closing
/// line that counts the rest of a kind belongs to the message of this kind, if there is but one.
std::vector<RepeatedDiagnostic> without_repeats(const std::vector<Diagnostic>& diagnostics);
/// "also in lines 5, 7 and 12; 20 more up to line 90"; empty for a message that is not repeated.
Message repeats_text(const RepeatedDiagnostic& diagnostic);

/// One line as a compiler prints it, `file` being the program's: "part.nc:3:7: error: message [code]",
/// followed by " (hint)" if any.
std::string format(const Diagnostic& diagnostic, std::string_view file);

}  // namespace feedscope
