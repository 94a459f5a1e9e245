#include "core/analysis/notes/refused_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace feedscope {

std::vector<Diagnostic> refused_lines(const LoadedProgram& program, const Setup& setup) {
  return program.toolpath->may_be_read() ? setup.model->read(program.toolpath, setup.settings).refused
                                         : program.lines_not_run;
}

std::vector<Diagnostic> refused_as_written(const LoadedProgram& program, const Setup& setup) {
  auto written = std::make_shared<Toolpath>();
  written->source = program.toolpath->source;
  return setup.model->read(std::move(written), setup.settings).refused;
}

bool is_refused(const Run& run) {
  const bool cuts = !run.input.feed_controls.empty();  // as read, including refused ones
  const auto is_feed_motion = [](const Segment& segment) {
    return segment.kind != SegmentKind::dwell && !segment.rapid;
  };
  return cuts && !run.input.lines_not_run.empty() &&
         std::ranges::none_of(run.input.toolpath->segments, is_feed_motion);
}

bool is_out_of_reach(const Run& run) {
  return has_errors(run.input.toolpath->machine_faults);
}

std::string line_list(const std::vector<Diagnostic>& lines) {
  constexpr std::size_t most = 8;  // ranges listed
  std::string list;
  std::size_t named = 0;
  std::size_t i = 0;
  for (; i < lines.size() && named < most; ++named) {
    std::size_t last = i;
    while (last + 1 < lines.size() && lines[last + 1].line == lines[last].line + 1) {
      ++last;
    }
    list += fmt::format("{}{}", named == 0 ? "" : ", ", lines[i].line);
    if (last > i) {
      list += fmt::format("{}{}", last == i + 1 ? ", " : " to ", lines[last].line);
    }
    i = last + 1;
  }
  if (i < lines.size()) {
    list += fmt::format(" and {} more", lines.size() - i);
  }
  return list;
}

std::string refused_note(const std::vector<Diagnostic>& lines) {
  if (lines.empty()) {
    return {};
  }
  return fmt::format("{} of the program {} by the control and not run ({} {}).",
                     lines.size() == 1 ? "1 line" : fmt::format("{} lines", lines.size()),
                     lines.size() == 1 ? "is refused" : "are refused", lines.size() == 1 ? "line" : "lines",
                     line_list(lines));
}

}  // namespace feedscope
