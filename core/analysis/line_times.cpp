#include "core/analysis/line_times.h"

#include <algorithm>

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

}  // namespace

LineTimes::LineTimes(const Trajectory& trajectory, Progress* progress) {
  const BlendedPath& path = trajectory.path();
  if (path.empty()) {
    return;
  }
  ends_.resize(last_line(trajectory) + std::size_t{1});
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::uint32_t line = trajectory.line_of(i);
    ends_[line].length += path.length(i);
    ends_[line].runs += line != before ? 1 : 0;
    before = line;
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

}  // namespace feedscope
