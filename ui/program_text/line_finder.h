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

/// Finds a query in single lines. Several threads may use it at a time.
class LineFinder {
 public:
  LineFinder() = default;
  explicit LineFinder(const SearchQuery& query);

  /// Error in the query; empty for a valid or an empty one, which finds nothing.
  const QString& error() const { return error_; }
  bool can_find() const { return can_find_; }

  /// Hits in a line, in order; none is empty.
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
