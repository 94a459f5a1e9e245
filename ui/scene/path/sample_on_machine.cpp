#include <algorithm>
#include <cmath>
#include <vector>

#include "core/analysis/rotary/rotary_course.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/trajectory/part_walk.h"
#include "ui/scene/path/sampler.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t most_machine_points = 200'000;  // it is seldom shown
constexpr std::size_t points_a_task = 1024;
constexpr double turn_of_span = 3 * units::pi / 180;

double largest_turn(const SegmentTurn& turn) {
  double largest = 0;
  for (std::size_t k = 0; k < turn.to.size(); ++k) {
    largest = std::max(largest, std::abs(turn.to[k] - turn.from[k]));
  }
  return largest;
}

/// Times at which rotary axes have turned far enough to bend the path of the others [s].
std::vector<double> times_of_turns(const Trajectory& trajectory) {
  constexpr double most = 120;  // of a part
  const Toolpath& programmed = *trajectory.path().programmed();
  std::vector<double> times;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    double turned = is_pause(part.cause.kind) ? units::pi : 0;  // the axes may keep the tip fixed in a turn
    if (const SegmentTurn* turn = programmed.segment_turn(trajectory.path().segment(part.element))) {
      turned = std::max(turned, largest_turn(*turn));
    }
    const double spans = std::min(std::ceil(turned / turn_of_span), most);
    for (double k = 1; k < spans; ++k) {
      times.push_back(part.time + part.duration * k / spans);
    }
  }
  return times;
}

}  // namespace

SampledPath sample_on_machine(const RunSources& sources, Progress* progress) {
  const RotaryCourse& course = *sources.rotary;
  const Trajectory& trajectory = course.trajectory();
  if (trajectory.pieces().empty()) {
    return {};
  }
  Progress unwatched;
  Progress& watched = progress != nullptr ? *progress : unwatched;
  SampledPath path =
      sample_motion(trajectory, most_machine_points, times_of_turns(trajectory), watched, 0.5, sources);
  std::vector<Vec3> places(path.size());
  const std::size_t tasks = (path.size() + points_a_task - 1) / points_a_task;
  in_parallel(tasks, [&](std::size_t task) {
    const std::size_t end = std::min(path.size(), (task + 1) * points_a_task);
    for (std::size_t i = task * points_a_task; i < end; ++i) {
      places[i] = course.slides(trajectory.state(path.times[i]));
    }
    watched.report(0.5);  // throws if it is cancelled
  });
  path.bounds = {};
  Bounds cut;
  for (std::size_t i = 0; i < path.size(); ++i) {
    path.bounds.add(places[i]);
    if (path.kinds[i] != SpanKind::rapid && path.kinds[i] != SpanKind::gap) {
      cut.add(places[i]);
    }
  }
  const Bounds& around = cut.empty() ? path.bounds : cut;
  path.origin = (around.min + around.max) / 2;
  std::ranges::transform(places, path.positions.begin(), [&](const Vec3& place) -> Eigen::Vector3f {
    return (place - path.origin).cast<float>();
  });
  path.rotary = sources.rotary;
  path.levels = levels_of(path);
  path.boxes = boxes_of(path.positions);
  return path;
}

}  // namespace feedscope::ui
