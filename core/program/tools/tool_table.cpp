#include "core/program/tools/tool_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"
#include "core/program/text/scanner.h"
#include "core/program/tools/tool_columns.h"

namespace feedscope {

namespace {

double unsigned_number(Scanner& scanner, bool decimal_comma) {
  const std::optional<double> value = scanner.number(decimal_comma);
  if (!value) {
    throw ReadFault{"tool-table", scanner.column(), NC_("core", "a number is missing"), {}};
  }
  return *value;
}

double signed_number(Scanner& scanner) {
  const double sign = scanner.take('-') ? -1 : (scanner.take('+'), 1);
  return sign * unsigned_number(scanner, true);
}

/// Sum of each radius and its additions, until all lines have been read.
class RadiusSum {
 public:
  void radius(const std::string& tool, double value) { sums_[tool].radius = value; }
  void excess(const std::string& tool, double value) { sums_[tool].excess = value; }
  void name(const std::string& tool, std::string_view name) { names_[tool] = name; }

  CutterRadii total() const {
    CutterRadii radii;
    for (const auto& [tool, sum] : sums_) {
      const double radius = sum.radius.value_or(-1) + sum.excess;
      if (!sum.radius || radius < 0) {
        continue;
      }
      radii.set(tool, radius);
      const std::size_t comma = std::min(tool.find(','), tool.size());
      if (const auto named = names_.find(tool.substr(0, comma)); named != names_.end()) {
        radii.set(named->second + tool.substr(comma), radius);
      }
    }
    return radii;
  }

 private:
  struct Sum {
    std::optional<double> radius;
    double excess = 0;
  };
  std::map<std::string, Sum> sums_;
  std::map<std::string, std::string> names_;
};

class LineReader {
 public:
  explicit LineReader(double unit) : unit_(unit) {}
  virtual ~LineReader() = default;
  virtual void read(std::string_view line) = 0;
  CutterRadii total() const { return sum_.total(); }

 protected:
  RadiusSum sum_;
  double unit_;
};

class SinumerikLines : public LineReader {
 public:
  using LineReader::LineReader;
  /// A line may contain several of them.
  void read(std::string_view line) override {
    for (std::size_t at = line.find('$'); at != std::string_view::npos; at = line.find('$', at + 1)) {
      Scanner scanner(line, at);
      read_variable(scanner);
    }
  }

 private:
  void read_variable(Scanner& scanner) {
    const bool radius = scanner.take("$TC_DP6[");
    if (radius || scanner.take("$TC_DP15[")) {
      std::string tool = fmt::format("{}", unsigned_number(scanner, false));
      if (scanner.take(',')) {
        tool += fmt::format(",{}", unsigned_number(scanner, false));
      }
      const double value = unit_ * value_behind(scanner);
      radius ? sum_.radius(tool, value) : sum_.excess(tool, value);
    } else if (scanner.take("$TC_TP2[")) {
      const std::string tool = fmt::format("{}", unsigned_number(scanner, false));
      const std::string_view rest = scanner.rest();
      const std::size_t from = rest.find('"');
      const std::size_t to = from == std::string_view::npos ? from : rest.find('"', from + 1);
      if (to != std::string_view::npos) {
        sum_.name(tool, rest.substr(from + 1, to - from - 1));
      }
    }
  }

  static double value_behind(Scanner& scanner) {
    if (!scanner.take(']') || !scanner.take('=')) {
      throw ReadFault{"tool-table", scanner.column(), NC_("core", "]= is missing"), {}};
    }
    return signed_number(scanner);
  }
};

class OffsetLines : public LineReader {
 public:
  using LineReader::LineReader;
  void read(std::string_view line) override {
    Scanner scanner(line.substr(0, line.find_first_of("(;")));
    std::array<std::optional<double>, 26> words;
    while (!scanner.at_end()) {
      const char letter = letters::to_upper(scanner.peek());
      if (!letters::is_letter(letter)) {
        return;
      }
      scanner.take(letter);
      const double value = signed_number(scanner);
      words[static_cast<std::size_t>(letter - 'A')] = value;
      if (letter == 'G' && (value == 20 || value == 21)) {
        unit_ = value == 20 ? units::from_inch(1) : 1;
      }
    }
    const auto word = [&](char letter) { return words[static_cast<std::size_t>(letter - 'A')]; };
    if (word('G') == 10 && word('P') && word('R')) {
      const std::string offset = fmt::format("{}", *word('P'));
      if (word('L') == 12) {
        sum_.radius(offset, unit_ * *word('R'));
      } else if (word('L') == 13) {
        sum_.excess(offset, unit_ * *word('R'));
      }
    }
  }
};

class LinuxcncLines : public LineReader {
 public:
  using LineReader::LineReader;
  void read(std::string_view line) override {
    Scanner scanner(line.substr(0, line.find(';')));
    std::string tool;
    while (!scanner.at_end()) {
      const char letter = letters::to_upper(scanner.peek());
      if (!letters::is_letter(letter)) {
        throw ReadFault{"tool-table",
                        scanner.column(),
                        message(NC_("core", "{} is not a letter with a number"), in_quotes(scanner.rest())),
                        {}};
      }
      scanner.take(letter);
      const double value = signed_number(scanner);
      if (letter == 'T') {
        tool = fmt::format("{}", value);
      } else if (letter == 'D' && !tool.empty()) {
        sum_.radius(tool, unit_ * value / 2);
      }
    }
  }
};

bool has(const SourceText& text, bool (*is_one)(std::string_view)) {
  for (std::uint32_t line = 1; line <= text.line_count(); ++line) {
    if (is_one(text.line(line))) {
      return true;
    }
  }
  return false;
}

bool is_sinumerik(std::string_view line) {
  return line.find("$TC_DP6[") != std::string_view::npos;
}

bool is_offset(std::string_view line) {
  Scanner scanner(line);
  if (scanner.take('N')) {
    scanner.skip_digits();
  }
  return scanner.take("G10") && scanner.take('L');
}

bool is_linuxcnc(std::string_view line) {
  Scanner scanner(line);
  return scanner.take('T') && letters::is_digit(scanner.peek()) && line.find('D') != std::string_view::npos;
}

template <class Lines>
CutterRadii read_lines(const SourceText& text, double unit) {
  Lines lines(unit);
  for (std::uint32_t line = 1; line <= text.line_count(); ++line) {
    try {
      lines.read(text.line(line));
    } catch (const ReadFault& fault) {
      throw InputError(message(NC_("core", "tool table '{}', line {}, column {}: {}"), text.name(), line,
                               fault.column, fault.message));
    }
  }
  return lines.total();
}

}  // namespace

CutterRadii read_tool_table(const SourceText& text, double unit) {
  if (has(text, is_sinumerik)) {
    return read_lines<SinumerikLines>(text, unit);
  }
  if (has(text, is_offset)) {
    return read_lines<OffsetLines>(text, unit);
  }
  if (const std::optional<ToolColumns> columns = ToolColumns::find(text, unit)) {
    return columns->read();
  }
  if (has(text, is_linuxcnc)) {
    return read_lines<LinuxcncLines>(text, unit);
  }
  throw InputError(message(NC_("core",
                               "'{}' is not a supported tool table; give lines such as \"T1 D10\" or "
                               "\"$TC_DP6[1,1]=5\", \"G10 L12 P1 R5\", or columns headed T and R"),
                           text.name()));
}

const std::vector<std::string>& tool_table_names() {
  static const std::vector<std::string> names = {"tool.t", "tool.tbl", "to.ini", "tools.csv"};
  return names;
}

}  // namespace feedscope
