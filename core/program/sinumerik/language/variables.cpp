#include "core/program/sinumerik/language/variables.h"

#include <cmath>

#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"
#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

Variable Variable::of(Type type, const std::array<std::size_t, 3>& size) {
  Variable variable;
  variable.type = type;
  variable.size = size;
  if (variable.is_text()) {
    variable.texts.resize(variable.count());
  } else {
    variable.numbers.resize(variable.count());
  }
  return variable;
}

void Variable::set(std::size_t index, double value) {
  switch (type) {
    case Type::integer:
      value = std::floor(value + 0.5);
      break;
    case Type::boolean:
      value = value != 0 ? 1 : 0;
      break;
    case Type::real:
    case Type::text:
    case Type::axis:
      break;
  }
  numbers.at(index) = value;
}

std::optional<double> Variables::r(int number) const {
  const auto found = r_.find(number);
  return found == r_.end() ? std::nullopt : std::optional(found->second);
}

Variable* Variables::find(std::string_view name) {
  if (levels_.back().empty() && levels_.front().empty()) {
    return nullptr;
  }
  const std::string upper = upper_case(name);
  for (auto* const level : {&levels_.back(), &levels_.front()}) {
    if (const auto found = level->find(upper); found != level->end()) {
      return &found->second;
    }
  }
  return nullptr;
}

Variable& Variables::define(std::string_view name, Variable variable) {
  const char first = letters::to_upper(name.front());
  if (name.size() == 1 && letters::is_letter(first)) {
    letters_ |= 1U << (first - 'A');
  }
  return levels_.back().insert_or_assign(upper_case(name), std::move(variable)).first->second;
}

void throw_no_element(const Message& name, std::uint32_t column, double index, std::size_t size) {
  throw ReadFault{
      "array-index", column,
      message(NC_("core", "{} has no element {}, its largest index is {}"), name, index, size - 1),
      NC_("core", "correct the index or the size in DEF")};
}

}  // namespace feedscope::sinumerik
