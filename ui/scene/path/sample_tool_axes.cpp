#include "ui/scene/path/sample_tool_axes.h"

#include <cmath>

#include "core/trajectory/state_walk.h"

namespace feedscope::ui {

std::vector<ToolAxis> sample_tool_axes(const RotaryCourse& course, const Vec3& origin) {
  const Trajectory& trajectory = course.trajectory();
  const double step =
      trajectory.path_length() / (most_tool_axes / 2.0);  // each part has one more than it needs
  std::vector<ToolAxis> axes;
  double next = 0;  // path length of the next axis [mm]
  for (PartWalk walk(trajectory); !walk.done() && axes.size() < most_tool_axes; walk.next()) {
    const Part& part = walk.part();
    if (is_pause(part.cause.kind) || trajectory.is_rapid(part.element) || !(part.duration > 0)) {
      continue;
    }
    const PartMotion motion = walk.motion();
    const double begin = motion.state(0).path_length;
    const double end = motion.state(part.duration).path_length;
    if (end < next) {
      continue;
    }
    const int spans = std::max(1, static_cast<int>(std::ceil((end - begin) / step)));
    for (int i = 0; i < spans && axes.size() < most_tool_axes; ++i) {
      const State state = motion.state(part.duration * i / spans);
      axes.push_back({(state.position - origin).cast<float>(), course.tool_direction(state).cast<float>()});
    }
    next = end + step / 2;
  }
  return axes;
}

}  // namespace feedscope::ui
