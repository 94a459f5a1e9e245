#pragma once

#include <QString>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/program/program.h"
#include "ui/program_text/syntax.h"

namespace feedscope::ui {

/// The diagnostics of a program by their lines in its own text, without those on the whole file or on
/// subprogram files.
class DiagnosticMarks {
 public:
  DiagnosticMarks() = default;
  explicit DiagnosticMarks(const Program& program);

  /// In order of line and column; owned by the program.
  const std::vector<const Diagnostic*>& all() const { return marks_; }
  /// On the lines from `first` to `last`, both included.
  std::span<const Diagnostic* const> of(std::uint32_t first, std::uint32_t last) const;
  std::span<const Diagnostic* const> of(std::uint32_t line) const { return of(line, line); }
  /// Messages and hints of a line, one below the other.
  QString tip(std::uint32_t line) const;

 private:
  std::vector<const Diagnostic*> marks_;
};

struct ByteRange {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// Bytes to mark in a line for a diagnostic at `column` (1-based byte; 0: the line without its indentation):
/// the word that begins there. Empty at the line's end for a column beyond it.
ByteRange marked_bytes(std::string_view line, std::uint32_t column, std::span<const Token> tokens);

/// The highest severity; info for none.
Severity worst_of(std::span<const Diagnostic* const> diagnostics);

}  // namespace feedscope::ui
