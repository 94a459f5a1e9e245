// The part of HeidenhainCore for Q parameters and FN functions.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_core.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

std::string text_value(Scanner& scanner, const QParameters& parameters) {
  std::string text;
  do {
    const std::uint32_t column = scanner.column();
    if (scanner.take('"')) {
      const std::string_view rest = scanner.text().substr(scanner.at());
      const std::size_t end = std::min(rest.find('"'), rest.size());
      text += rest.substr(0, end);
      scanner.move_to(scanner.at() + std::min(end + 1, rest.size()));
    } else if (const auto name = take_parameter(scanner); name && name->kind == QName::Kind::text) {
      text += parameters.text(name->number);
    } else {
      throw ReadFault{"unread-statement", column, fmt::format("{} is no text", quoted(scanner.rest())),
                      "of texts only \"...\", QS parameters and || are read; the assignment is left out"};
    }
  } while (scanner.take("||"));
  return text;
}

double angle_of(double opposite, double adjacent) {
  const double angle = units::to_deg(std::atan2(opposite, adjacent));
  return angle < 0 ? angle + 360 : angle;
}

}  // namespace

void HeidenhainCore::assign(Scanner& scanner) {
  const std::optional<QName> name = take_parameter(scanner);
  const std::uint32_t column = scanner.column();
  if (!name || !scanner.take('=')) {
    throw ReadFault{"unread-statement", column, fmt::format("{} is no assignment", quoted(scanner.text())),
                    "it is left out; write Q1 = 5"};
  }
  if (name->kind == QName::Kind::text) {
    parameters_.set_text(name->number, text_value(scanner, parameters_));
  } else {
    parameters_.set(*name, formulas_.read(scanner));
  }
  if (!scanner.at_end()) {
    throw ReadFault{"expression", scanner.column(),
                    fmt::format("{} does not belong to the formula", quoted(scanner.rest())),
                    "what stands before it is assigned; check the formula"};
  }
}

void HeidenhainCore::run_function(const FunctionCall& call) {
  const double a = call.values[0];
  const double b = call.values[1];
  const auto set = [&](double value) {
    if (!std::isfinite(value)) {
      throw ReadFault{"expression-value", call.column,
                      fmt::format("function {} has no finite value for {} and {}", call.number, a, b),
                      "check the values that go into it"};
    }
    parameters_.set(*call.result, value);
  };
  const auto jump_if = [&](bool condition) {
    if (condition) {
      jump_to_label(call.label, call.column);
    }
  };
  switch (call.number) {
    case 0:
      return set(a);
    case 1:
      return set(a + b);
    case 2:
      return set(a - b);
    case 3:
      return set(a * b);
    case 4:
      return set(a / b);
    case 5:
      return set(std::sqrt(a));
    case 6:
      return set(std::sin(units::from_deg(a)));
    case 7:
      return set(std::cos(units::from_deg(a)));
    case 8:
      return set(std::hypot(a, b));
    case 13:
      return set(angle_of(a, b));
    case 9:
      return jump_if(a == b);
    case 10:
      return jump_if(a != b);
    case 11:
      return jump_if(a > b);
    case 12:
      return jump_if(a < b);
    default:
      return note_function(call.number, call.column);
  }
}

void HeidenhainCore::note_function(int number, std::uint32_t column) {
  constexpr int error = 14;
  constexpr int write_system_data = 17;
  constexpr int read_table = 28;
  if (number == error) {
    report(Severity::error, "program-error", 0, column, [] {
      return Text{"the program stops itself here with an error (FN 14)",
                  "the rest is left out; check the values that lead here"};
    });
    contour_.flush();
    end_program();
    return;
  }
  const bool matters = number == write_system_data || number == read_table;
  report(matters ? Severity::warning : Severity::info, "unread-function", number, column, [&] {
    return Text{fmt::format("FN {} is not read", number),
                matters ? "what it changes in the machine or reads from a table is not known"
                        : "it does not change the path"};
  });
}

void HeidenhainCore::throw_unread_words(Scanner& scanner, std::string_view where) {
  const std::uint32_t column = scanner.column();
  throw ReadFault{"unread-word", column,
                  fmt::format("{} does not belong into {}", quoted(scanner.rest()), where),
                  "the block is left out; check it"};
}

std::optional<std::string> HeidenhainCore::tool_name(Scanner& scanner) {
  const char first = letters::to_upper(scanner.peek());
  const bool is_text = first == '"' || (first == 'Q' && letters::to_upper(scanner.peek_at(1)) == 'S');
  if (is_text) {
    return label(scanner);
  }
  if (letters::is_digit(first) || first == 'Q') {
    return fmt::format("{}", formulas_.read_value(scanner));
  }
  return std::nullopt;
}

void HeidenhainCore::read_system_data(Scanner& scanner, std::uint32_t column) {
  scanner.take_keyword("SYSREAD");
  const std::optional<QName> result = take_parameter(scanner);
  if (!result || result->kind == QName::Kind::text || !scanner.take('=') || !scanner.take("ID")) {
    throw_unread_words(scanner, "FN 18");
  }
  const double group = formulas_.read_value(scanner);
  const double number = scanner.take("NR") ? formulas_.read_value(scanner) : 0;
  const double index = scanner.take("IDX") ? formulas_.read_value(scanner) : 0;
  read_system_data(*result, group, number, index, column);
}

/// iTNC 530 HSCI technical manual, 9.5.4. System data are metric whatever the unit of the program.
std::optional<double> HeidenhainCore::system_data(double group, double number, double index) {
  const auto asks = [&](int g, int n) { return group == g && number == n; };
  const int axis = index == 1 || index == 2 || index == 3 ? static_cast<int>(index) - 1 : -1;
  if (asks(10, 1)) {
    return is_inch() ? 1 : 0;
  }
  if (asks(20, 1)) {
    return number_of_tool();
  }
  if (asks(20, 3)) {
    return normal_axis(contour_.plane());
  }
  if (asks(20, 4)) {
    return spindle_speed_;
  }
  if (asks(20, 9) && feed_.mode == FeedMode::per_minute) {
    return units::to_mm_min(feed_.value);
  }
  if (asks(50, 2)) {
    const std::string tool = fmt::format("{}", index);
    return cutter_radius(tool, defined_radii_.find(tool));
  }
  if (asks(200, 1)) {
    return tool_radius_;
  }
  if (asks(220, 2) && axis >= 0) {
    return transformations_.shift()[axis];
  }
  if (asks(270, 1) && axis >= 0) {
    return contour_.position()[axis];
  }
  return std::nullopt;
}

std::optional<double> HeidenhainCore::number_of_tool() const {
  double number = 0;
  const auto [end, status] = std::from_chars(tool_.data(), tool_.data() + tool_.size(), number);
  return status == std::errc() && end == tool_.data() + tool_.size() ? std::optional(number) : std::nullopt;
}

void HeidenhainCore::read_system_data(const QName& result, double group, double number, double index,
                                      std::uint32_t column) {
  const std::optional<double> value = system_data(group, number, index);
  const bool asks_position = value && group == 270;
  if (!value) {
    report(Severity::warning, "system-data", 0, column, [&] {
      return Text{
          fmt::format("FN 18 asks for ID{} NR{} IDX{}, which only the machine knows", group, number, index),
          fmt::format("{} becomes 0; assign the value of your machine instead", result.text())};
    });
  } else if (asks_position && (programmed_axes_ >> (static_cast<int>(index) - 1) & 1) == 0) {
    report(Severity::warning, "system-data", static_cast<int>(index), column, [&] {
      return Text{
          fmt::format("FN 18 asks where {} is before the program has gone there",
                      "XYZ"[static_cast<int>(index) - 1]),
          fmt::format("{} becomes that of the start, which is taken as zero; assign the value of your "
                      "machine instead",
                      result.text())};
    });
  }
  parameters_.set(result, value.value_or(0));
}

}  // namespace feedscope
