#pragma once

#include <QRegularExpression>
#include <QString>
#include <optional>
#include <vector>

#include "ui/program_text/program_text.h"

namespace feedscope::ui {

struct SearchQuery {
  QString text;
  bool match_case = false;
  bool whole_word = false;
  bool regular_expression = false;

  bool operator==(const SearchQuery&) const = default;
};

/// Finds a query in single lines. May be used by several threads at a time.
class LineFinder {
 public:
  LineFinder() = default;
  explicit LineFinder(const SearchQuery& query);

  /// Why nothing can be looked for; empty if all is well, and for an empty query, which finds nothing.
  const QString& error() const { return error_; }
  bool can_find() const { return can_find_; }

  /// What is found in a line, one behind the other; nothing empty.
  std::vector<TextRange> matches_in(const ProgramText& text, std::uint32_t line) const;
  std::size_t count_in(const ProgramText& text, std::uint32_t line) const;

 private:
  template <typename Visit>
  void each_match(const QString& line, Visit visit) const;

  QRegularExpression expression_;
  QString error_;
  bool can_find_ = false;
};

}  // namespace feedscope::ui
