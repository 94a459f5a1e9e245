#include "core/identification/part_times.h"

namespace feedscope {

std::vector<LineTime> part_times(const IdentificationProgram& program, const Trajectory& run) {
  const LineTimes lines(run);
  std::vector<LineTime> times;
  for (std::size_t i = 0; i < program.parts.size(); ++i) {
    const std::uint32_t end =
        i + 1 < program.parts.size() ? program.parts[i + 1].line - 1 : lines.line_count();
    times.push_back(lines.of(program.parts[i].line, end));
  }
  return times;
}

}  // namespace feedscope
