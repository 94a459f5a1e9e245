#include "core/analysis/notes/refused_lines.h"

#include <algorithm>

namespace feedscope {

std::vector<Diagnostic> refused_lines(const LoadedProgram& program, const Setup& setup) {
  return setup.model->read(program.toolpath, setup.settings).refused;
}

bool is_refused(const Run& run) {
  const bool cuts = !run.input.feed_controls.empty();  // as read, including refused ones
  const auto is_feed_motion = [](const Segment& segment) {
    return segment.kind != SegmentKind::dwell && !segment.rapid;
  };
  return cuts && !run.lines_not_run.empty() && std::ranges::none_of(run.path->segments, is_feed_motion);
}

bool is_out_of_reach(const Run& run) {
  return has_errors(run.path.faults);
}

Message line_list(const std::vector<Diagnostic>& lines) {
  constexpr std::size_t most = 8;  // ranges listed
  std::vector<Message> ranges;
  std::size_t i = 0;
  while (i < lines.size() && ranges.size() < most) {
    std::size_t last = i;
    while (last + 1 < lines.size() && lines[last + 1].line == lines[last].line + 1) {
      ++last;
    }
    ranges.push_back(last > i + 1 ? message(NC_("core", "{} to {}"), lines[i].line, lines[last].line)
                     : last > i   ? message(NC_("core", "{}, {}"), lines[i].line, lines[last].line)
                                  : Message::number(std::to_string(lines[i].line)));
    i = last + 1;
  }
  const Message list = enumerated(ranges);
  return i < lines.size() ? message(NC_("core", "{} and {} more"), list, lines.size() - i) : list;
}

Message refused_note(const std::vector<Diagnostic>& lines) {
  if (lines.empty()) {
    return {};
  }
  return lines.size() == 1
             ? message(NC_("core", "1 line of the program is refused by the control and not run (line {})."),
                       line_list(lines))
             : message(
                   NC_("core", "{} lines of the program are refused by the control and not run (lines {})."),
                   lines.size(), line_list(lines));
}

}  // namespace feedscope
