#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/program/text/message_codes.h"

namespace feedscope {

/// Collects diagnostics so that a long program with a fault on every line stays readable and small: keeps the
/// first ten of each kind, of an info only the first, and counts the others in one closing line. A repeated
/// report of the same place, as in a loop, counts once.
class DiagnosticLog {
 public:
  static constexpr std::uint32_t kept_of_a_kind = 10;
  static constexpr std::uint32_t kept_of_an_info = 1;

  struct Place {
    std::uint32_t line = 0;      ///< 1-based; 0: the file as a whole
    std::uint32_t column = 0;    ///< 1-based byte column; 0: the line as a whole
    std::string_view file = {};  ///< of a subprogram in a file of its own; empty: the program itself
  };
  struct Text {
    Message message;
    Message hint;
  };

  /// A kind is `code` and `detail`, such as the number of a G word. `text()` returns the Text; it is called
  /// only for diagnostics that are kept.
  template <typename MakeText>
  void add(Severity severity, MessageCode code, int detail, Place place, MakeText&& text) {
    if (admit(severity, code, detail, place)) {
      Text made = text();
      diagnostics_.push_back({severity, place.line, place.column, std::string(code.text()),
                              std::move(made.message), std::move(made.hint), std::string(place.file), 1, 0,
                              detail});
    }
  }

  /// Returns all of them by place and empties the log.
  std::vector<Diagnostic> take();

 private:
  struct Kind {
    Severity severity = Severity::info;
    std::uint32_t kept = 0;
    std::array<std::pair<std::uint32_t, std::uint32_t>, kept_of_a_kind> places{};  ///< kept: line, column
    std::uint32_t left_out = 0;
    std::uint32_t first_left_out = 0;  ///< line
    std::uint32_t last_left_out = 0;   ///< line
  };

  bool admit(Severity severity, MessageCode code, int detail, Place place);

  std::vector<Diagnostic> diagnostics_;
  std::map<std::pair<std::string_view, int>, Kind> kinds_;
};

}  // namespace feedscope
