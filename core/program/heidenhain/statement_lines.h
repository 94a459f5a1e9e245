#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/language/line_runner.h"

namespace feedscope::heidenhain {

/// Makes statements of lines: comments removed, lines that "~" continues joined. Knows from which line a
/// column of the statement comes.
class StatementLines {
 public:
  /// `lines` outlives it.
  explicit StatementLines(const LineRunner& lines) : lines_(lines) {}

  /// Takes the line in force. The statement that ends with it; empty if it goes on or there is none.
  std::string_view add(std::string_view line);
  /// Lines are joined: the statement that they are is not over yet, or runs.
  bool is_joined() const { return !parts_.empty(); }
  /// The lines joined so far; empty if they are blank. To be called where no further line can follow.
  std::string_view joined();
  /// The joined statement has run.
  void clear();

  /// The place of a column of the statement; 0: the statement as a whole.
  DiagnosticLog::Place place(std::uint32_t column) const;

 private:
  struct Part {
    std::size_t start = 0;  ///< in joined_
    std::uint32_t line = 0;
  };

  const LineRunner& lines_;
  std::string joined_;
  std::vector<Part> parts_;
  bool comment_goes_on_ = false;
};

}  // namespace feedscope::heidenhain
