#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "core/machine/settings.h"

namespace feedscope {

/// Adds an option with one number, read by typed_number() and checked against `bounds` while the command line
/// is parsed, and handed to `set`. The key of `bounds` is set to `name`. Every option with a number goes
/// through here or through parse_setting(), so that one rule for decimal signs holds in all of them.
CLI::Option* add_number_option(CLI::App& command, const std::string& name, SettingSpec bounds,
                               const std::function<void(double)>& set, const std::string& text);

/// `least` to `most`, whole numbers only.
SettingSpec whole_numbers(double least, double most);
/// `least` to `most`.
SettingSpec numbers(double least, double most);

/// Tells in --help which decimal signs the numbers of a command may have.
void state_number_rule(CLI::App& command);

}  // namespace feedscope
