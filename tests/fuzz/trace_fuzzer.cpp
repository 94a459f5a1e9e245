// Any bytes as a trace: the first line may say what the columns are. What is read has rising times, lists of
// one length, finite places, and notes at lines of the text.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/trace/read_trace.h"
#include "tests/fuzz/must.h"

using namespace feedscope;

namespace {

void check(const Trace& trace, std::size_t lines) {
  for (std::size_t i = 1; i < trace.size(); ++i) {
    fuzz::must(trace.time[i] > trace.time[i - 1], "times rise");
  }
  for (const auto& place : trace.place) {
    fuzz::must(place.empty() || place.size() == trace.size(), "a place a sample");
    fuzz::must(std::ranges::all_of(place, [](double v) { return std::isfinite(v); }), "finite places");
  }
  fuzz::must(trace.feed.empty() || trace.feed.size() == trace.size(), "a feed a sample");
  fuzz::must(trace.line.empty() || trace.line.size() == trace.size(), "a line a sample");
  fuzz::must(trace.has(0) || trace.has(1) || trace.has(2), "an axis");
  for (const Diagnostic& note : trace.notes) {
    fuzz::must(note.line <= lines && !note.code.empty() && !note.message.empty(),
               "note: " + note.message.english());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(data, data + size);
  TraceColumns columns;
  try {
    if (text.starts_with("columns:")) {
      const auto end = std::min(text.find('\n'), text.size());
      const std::string specification = text.substr(8, end - 8);
      text.erase(0, end + (end < text.size() ? 1 : 0));
      columns = parse_trace_columns(specification);
    }
    check(parse_trace(text, "fuzz.csv", columns),
          1 + static_cast<std::size_t>(
                  std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; })));
  } catch (const InputError& error) {
    fuzz::must(error.what()[0] != '\0', "a refusal without words");
  }
  return 0;
}
