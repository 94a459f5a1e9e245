#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/trace/trace_columns.h"

namespace feedscope {

void add_columns_option(CLI::App& command, std::string& columns);
/// The columns that --columns describes: a specification, a preset, or a file with a specification. Throws
/// InputError.
TraceColumns asked_columns(const std::string& columns);

}  // namespace feedscope
