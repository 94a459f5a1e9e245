#pragma once

#include <QString>
#include <cstdint>
#include <memory>

#include "core/program/program.h"
#include "ui/program_text/line_cells.h"
#include "ui/shared/text_place.h"

namespace feedscope::ui {

/// Queries on a program's text, for its view. Reads the program's text without a copy; the cost of each query
/// depends on its lines only.
class ProgramText {
 public:
  ProgramText() = default;
  explicit ProgramText(std::shared_ptr<const Program> program) : program_(std::move(program)) {}

  const Program* program() const { return program_.get(); }
  std::uint32_t line_count() const { return program_ == nullptr ? 0 : program_->source->line_count(); }
  std::string_view line(std::uint32_t number) const;
  QString line_text(std::uint32_t number) const { return decoded(line(number)); }
  LineCells cells(std::uint32_t number) const { return {line(number), encoding()}; }
  /// Bytes of the longest line; looks at all lines.
  std::size_t longest_line() const;

  /// The nearest existing place.
  TextPlace clamped(TextPlace place) const;
  TextPlace end() const;
  TextPlace before(TextPlace place) const;  ///< one character back, across line ends too
  TextPlace after(TextPlace place) const;
  TextPlace word_before(TextPlace place) const;  ///< start of the previous word
  TextPlace word_after(TextPlace place) const;
  /// The word, number or sign at a place.
  TextRange word_at(TextPlace place) const;
  /// The text of a range, lines separated by LF.
  QString text(TextRange range) const;

 private:
  Encoding encoding() const { return program_ == nullptr ? Encoding::utf8 : program_->source->encoding(); }
  QString decoded(std::string_view part) const;

  std::shared_ptr<const Program> program_;
};

}  // namespace feedscope::ui
