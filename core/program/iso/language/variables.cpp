#include "core/program/iso/language/variables.h"

#include "core/program/iso/language/expression.h"

namespace feedscope::iso {

Variables::Variables(Dialect dialect)
    : local_count_(follows_linuxcnc(dialect) ? 30 : 33),
      argument_left_out_(follows_linuxcnc(dialect) ? 0 : null_value()) {
  levels_.push_back({no_arguments(), {}});
}

Variables::Locals Variables::no_arguments() const {
  Locals locals;
  locals.fill(argument_left_out_);
  return locals;
}

double Variables::get(std::uint32_t number) const {
  if (is_local(number)) {
    return levels_.back().locals[number];
  }
  const auto found = numbered_.find(number);
  return found == numbered_.end() ? null_value() : found->second;
}

void Variables::set(std::uint32_t number, double value) {
  if (is_local(number)) {
    levels_.back().locals[number] = value;
  } else {
    numbered_[number] = value;
  }
}

std::optional<double> Variables::get(const std::string& name) const {
  const std::map<std::string, double>& names = name.starts_with('_') ? named_ : levels_.back().named;
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

void Variables::set(const std::string& name, double value) {
  (name.starts_with('_') ? named_ : levels_.back().named)[name] = value;
}

void Variables::enter(const Locals& arguments) {
  levels_.push_back({arguments, {}});
}

void Variables::leave() {
  levels_.pop_back();
}

}  // namespace feedscope::iso
