#include "core/analysis/time/ruled_instant.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/trajectory/part_walk.h"

namespace feedscope {

double ruled_instant(const Trajectory& trajectory, const SlowPlace& place) {
  constexpr int looks = 4;  // per part
  double instant = place.slowest;
  auto best =
      std::tuple(true, std::numeric_limits<double>::infinity());  // on the way to its place, share of feed
  const std::size_t first = trajectory.piece_at(place.from);
  const double into = std::max(0.0, place.from - trajectory.pieces()[first].time);
  for (PartWalk walk(trajectory, first, into); !walk.done() && walk.part().time < place.to; walk.next()) {
    const Part part = walk.part();
    const bool ahead = part.cause.kind == CauseKind::ramp_down;
    if (limiting_cause(trajectory, part) != place.cause) {
      continue;
    }
    const double from = std::max(0.0, place.from - part.time);
    const double to = std::min(part.duration, place.to - part.time);
    PartMotion motion = walk.motion();
    for (int i = 0; i < looks; ++i) {
      const State state = motion.state_without_length(from + (to - from) * (i + 0.5) / looks);
      const auto here = std::tuple(ahead, state.speed / state.programmed_feed);
      if (here < best) {
        best = here;
        instant = state.time;
      }
    }
  }
  return instant;
}

}  // namespace feedscope
