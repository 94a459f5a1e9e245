#include "core/trace/read_trace.h"

#include "core/trace/trace_formats.h"

namespace feedscope {
namespace {

Trace read(TraceText& text, const TraceColumns& columns) {
  const std::string_view head = text.head();
  if (is_sinumerik_trace(head)) {
    return read_sinumerik_trace(text, columns);
  }
  if (is_twincat_scope(head)) {
    return read_twincat_scope(text, columns);
  }
  return read_table_trace(text, columns);
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
