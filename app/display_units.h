#pragma once

#include <CLI/CLI.hpp>

namespace feedscope {

/// Adds --display-units: the unit system in which pictures and reports of this process show numbers.
void add_display_units_option(CLI::App& command);

}  // namespace feedscope
