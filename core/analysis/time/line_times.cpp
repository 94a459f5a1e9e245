#include "core/analysis/time/line_times.h"

#include <algorithm>
#include <limits>

#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

std::uint32_t last_line(const Trajectory& trajectory) {
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < trajectory.path().size(); ++i) {
    last = std::max(last, trajectory.line_of(i));
  }
  return last;
}

std::vector<std::pair<std::uint32_t, Pause>> lines_not_counted(const Toolpath& toolpath) {
  std::vector<std::pair<std::uint32_t, Pause>> lines;
  if (toolpath.pauses.empty()) {
    return lines;
  }
  for (const Segment& segment : toolpath.segments) {
    if (segment.kind == SegmentKind::dwell && !toolpath.pause_of(segment).timed) {
      lines.emplace_back(segment.line, toolpath.pause_of(segment).kind);
    }
  }
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

}  // namespace

LineTimes::LineTimes(const Trajectory& trajectory, Progress* progress) {
  const BlendedPath& path = trajectory.path();
  if (path.empty()) {
    return;
  }
  ends_.resize(last_line(trajectory) + std::size_t{1});
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  elements_.resize(ends_.size(), none);
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::uint32_t line = trajectory.line_of(i);
    ends_[line].length += path.length(i);
    ends_[line].runs += line != before ? 1 : 0;
    elements_[line] = std::min(elements_[line], static_cast<std::uint32_t>(i));
    before = line;
  }
  for (std::size_t line = elements_.size() - 1; line > 0; --line) {
    elements_[line - 1] = elements_[line - 1] == none ? elements_[line] : elements_[line - 1];
  }
  if (path.programmed() != nullptr) {
    not_counted_ = lines_not_counted(*path.programmed());
  }
  ProgressSteps steps(progress, trajectory.pieces().size());
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    LineTime& line = ends_[trajectory.line_of(part.element)];
    line.time += part.duration;
    line.dwell += path.kind(part.element) == ElementKind::dwell ? part.duration : 0;
    steps.at(part.piece);
  }
  for (std::size_t line = 1; line < ends_.size(); ++line) {
    largest_ = std::max(largest_, ends_[line].time);
    ends_[line].time += ends_[line - 1].time;
    ends_[line].length += ends_[line - 1].length;
    ends_[line].dwell += ends_[line - 1].dwell;
    ends_[line].runs += ends_[line - 1].runs;
  }
}

LineTime LineTimes::of(std::uint32_t first, std::uint32_t last) const {
  const std::uint32_t to = std::min(last, line_count());
  if (first == 0 || first > to) {
    return {};
  }
  const LineTime& a = ends_[first - 1];
  const LineTime& b = ends_[to];
  return {b.time - a.time, b.length - a.length, b.dwell - a.dwell, b.runs - a.runs};
}

std::vector<Pause> LineTimes::not_counted(std::uint32_t line) const {
  std::vector<Pause> kinds;
  auto at = std::ranges::lower_bound(not_counted_, line, {}, &std::pair<std::uint32_t, Pause>::first);
  for (; at != not_counted_.end() && at->first == line; ++at) {
    kinds.push_back(at->second);
  }
  return kinds;
}

std::optional<std::uint32_t> LineTimes::first_element(std::uint32_t line) const {
  return line < elements_.size() ? std::optional(elements_[line]) : std::nullopt;
}

}  // namespace feedscope
