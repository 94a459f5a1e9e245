#include "core/program/tools/tool_columns.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"
#include "core/program/text/scanner.h"

namespace feedscope {

namespace {

constexpr std::uint32_t max_lines_before_headings = 20;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view around = " \t\"";
  const std::size_t from = text.find_first_not_of(around);
  return from == std::string_view::npos ? std::string_view()
                                        : text.substr(from, text.find_last_not_of(around) + 1 - from);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(separator, from), line.size());
    parts.push_back(trimmed(line.substr(from, to - from)));
    from = to + 1;
  }
  return parts;
}

/// Starts of the words that blanks separate.
std::vector<std::size_t> word_starts(std::string_view line) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!letters::is_blank(line[i]) && (i == 0 || letters::is_blank(line[i - 1]))) {
      starts.push_back(i);
    }
  }
  return starts;
}

}  // namespace

std::optional<ToolColumns> ToolColumns::find(const SourceText& text, double unit) {
  ToolColumns columns(text, unit);
  const std::uint32_t last = std::min(text.line_count(), max_lines_before_headings);
  for (std::uint32_t line = 1; line <= last; ++line) {
    const std::string_view words = trimmed(text.line(line));
    if (words.starts_with("BEGIN ")) {
      columns.unit_ = words.ends_with("INCH") ? units::from_inch(1) : 1;
    } else if (columns.read_headings(text.line(line))) {
      columns.heads_ = line;
      return columns;
    }
  }
  return std::nullopt;
}

bool ToolColumns::read_headings(std::string_view line) {
  constexpr auto headings =
      std::to_array<std::pair<std::string_view, Meaning>>({{"T", Meaning::number},
                                                           {"NR", Meaning::number},
                                                           {"TOOL", Meaning::number},
                                                           {"NUMBER", Meaning::number},
                                                           {"NAME", Meaning::name},
                                                           {"R", Meaning::radius},
                                                           {"RADIUS", Meaning::radius},
                                                           {"DR", Meaning::excess},
                                                           {"D", Meaning::diameter},
                                                           {"DIAMETER", Meaning::diameter}});
  constexpr std::string_view separators = ";\t,";
  const std::size_t separator = line.find_first_of(separators);
  separator_ = separator == std::string_view::npos ? '\0' : line[separator];
  columns_.clear();
  const auto add = [&](std::string_view word, std::size_t from) {
    const auto known = std::find_if(headings.begin(), headings.end(),
                                    [&](const auto& heading) { return letters::same(heading.first, word); });
    columns_.push_back({known == headings.end() ? Meaning::other : known->second, from});
  };
  if (separator_ != '\0') {
    for (const std::string_view word : split(line, separator_)) {
      add(word, 0);
    }
  } else {
    for (const std::size_t from : word_starts(line)) {
      add(line.substr(from, line.find_first_of(" \t", from) - from), from);
    }
  }
  return (has(Meaning::number) || has(Meaning::name)) && (has(Meaning::radius) || has(Meaning::diameter));
}

bool ToolColumns::has(Meaning meaning) const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [meaning](const Column& column) { return column.meaning == meaning; });
}

std::vector<std::string_view> ToolColumns::cells(std::string_view line) const {
  if (separator_ != '\0') {
    return split(line, separator_);
  }
  std::vector<std::string_view> cells;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t from = std::min(columns_[i].from, line.size());
    const std::size_t to =
        i + 1 < columns_.size() ? std::min(columns_[i + 1].from, line.size()) : line.size();
    cells.push_back(trimmed(line.substr(from, to - from)));
  }
  return cells;
}

double ToolColumns::number(std::string_view cell, std::uint32_t line) const {
  try {
    Scanner scanner(cell);
    const double sign = scanner.take('-') ? -1 : (scanner.take('+'), 1);
    const std::optional<double> value = scanner.number(true);
    if (value && scanner.at_end()) {
      return sign * *value;
    }
  } catch (const ReadFault&) {
    // Reported below, with the line.
  }
  throw InputError(message(NC_("core", "tool table '{}', line {}: {} is not a number"), text_->name(), line,
                           in_quotes(cell)));
}

CutterRadii ToolColumns::read() const {
  CutterRadii radii;
  for (std::uint32_t line = heads_ + 1; line <= text_->line_count(); ++line) {
    const std::vector<std::string_view> cells = this->cells(text_->line(line));
    std::array<std::string_view, 2> tools;
    std::optional<double> radius;
    double excess = 0;
    for (std::size_t i = 0; i < std::min(cells.size(), columns_.size()); ++i) {
      const Meaning meaning = columns_[i].meaning;
      if (cells[i].empty() || meaning == Meaning::other) {
        continue;
      }
      if (meaning == Meaning::number || meaning == Meaning::name) {
        tools[meaning == Meaning::name ? 1 : 0] = cells[i];
      } else if (meaning == Meaning::excess) {
        excess = unit_ * number(cells[i], line);
      } else {
        radius = unit_ * number(cells[i], line) / (meaning == Meaning::diameter ? 2 : 1);
      }
    }
    if (!radius || *radius + excess < 0) {
      continue;
    }
    for (const std::string_view tool : tools) {
      if (!tool.empty()) {
        radii.set(tool, *radius + excess);
      }
    }
  }
  return radii;
}

}  // namespace feedscope
