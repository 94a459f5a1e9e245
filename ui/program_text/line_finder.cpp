#include "ui/program_text/line_finder.h"

#include <QCoreApplication>
#include <QLocale>

namespace feedscope::ui {

namespace {

/// Bytes of the first `characters` (UTF-16 units) of a line.
std::uint32_t bytes_of(const QString& line, qsizetype characters, std::size_t line_bytes) {
  if (static_cast<std::size_t>(line.size()) == line_bytes) {  // ASCII and Latin-1: one byte each
    return static_cast<std::uint32_t>(characters);
  }
  return static_cast<std::uint32_t>(QStringView(line).left(characters).toUtf8().size());
}

}  // namespace

LineFinder::LineFinder(const SearchQuery& query) {
  if (query.text.isEmpty()) {
    return;
  }
  QString pattern = query.regular_expression ? query.text : QRegularExpression::escape(query.text);
  if (query.whole_word) {
    pattern = QStringLiteral("(?<![\\w.])(?:%1)(?![\\w.])").arg(pattern);
  }
  expression_ = QRegularExpression(pattern, query.match_case ? QRegularExpression::NoPatternOption
                                                             : QRegularExpression::CaseInsensitiveOption);
  const QRegularExpression alone(query.text);
  if (query.regular_expression && !alone.isValid()) {
    error_ = QCoreApplication::translate("LineFinder", "At character %1: %2")
                 .arg(QLocale().toString(alone.patternErrorOffset() + 1), alone.errorString());
    return;
  }
  expression_.optimize();
  can_find_ = expression_.isValid();
}

template <typename Visit>
void LineFinder::each_match(const QString& line, Visit visit) const {
  if (!can_find_) {
    return;
  }
  for (QRegularExpressionMatchIterator i = expression_.globalMatch(line); i.hasNext();) {
    const QRegularExpressionMatch match = i.next();
    if (match.capturedLength() > 0) {
      visit(match.capturedStart(), match.capturedEnd());
    }
  }
}

std::vector<TextRange> LineFinder::matches_in(const ProgramText& text, std::uint32_t line) const {
  const QString characters = text.line_text(line);
  const std::size_t bytes = text.line(line).size();
  std::vector<TextRange> found;
  each_match(characters, [&](qsizetype from, qsizetype to) {
    found.push_back({{line, bytes_of(characters, from, bytes)}, {line, bytes_of(characters, to, bytes)}});
  });
  return found;
}

std::size_t LineFinder::count_in(const ProgramText& text, std::uint32_t line) const {
  std::size_t count = 0;
  each_match(text.line_text(line), [&count](qsizetype, qsizetype) { ++count; });
  return count;
}

}  // namespace feedscope::ui
