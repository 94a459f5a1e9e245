#include "core/program/sinumerik/language/assignments.h"

#include <algorithm>
#include <optional>

#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

void Assignments::assign(Scanner& scanner, Variable& variable, std::string_view name) {
  const std::size_t first = values_.element(scanner, variable, name);
  require(scanner, '=');
  if (scanner.take_name("SET")) {
    set_list(scanner, variable, first);
  } else if (scanner.take_name("REP")) {
    repeat_one(scanner, variable, first);
  } else {
    set_one(scanner, variable, first);
  }
}

bool Assignments::assign_r(Scanner& scanner) {
  const std::optional<int> number = values_.r_number(scanner);
  if (!number) {
    return false;
  }
  require(scanner, '=');
  values_.variables().set_r(*number, values_.read(scanner));
  return true;
}

void Assignments::initialise(Scanner& scanner, Variable& variable) {
  if (scanner.take_name("SET") || (variable.count() > 1 && scanner.peek() == '(')) {
    set_list(scanner, variable, 0);
  } else if (scanner.take_name("REP")) {
    repeat_one(scanner, variable, 0);
  } else {
    set_one(scanner, variable, 0);
    copy_on(variable, 0, static_cast<double>(variable.count()));
  }
}

void Assignments::set_list(Scanner& scanner, Variable& variable, std::size_t first) {
  require(scanner, '(');
  std::size_t index = first;
  do {
    if (index >= variable.count()) {
      throw_no_element(NC_("core", "\"the array\""), scanner.column(), static_cast<double>(index),
                       variable.count());
    }
    if (scanner.peek() != ',' && scanner.peek() != ')') {
      set_one(scanner, variable, index);
    }
    ++index;
  } while (scanner.take(','));
  require(scanner, ')');
}

void Assignments::repeat_one(Scanner& scanner, Variable& variable, std::size_t first) {
  require(scanner, '(');
  set_one(scanner, variable, first);
  double count = static_cast<double>(variable.count());
  if (scanner.take(',')) {
    count = std::min(count, values_.read(scanner));
  }
  require(scanner, ')');
  copy_on(variable, first, count);
}

void Assignments::copy_on(Variable& variable, std::size_t first, double count) {
  for (std::size_t i = first + 1; i < variable.count() && static_cast<double>(i - first) < count; ++i) {
    if (variable.is_text()) {
      variable.texts[i] = variable.texts[first];
    } else {
      variable.numbers[i] = variable.numbers[first];
    }
  }
}

void Assignments::set_one(Scanner& scanner, Variable& variable, std::size_t index) {
  if (!variable.is_text()) {
    variable.set(index, values_.read(scanner));
  } else if (variable.type == Type::axis && !values_.text_follows(scanner)) {
    variable.texts.at(index) = upper_case(scanner.name());
  } else {
    variable.texts.at(index) = values_.read_text(scanner);
  }
}

LoopCounter Assignments::read_counter(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  Scanner behind = scanner;
  if (behind.take('R')) {
    if (const std::optional<int> number = values_.r_number(behind)) {
      scanner = behind;
      return {.r = *number, .variable = nullptr, .element = 0};
    }
  }
  const std::string_view name = scanner.name();
  Variable* const found = values_.variables().find(name);
  if (found == nullptr || found->is_text()) {
    throw ReadFault{"syntax", column, message(NC_("core", "FOR cannot count with {}"), in_quotes(name)),
                    NC_("core", "use an R parameter or a variable defined by DEF INT")};
  }
  return {.r = -1, .variable = found, .element = values_.element(scanner, *found, name)};
}

double Assignments::get(const LoopCounter& counter) const {
  return counter.r >= 0 ? values_.variables().r(counter.r).value_or(0)
                        : counter.variable->numbers.at(counter.element);
}

void Assignments::set(const LoopCounter& counter, double value) {
  if (counter.r >= 0) {
    values_.variables().set_r(counter.r, value);
  } else {
    counter.variable->set(counter.element, value);
  }
}

}  // namespace feedscope::sinumerik
