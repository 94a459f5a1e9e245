#include "core/program/heidenhain/language/statement_lines.h"

#include <algorithm>

namespace feedscope::heidenhain {

namespace {

/// True if the statement is only a block number.
bool is_number_only(std::string_view statement) {
  return statement.find_first_not_of("0123456789Nn/ \t") == std::string_view::npos;
}

}  // namespace

std::string_view StatementLines::add(std::string_view line) {
  const std::size_t comment = line.find(';');
  std::string_view statement = line.substr(0, comment);
  const std::size_t last = statement.find_last_not_of(" \t");
  bool goes_on = last != std::string_view::npos && statement[last] == '~';
  if (goes_on) {
    statement = statement.substr(0, last);
  } else if (comment != std::string_view::npos) {
    goes_on = line[line.find_last_not_of(" \t")] == '~';
  }
  if (!goes_on && parts_.empty() && !comment_goes_on_) {
    return last != std::string_view::npos ? statement : std::string_view();
  }
  // "3 ;a long remark that goes on~": all of its lines are a remark.
  const bool remark =
      comment_goes_on_ || (parts_.empty() && comment != std::string_view::npos && is_number_only(statement));
  comment_goes_on_ = remark && goes_on;
  if (remark) {
    return {};
  }
  parts_.push_back({joined_.size(), lines_.line()});
  joined_.append(statement) += ' ';
  return goes_on ? std::string_view() : joined();
}

std::string_view StatementLines::joined() {
  comment_goes_on_ = false;
  const bool blank = joined_.find_first_not_of(" \t") == std::string::npos;
  if (blank) {
    clear();
  }
  return joined_;
}

void StatementLines::clear() {
  joined_.clear();
  parts_.clear();
}

DiagnosticLog::Place StatementLines::place(std::uint32_t column) const {
  DiagnosticLog::Place place = lines_.place(column);
  const auto length = [&](std::uint32_t line) {
    return static_cast<std::uint32_t>(lines_.text().line(line).size());
  };
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
    if (column > part->start || part + 1 == parts_.rend()) {
      place.line = part->line;
      place.column =
          std::min(column - std::min(column, static_cast<std::uint32_t>(part->start)), length(part->line));
      break;
    }
  }
  place.column = std::min(place.column, length(place.line));
  return place;
}

}  // namespace feedscope::heidenhain
