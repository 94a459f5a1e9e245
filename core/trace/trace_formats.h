#pragma once

#include "core/trace/trace.h"
#include "core/trace/trace_columns.h"
#include "core/trace/trace_text.h"

namespace feedscope {

/// Whether the head of a text is that of the format.
bool is_sinumerik_trace(std::string_view head);
bool is_twincat_scope(std::string_view head);

/// XML of SINUMERIK Operate: `signal` elements name the signals, `dataSignal` elements say which field of a
/// `rec` is which; a field that a `rec` lacks was not sampled then. Throws InputError naming file and line.
Trace read_sinumerik_trace(TraceText& text, const TraceColumns& columns);
/// Text of TwinCAT Scope View: a head of rows by channel ("Name", "SampleTime[ms]"), then rows of times and
/// values; several channels may share the times in front of them. Throws as the above.
Trace read_twincat_scope(TraceText& text, const TraceColumns& columns);
/// A table with or without a head. Throws as the above.
Trace read_table_trace(TraceText& text, const TraceColumns& columns);

}  // namespace feedscope
