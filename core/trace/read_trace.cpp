#include "core/trace/read_trace.h"

#include "core/trace/trace_formats.h"

namespace feedscope {
namespace {

Trace read(TraceText& text, const TraceColumns& columns) {
  const std::string_view head = text.head();
  const bool sinumerik = is_sinumerik_trace(head);
  if (!sinumerik && !is_twincat_scope(head)) {
    return read_table_trace(text, columns);
  }
  Trace trace = sinumerik ? read_sinumerik_trace(text, columns) : read_twincat_scope(text, columns);
  if (columns.period > 0) {
    trace.notes.push_back(
        {.severity = Severity::warning,
         .line = 0,
         .column = 0,
         .code = "trace-rate-unused",
         .message = NC_("core", "traces of this kind have times of their own: the rate is not used"),
         .hint = NC_("core", "leave out rate= and period=")});
  }
  return trace;
}

}  // namespace

Trace read_trace(const std::filesystem::path& file, const TraceColumns& columns, Progress* progress) {
  TraceText text(file, progress);
  return read(text, columns);
}

Trace parse_trace(std::string_view text, const std::string& name, const TraceColumns& columns) {
  TraceText source(text, name);
  return read(source, columns);
}

}  // namespace feedscope
