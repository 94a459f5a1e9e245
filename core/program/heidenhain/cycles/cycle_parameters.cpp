#include "core/program/heidenhain/cycles/cycle_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

/// F words may be numbers: the largest number means the same.
constexpr double rapid_feed = 99999.999;

}  // namespace

void CycleParameters::read(int number, Scanner& scanner) {
  for (const CycleParameter& parameter : parameters_of_drilling(number)) {
    if (parameter.otherwise) {
      const double unit = parameter.unit == CycleUnit::plain ? 1 : modal_.unit;
      parameters().set_global(parameter.q, *parameter.otherwise / unit);
    }
  }
  read_into(parameters(), scanner);
}

void CycleParameters::read_into(QParameters& into, Scanner& scanner) {
  bool began = false;
  while (!scanner.at_end()) {
    const std::size_t before = scanner.at();
    const std::uint32_t column = scanner.column();
    const std::optional<QName> name = take_parameter(scanner);
    if (!name || !scanner.take('=')) {
      if (began) {
        throw ReadFault{"cycle-parameter", column,
                        message(NC_("core", "{} is not a parameter"), in_quotes(scanner.rest())),
                        NC_("core", "write parameters as Q200=2")};
      }
      // The title.
      scanner.move_to(std::max(before, static_cast<std::size_t>(column) - 1) + 1);
      continue;
    }
    began = true;
    if (scanner.take_keyword("PREDEF")) {
      const std::optional<double> value = predefined_.get(*name);
      if (!value) {
        throw ReadFault{"cycle-parameter", column,
                        message(NC_("core", "PREDEF for {} without a GLOBAL DEF"), name->text()),
                        NC_("core", "write a number, or the GLOBAL DEF before it")};
      }
      into.set(*name, *value);
      continue;
    }
    const bool f = scanner.take('F');
    if (scanner.take_keyword("MAX")) {
      into.set(*name, rapid_feed);
    } else if (modal_.tool_feed_word == FeedWord::value && scanner.take_keyword("AUTO")) {
      into.set(*name, modal_.tool_feed);
    } else if (f && scanner.take('U') && !modal_.is_inch()) {
      into.set(*name, read_value(scanner) * modal_.spindle_speed);
    } else if (f || scanner.take_keyword("AUTO")) {
      throw ReadFault{"cycle-parameter", column,
                      message(NC_("core", "this value of {} is not supported"), name->text()),
                      NC_("core", "write a number")};
    } else {
      into.set(*name, read_value(scanner));
    }
  }
}

std::optional<DrillingParameters> CycleParameters::drilling(int number, std::uint32_t column) const {
  DrillingParameters words;
  for (const CycleParameter& parameter : parameters_of_drilling(number)) {
    const std::optional<double> value = parameters().global(parameter.q);
    if (!value) {
      report(Severity::error, "cycle-parameter", parameter.q, column, [&] {
        return Text{message(NC_("core", "cycle {} has no value for Q{}"), number, parameter.q),
                    NC_("core", "the cycle is skipped; write all of its parameters")};
      });
      return std::nullopt;
    }
    if (!(std::abs(*value) <= largest_cycle_value)) {
      throw ReadFault{"cycle-parameter", column,
                      message(NC_("core", "cycle {}: Q{} is {}, beyond the largest number, 1000000000"),
                              number, parameter.q, *value),
                      NC_("core", "the cycle is skipped")};
    }
    words.*parameter.value = parameter.unit == CycleUnit::length ? to_mm(*value)
                             : parameter.unit != CycleUnit::feed ? *value
                             : *value >= rapid_feed              ? std::numeric_limits<double>::infinity()
                                                                 : modal_.to_feed(*value);
  }
  if (words.to_shoulder != 0) {
    report(Severity::warning, "cycle-value", number * 10, column, [&] {
      return Text{
          message(NC_("core", "cycle {}: Q395=1 measures the depth to the cylinder of the drill"), number),
          NC_("core", "the length of its point is in the tool table; the depth is shown as that of the tip")};
    });
  }
  return words;
}

double CycleParameters::value(int q) const {
  return std::clamp(parameters().global(q).value_or(0), -largest_cycle_value, largest_cycle_value);
}

}  // namespace feedscope::heidenhain
