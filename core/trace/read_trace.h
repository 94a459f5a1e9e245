#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/trace/trace.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// Reads a trace of LinuxCNC's halsampler, a SINUMERIK trace (XML), an export of TwinCAT Scope or any table
/// of samples; packed by gzip or not. `columns`: what of a table is not to be found from its head and its
/// values. Linear in the size of the file. What is wrong or was assumed is in Trace::notes.
/// Throws InputError naming file, line and what to do: unreadable file, columns that are missing or that
/// nothing says what they are, fewer than ten samples; Cancelled.
Trace read_trace(const std::filesystem::path& file, const TraceColumns& columns = {},
                 Progress* progress = nullptr);
/// The same of a text; `name` stands for the file in messages.
Trace parse_trace(std::string_view text, const std::string& name, const TraceColumns& columns = {});

}  // namespace feedscope
