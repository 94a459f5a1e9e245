#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/language/line_runner.h"

namespace feedscope::heidenhain {

/// Joins lines into statements: removes comments and joins lines continued by "~". Finds the line of a
/// statement's column.
class StatementLines {
 public:
  /// `lines` outlives it.
  explicit StatementLines(const LineRunner& lines) : lines_(lines) {}

  /// Adds the current line. Returns the statement that ends with it; empty if it goes on or there is none.
  std::string_view add(std::string_view line);
  /// True while joined lines form a statement that is not complete or is running.
  bool is_joined() const { return !parts_.empty(); }
  /// The lines joined so far; empty if they are blank. Call it where no further line can follow.
  std::string_view joined();
  /// Call when the joined statement has run.
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
