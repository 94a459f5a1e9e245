// The part of SinumerikReader that reads what is more than letters with plain numbers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

namespace {

constexpr auto addresses = std::to_array<std::pair<std::string_view, Address>>(
    {{"CR", Address::cr},   {"AR", Address::ar},   {"TURN", Address::turn}, {"I1", Address::i1},
     {"J1", Address::j1},   {"K1", Address::k1},   {"AP", Address::ap},     {"RP", Address::rp},
     {"ANG", Address::ang}, {"RPL", Address::rpl}, {"PW", Address::pw},     {"PL", Address::pl},
     {"SD", Address::sd},   {"FB", Address::fb},   {"RND", Address::rnd},   {"RNDM", Address::rndm},
     {"CHF", Address::chf}, {"CHR", Address::chr}, {"FRC", Address::frc},   {"FRCM", Address::frcm}});

bool starts_number(char c) {
  return letters::is_digit(c) || c == '.' || c == '+' || c == '-';
}

/// Angles that turn the tool, and parts of the vectors that say its direction: A2 to A7 and so on.
bool is_orientation(std::string_view name) {
  constexpr auto names = std::to_array<std::string_view>({"LEAD", "TILT", "THETA", "PHI", "PSI", "NUT"});
  const bool part = name.size() == 2 &&
                    std::string_view("ABC").find(letters::to_upper(name[0])) != std::string_view::npos &&
                    name[1] >= '2' && name[1] <= '7';
  if (part) {
    return true;
  }
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view known) { return letters::same(known, name); });
}

[[noreturn]] void throw_unknown(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  throw ReadFault{"syntax", column, fmt::format("{} starts no word or statement", quoted(scanner.rest())),
                  "the rest of the line is not read and the block does not move; correct it"};
}

}  // namespace

void SinumerikReader::run_statements(Scanner& scanner) {
  // Before the block number, or a label without one.
  if (scanner.take(':') && !scanner.number()) {
    throw_unknown(scanner);
  }
  while (!scanner.at_end()) {
    run_item(scanner);
  }
}

void SinumerikReader::run_item(Scanner& scanner) {
  const char next = scanner.peek();
  if (next == '$') {
    run_system_variable(scanner);
    return;
  }
  if (!letters::is_letter(next) && next != '_') {
    throw_unknown(scanner);
  }
  const char second = scanner.peek_at(1);
  if (next == '_' || letters::is_letter(second) || second == '_') {
    run_name(scanner);
  } else if (letters::is_digit(second)) {
    run_word(scanner);
  } else {
    run_letter(scanner);
  }
}

void SinumerikReader::run_system_variable(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  scanner.take('$');
  const std::string name = upper_case(scanner.name());
  if (name == "TC_DP6") {
    set_tool_radius(scanner);
    return;
  }
  if (run_frame_variable(scanner, name)) {
    return;
  }
  const bool frame = name.find("FR") != std::string::npos || name == "TC_DP15";
  report(frame ? Severity::error : Severity::info, "system-variable", kind_of(name), column, [&] {
    return Text{fmt::format("{} is set by the program, which is not read", feedscope::quoted("$" + name)),
                frame ? "the path is shown without it" : "the path stays as it is"};
  });
  skip_value(scanner);
}

/// "X10", "G641", or an address with a number, "I1=".
void SinumerikReader::run_word(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  Scanner behind = scanner;
  const std::string_view name = behind.name();
  const char after = behind.peek();
  if (letters::to_upper(name[0]) == 'R' && (after == '=' || after == '[')) {
    scanner.take('R');
    const std::optional<int> number = values_.r_number(scanner);
    if (!number) {
      throw_unknown(scanner);
    }
    require(scanner, '=');
    values_.variables().set_r(*number, values_.read(scanner));
  } else if (after == '=' || after == '[') {
    scanner = behind;
    if (run_assignment(scanner, name) || run_frame_assignment(scanner, name)) {
      return;
    }
    run_extended(scanner, name, column);
  } else {
    run_letter(scanner);
  }
}

void SinumerikReader::run_extended(Scanner& scanner, std::string_view name, std::uint32_t column) {
  if (run_address(scanner, name, column)) {
    return;
  }
  const char letter = letters::to_upper(name[0]);
  if (std::string_view("SMHTDFG").find(letter) != std::string_view::npos) {
    const bool value = scanner.peek() == '=';
    Scanner ahead = scanner;
    skip_value(scanner);
    if (letter == 'S' && value && ahead.take('=') && name == "S1") {
      words_.set('S', {.value = values_.read(ahead), .column = column, .reading = Reading::modal});
    }
    return;
  }
  if (scanner.peek() == '[') {
    skip_brackets(scanner);
  }
  require(scanner, '=');
  const BlockWords::Value value = coordinate(scanner, column);
  // The machine's names of the axes, as G74 and G75 have them: "Z1=0".
  const bool names_axis = machine_axes_ && letter >= 'X' && letter <= 'Z' && name.substr(1) == "1";
  if (names_axis) {
    words_.set(letter, value);
  } else {
    report_axis(name, column, value.value);
  }
}

/// A letter with a number behind it, "=" and a value, or an index.
void SinumerikReader::run_letter(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::size_t from = scanner.at();
  const char letter = letters::to_upper(scanner.peek());
  scanner.take(letter);
  const char next = scanner.peek();
  const bool assigned = next == '=';
  if (Variable* const variable =
          assigned || next == '[' ? values_.variables().find_letter(letter) : nullptr) {
    values_.assign(scanner, *variable, std::string_view(&letter, 1));
    return;
  }
  if (letter == 'R' && next == '[') {
    const std::optional<int> number = values_.r_number(scanner);
    require(scanner, '=');
    values_.variables().set_r(number.value_or(0), values_.read(scanner));
    return;
  }
  const bool is_address = letter >= 'A' && letter <= 'Z' && next != '[';
  if (!is_address || !(assigned || starts_number(next))) {
    // Of a spindle: "S[2]=1000".
    if (next != '[' || std::string_view("SMHTD").find(letter) == std::string_view::npos) {
      scanner.move_to(from);
      throw_unknown(scanner);
    }
    skip_value(scanner);
    return;
  }
  if (assigned) {
    scanner.take('=');
  }
  if (assigned && letter == 'T' && values_.text_follows(scanner)) {
    choose_tool(values_.read_text(scanner));
    return;
  }
  if (assigned && scanner.take_name("QU")) {
    skip_brackets(scanner);
    return;
  }
  const BlockWords::Value value =
      assigned ? coordinate(scanner, column)
               : BlockWords::Value{.value = values_.bounded(values_.read_operand(scanner), column),
                                   .column = column,
                                   .reading = Reading::modal};
  const std::string_view written = scanner.text().substr(from, scanner.at() - from);
  if (letter == 'G') {
    apply_g(value.value, column, written);
  } else if (letter == 'M') {
    apply_m(value.value);
  } else if (letter == 'P') {
    words_.set(Address::p, value);
  } else if (letter != 'N') {
    set_letter(letter, value, written);
  }
}

/// The value behind "=": an expression, or AC(), IC() and their like around one.
BlockWords::Value SinumerikReader::coordinate(Scanner& scanner, std::uint32_t column) {
  if (const std::optional<double> number = Values::plain_number(scanner)) {
    return {.value = *number, .column = column, .reading = Reading::modal};
  }
  struct Kind {
    std::string_view name;
    Reading reading;
    Across across = Across::modal;
  };
  constexpr auto kinds = std::to_array<Kind>({{"AC", Reading::absolute},
                                              {"IC", Reading::incremental},
                                              {"DC", Reading::absolute},
                                              {"ACP", Reading::absolute},
                                              {"ACN", Reading::absolute},
                                              {"DAC", Reading::absolute, Across::diameter},
                                              {"DIC", Reading::incremental, Across::diameter},
                                              {"RAC", Reading::absolute, Across::radius},
                                              {"RIC", Reading::incremental, Across::radius}});
  for (const Kind& kind : kinds) {
    if (scanner.take_name(kind.name)) {
      require(scanner, '(');
      const double value = values_.read_bounded(scanner);
      require(scanner, ')');
      return {.value = value, .column = column, .reading = kind.reading, .across = kind.across};
    }
  }
  return {.value = values_.read_bounded(scanner), .column = column, .reading = Reading::modal};
}

void SinumerikReader::run_name(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::size_t from = scanner.at();
  const std::string_view name = scanner.name();
  const char after = scanner.peek();
  if (after == ':') {
    scanner.take(':');
    return;
  }
  if (run_assignment(scanner, name) || run_frame_assignment(scanner, name)) {
    return;
  }
  if (after == '=' && (run_address(scanner, name, column) || run_path_value(scanner, name, column))) {
    return;
  }
  if (const Run run = find_statement(name)) {
    (this->*run)(scanner);
    return;
  }
  if (const Function* const function = find_function(name)) {
    run_function(scanner, *function, column);
    return;
  }
  if (after == '=' && machine_axes_ && letters::same(name, "FP")) {
    constexpr double most_points = 1000;
    scanner.take('=');
    fixed_point_ = static_cast<int>(std::clamp(coordinate(scanner, column).value, 0.0, most_points));
    return;
  }
  if (after == '=' && is_orientation(name)) {
    scanner.take('=');
    report_axis(name, column, coordinate(scanner, column).value);
    return;
  }
  if (after == '=' || after == '[') {
    report(Severity::error, "unknown-name", kind_of(name), column, [&] {
      return Text{fmt::format("{} is no variable, address or axis that is known", quoted(name)),
                  "its value is left out; define a variable by DEF before it is used"};
    });
    skip_value(scanner);
    return;
  }
  scanner.move_to(from);
  call_ = read_call(scanner);
}

bool SinumerikReader::run_assignment(Scanner& scanner, std::string_view name) {
  Variable* const variable = values_.variables().find(name);
  const char after = scanner.peek();
  if (variable == nullptr || (after != '=' && after != '[')) {
    return false;
  }
  values_.assign(scanner, *variable, name);
  return true;
}

bool SinumerikReader::run_address(Scanner& scanner, std::string_view name, std::uint32_t column) {
  const auto found = std::find_if(addresses.begin(), addresses.end(),
                                  [&](const auto& entry) { return letters::same(entry.first, name); });
  if (found == addresses.end() || !scanner.take('=')) {
    return false;
  }
  words_.set(found->second, coordinate(scanner, column));
  return true;
}

bool SinumerikReader::run_path_value(Scanner& scanner, std::string_view name, std::uint32_t column) {
  using Setter = void (PathWords::*)(double);
  constexpr auto setters =
      std::to_array<std::pair<std::string_view, Setter>>({{"ADIS", &PathWords::set_distance},
                                                          {"ADISPOS", &PathWords::set_rapid_distance},
                                                          {"CTOL", &PathWords::set_tolerance},
                                                          {"OTOL", &PathWords::set_orientation_tolerance}});
  for (const auto& [known, set] : setters) {
    if (!letters::same(name, known) || !scanner.take('=')) {
      continue;
    }
    const double value = values_.read(scanner);
    if (known.starts_with("ADIS") && value < 0) {
      throw ReadFault{"path-value", column, fmt::format("{}={} is negative", known, value),
                      "write a distance of zero or more; the block does not move"};
    }
    (path_words_.*set)(known == "OTOL" ? units::from_deg(value) : to_mm(value));
    applied_ = Applied::none;
    return true;
  }
  return false;
}

void SinumerikReader::run_function(Scanner& scanner, const Function& function, std::uint32_t column) {
  apply(function, column);
  if (function.action == Action::polynomial || function.action == Action::accept ||
      function.action == Action::report) {
    skip_value(scanner);
  }
}

/// PO[X]=(...), and PO[X]=value for an end alone.
void SinumerikReader::run_polynomial(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  require(scanner, '[');
  const std::string_view axis = scanner.name();
  const char letter = axis.empty() ? ' ' : letters::to_upper(axis[0]);
  require(scanner, ']');
  require(scanner, '=');
  if (axis.size() != 1 || letter < 'X' || letter > 'Z') {
    report(Severity::error, "polynomial", 0, column, [&] {
      return Text{axis.empty() ? "a denominator of polynomials is not read"
                               : fmt::format("a polynomial of axis {} is not read", quoted(axis)),
                  "X, Y and Z are shown without it"};
    });
    if (scanner.peek() == '(') {
      skip_brackets(scanner);
    } else {
      values_.read(scanner);
    }
    return;
  }
  const bool list = scanner.take('(');
  PolynomialWord word;
  const BlockWords::Value end = coordinate(scanner, column);
  words_.set(letter, end);
  for (std::size_t i = 0; list && scanner.take(','); ++i) {
    if (i >= word.coefficients.size()) {
      throw ReadFault{"polynomial", scanner.column(), "a polynomial has more than five coefficients",
                      "the block does not move; write a polynomial of degree 5 or less"};
    }
    word.coefficients[i] = to_mm(values_.read_bounded(scanner));
  }
  if (list) {
    require(scanner, ')');
  }
  polynomials_[static_cast<std::size_t>(letter - 'X')] = word;
  has_polynomials_ = true;
}

/// Index, arguments and value behind a name that is not read.
void SinumerikReader::skip_value(Scanner& scanner) {
  while (scanner.peek() == '[' || scanner.peek() == '(') {
    skip_brackets(scanner);
  }
  if (!scanner.take('=')) {
    return;
  }
  while (!scanner.at_end()) {
    const char c = scanner.peek();
    if (c == '(' || c == '[') {
      skip_brackets(scanner);
    } else if (c == '"') {
      values_.read_text(scanner);
    } else {
      scanner.move_to(scanner.at() + 1);
    }
    if (letters::is_blank(scanner.peek_at(0))) {
      break;
    }
  }
}

void SinumerikReader::report_axis(std::string_view name, std::uint32_t column, double value) {
  double& last = other_axes_[upper_case(name)];
  if (std::exchange(last, value) == value) {
    return;
  }
  const bool cuts = modal_.motion == nullptr || modal_.motion->action != Action::rapid;
  note_other_axis(is_orientation(name) ? "tool orientation" : upper_case(name), value,
                  !cuts       ? AxisMotion::positions
                  : oriented_ ? AxisMotion::at_tip
                              : AxisMotion::cuts,
                  column);
}

}  // namespace feedscope
