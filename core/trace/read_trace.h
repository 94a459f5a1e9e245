#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/trace/trace.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// Reads a trace of LinuxCNC's halsampler, a SINUMERIK trace (XML), an export of TwinCAT Scope or any table
/// of samples, with or without gzip. `columns`: data of a table that its header and values do not show.
/// Linear in the size of the file. Problems and assumptions are in Trace::notes. Throws InputError with file,
/// line and advice: unreadable file, missing or unidentified columns, fewer than ten samples; Cancelled.
Trace read_trace(const std::filesystem::path& file, const TraceColumns& columns = {},
                 Progress* progress = nullptr);
/// Reads a text; `name` replaces the file in messages.
Trace parse_trace(std::string_view text, const std::string& name, const TraceColumns& columns = {});

}  // namespace feedscope
