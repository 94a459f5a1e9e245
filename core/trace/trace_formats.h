#pragma once

#include "core/trace/trace.h"
#include "core/trace/trace_columns.h"
#include "core/trace/trace_text.h"

namespace feedscope {

/// Whether a text begins like this format.
bool is_sinumerik_trace(std::string_view head);
bool is_twincat_scope(std::string_view head);

/// Reads XML of SINUMERIK Operate: `signal` elements name the signals, `dataSignal` elements assign them to
/// fields of `rec`; a field missing in a `rec` was not sampled then. Throws InputError with file and line.
Trace read_sinumerik_trace(TraceText& text, const TraceColumns& columns);
/// Reads text of TwinCAT Scope View: header rows by channel ("Name", "SampleTime[ms]"), then rows of times
/// and values; several channels may share the times before them. Throws likewise.
Trace read_twincat_scope(TraceText& text, const TraceColumns& columns);
/// Reads a table with or without a header. Throws likewise.
Trace read_table_trace(TraceText& text, const TraceColumns& columns);

}  // namespace feedscope
