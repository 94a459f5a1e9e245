#include "core/identification/section_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/base/error.h"
#include "core/trace/trace_row.h"

namespace feedscope {
namespace {

constexpr std::size_t least_sections = 4;

std::string in_lower(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  return lower;
}

std::string_view next_line(std::string_view& text) {
  const auto end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  while (line.ends_with('\r') || line.ends_with(' ')) {
    line.remove_suffix(1);
  }
  return line;
}

bool says_nothing(std::string_view line) {
  return line.empty() || line.front() == '#';
}

/// Columns found in a header.
struct TimeColumns {
  char separator = ',';
  std::size_t section = 0;
  std::size_t time = 0;
  double unit = 1;  ///< [s]
};

std::optional<TimeColumns> columns_of(std::string_view head) {
  for (const char separator : {'\t', ';', ','}) {
    std::vector<std::string_view> titles;
    split_row(head, separator, titles);
    std::optional<std::size_t> section;
    std::optional<std::size_t> time;
    TimeColumns columns;
    columns.separator = separator;
    for (std::size_t i = 0; i < titles.size(); ++i) {
      const std::string title = in_lower(titles[i]);
      const bool milliseconds = title == "ms" || title.starts_with("millisecond") || title.ends_with("[ms]");
      if (title == "section" || title == "lines") {
        section = i;
      } else if (!time &&
                 (milliseconds || title == "s" || title.starts_with("second") || title.starts_with("time"))) {
        constexpr double millisecond = 1e-3;
        time = i;
        columns.unit = milliseconds ? millisecond : 1;
      }
    }
    if (section && time) {
      columns.section = *section;
      columns.time = *time;
      return columns;
    }
  }
  return std::nullopt;
}

std::optional<std::uint32_t> whole_number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Value of the last digit of a number: 0.01 for "1.25".
double last_digit(std::string_view number, char decimal) {
  const auto point = number.find(decimal);
  return point == std::string_view::npos ? 1 : std::pow(10, -static_cast<double>(number.size() - point - 1));
}

/// Determines the step of the clock, possibly several of the last digit: the common divisor of all times.
void find_resolution(std::vector<SectionTime>& times) {
  double digit = times.front().resolution;
  for (const SectionTime& time : times) {
    digit = std::min(digit, time.resolution);
  }
  long long step = 0;
  for (const SectionTime& time : times) {
    step = std::gcd(step, std::llround(time.seconds / digit));
  }
  for (SectionTime& time : times) {
    time.resolution = digit * static_cast<double>(std::max(step, 1LL));
  }
}

constexpr std::string_view mark_word = "section ";

/// Removes the number at the start of `text` and returns it.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) {
    return std::nullopt;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

}  // namespace

bool is_section_times(std::string_view head) {
  while (!head.empty()) {
    const std::string_view line = next_line(head);
    if (!says_nothing(line)) {
      return columns_of(line).has_value();
    }
  }
  return false;
}

std::vector<SectionTime> parse_section_times(std::string_view text, const std::string& name) {
  std::vector<SectionTime> times;
  std::optional<TimeColumns> columns;
  std::vector<std::string_view> fields;
  for (std::uint32_t row = 1; !text.empty(); ++row) {
    const std::string_view line = next_line(text);
    if (says_nothing(line)) {
      continue;
    }
    if (!columns) {
      columns = columns_of(line);
      if (!columns) {
        throw InputError(message(NC_("core",
                                     "{}:{}: not a table of section times; the first row must have the "
                                     "titles, such as section,seconds"),
                                 name, row));
      }
      continue;
    }
    split_row(line, columns->separator, fields);
    const std::string_view section =
        columns->section < fields.size() ? fields[columns->section] : std::string_view();
    const std::string_view number =
        columns->time < fields.size() ? fields[columns->time] : std::string_view();
    const char decimal = columns->separator != ',' && number.find(',') != std::string_view::npos ? ',' : '.';
    const std::optional<double> value = field_number(number, decimal);
    constexpr double longest = 1e6;
    if (section.empty() || !value || !(*value > 0) || !(*value * columns->unit < longest)) {
      throw InputError(message(NC_("core",
                                   "{}:{}: '{}' is not a section and its time; a row is like 12,1.234, with "
                                   "a time above 0 and below {:g} s"),
                               name, row, line, longest));
    }
    const auto same = std::ranges::find(times, section, &SectionTime::section);
    if (same != times.end()) {
      throw InputError(
          message(NC_("core", "{}:{}: section {} has a time in line {} already; keep one of the two"), name,
                  row, section, same->row));
    }
    times.push_back(
        {std::string(section), *value * columns->unit, columns->unit * last_digit(number, decimal), row});
  }
  if (times.size() < least_sections) {
    throw InputError(message(NC_("core", "{}: section times given: {}; at least {} can tell something"), name,
                             times.size(), least_sections));
  }
  find_resolution(times);
  return times;
}

ProgramSections::ProgramSections(const SourceText& program)
    : name_(program.name()), line_count_(program.line_count()) {
  for (std::uint32_t line = 1; line <= line_count_; ++line) {
    const std::string lower = in_lower(program.line(line));
    std::string_view rest = lower;
    for (auto at = rest.find(mark_word); at != std::string_view::npos; at = rest.find(mark_word)) {
      rest.remove_prefix(at + mark_word.size());
      const std::optional<std::uint32_t> section = take_number(rest);
      const bool begins = rest.starts_with(" begins");
      if (!section || !(begins || rest.starts_with(" ends"))) {
        continue;
      }
      std::uint32_t& mark = begins ? marked_[*section].first : marked_[*section].last;
      mark = mark == 0 ? line : mark;
    }
  }
}

SectionLines ProgramSections::lines_of(const SectionTime& time, const std::string& table) const {
  const auto dash = time.section.find('-');
  SectionLines lines;
  if (dash != std::string::npos) {
    lines.first = whole_number(std::string_view(time.section).substr(0, dash)).value_or(0);
    lines.last = whole_number(std::string_view(time.section).substr(dash + 1)).value_or(0);
  } else if (const auto number = whole_number(time.section)) {
    const auto found = marked_.find(*number);
    lines = found != marked_.end() ? found->second : lines;
  }
  if (lines.first == 0 || lines.last < lines.first || lines.last > line_count_) {
    throw InputError(message(NC_("core",
                                 "{}:{}: {} has no section '{}'; a section is marked by the comments SECTION "
                                 "12 BEGINS and SECTION 12 ENDS, or is given by its lines, as 40-55"),
                             table, time.row, name_, time.section));
  }
  return lines;
}

std::string section_mark(std::size_t section, bool begins) {
  return fmt::format("SECTION {} {}", section, begins ? "BEGINS" : "ENDS");
}

}  // namespace feedscope
