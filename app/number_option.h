#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "core/machine/settings.h"

namespace feedscope {

/// Adds an option with one number: read by typed_number(), checked against `bounds` while the command line is
/// parsed, and passed to `set`. The key of `bounds` is set to `name`. Options with numbers use this or
/// parse_setting(), so that all follow one rule for decimal signs.
CLI::Option* add_number_option(CLI::App& command, const std::string& name, SettingSpec bounds,
                               const std::function<void(double)>& set, const std::string& text);

SettingSpec whole_numbers(double least, double most);
SettingSpec numbers(double least, double most);

/// Adds the permitted decimal signs of a command's numbers to its --help.
void state_number_rule(CLI::App& command);

}  // namespace feedscope
