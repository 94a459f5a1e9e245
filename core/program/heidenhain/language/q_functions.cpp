#include "core/program/heidenhain/language/q_functions.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

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
      throw ReadFault{"unread-statement", column,
                      message(NC_("core", "{} is not a text"), in_quotes(scanner.rest())),
                      NC_("core", "the assignment is skipped; write \"...\" or QS parameters, joined by ||")};
    }
  } while (scanner.take("||"));
  return text;
}

double angle_of(double opposite, double adjacent) {
  const double angle = units::to_deg(std::atan2(opposite, adjacent));
  return angle < 0 ? angle + 360 : angle;
}

}  // namespace

void QFunctions::assign(Scanner& scanner) {
  const std::optional<QName> name = take_parameter(scanner);
  const std::uint32_t column = scanner.column();
  if (!name || !scanner.take('=')) {
    throw ReadFault{"unread-statement", column,
                    message(NC_("core", "{} is not an assignment"), in_quotes(scanner.text())),
                    NC_("core", "it is skipped; write Q1 = 5")};
  }
  if (name->kind == QName::Kind::text) {
    parameters().set_text(name->number, text_value(scanner, parameters()));
  } else {
    parameters().set(*name, context_.formulas.read(scanner));
  }
  if (!scanner.at_end()) {
    throw ReadFault{"expression", scanner.column(),
                    message(NC_("core", "{} does not belong to the formula"), in_quotes(scanner.rest())),
                    NC_("core", "the value before it is assigned; correct the formula")};
  }
}

void QFunctions::run(const FunctionCall& call) {
  const double a = call.values[0];
  const double b = call.values[1];
  const auto set = [&](double value) {
    if (!std::isfinite(value)) {
      throw ReadFault{
          "expression-value", call.column,
          message(NC_("core", "function {} has no finite value for {} and {}"), call.number, a, b),
          NC_("core", "check the values that go into it")};
    }
    parameters().set(*call.result, value);
  };
  const auto jump_if = [&](bool condition) {
    if (condition) {
      calls_.jump_to_label(call.label, call.column);
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
      return note(call.number, call.column);
  }
}

void QFunctions::note(int number, std::uint32_t column) {
  constexpr int error = 14;
  constexpr int write_system_data = 17;
  constexpr int read_table = 28;
  if (number == error) {
    report(Severity::error, "program-error", 0, column, [] {
      return Text{NC_("core", "the program stops here with an error (FN 14)"),
                  NC_("core", "the rest is skipped; check the values that lead here")};
    });
    calls_.stop_all();
    return;
  }
  const bool matters = number == write_system_data || number == read_table;
  report(matters ? Severity::warning : Severity::info, "unread-function", number, column, [&] {
    return Text{message(NC_("core", "FN {} is not supported"), number),
                matters ? NC_("core", "what it writes to the machine or reads from a table is not known")
                        : NC_("core", "it does not change the path")};
  });
}

}  // namespace feedscope::heidenhain
