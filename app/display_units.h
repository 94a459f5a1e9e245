#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace feedscope {

/// Adds --display-units: the unit system of numbers in pictures and reports of this process.
void add_display_units_option(CLI::App& command);
/// Value of --display-units, "" for the usual units.
std::string asked_display_units();

}  // namespace feedscope
