#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace feedscope {

/// Adds --display-units: the unit system in which pictures and reports of this process show numbers.
void add_display_units_option(CLI::App& command);
/// What that option asked for, "" for the usual units.
std::string asked_display_units();

}  // namespace feedscope
