#include "app/number_option.h"

namespace feedscope {

CLI::Option* add_number_option(CLI::App& command, const std::string& name, SettingSpec bounds,
                               const std::function<void(double)>& set, const std::string& text) {
  bounds.key = name;
  return command.add_option_function<std::string>(
      name, [bounds, set](const std::string& typed) { set(std::get<double>(parse_setting(bounds, typed))); },
      text);
}

SettingSpec whole_numbers(double least, double most) {
  SettingSpec spec = numbers(least, most);
  spec.whole = true;
  return spec;
}

SettingSpec numbers(double least, double most) {
  SettingSpec spec;
  spec.minimum = least;
  spec.maximum = most;
  return spec;
}

void state_number_rule(CLI::App& command) {
  command.footer(
      "Numbers have a decimal point or comma: 0.05 or 0,05. A comma that could also group thousands (1,000) "
      "is "
      "refused, and so is every comma in --sweep, whose values are separated by blanks or semicolons.");
}

}  // namespace feedscope
