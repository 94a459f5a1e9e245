#include "core/analysis/circularity/circular_test.h"

#include <algorithm>

#include "core/analysis/circularity/circle_plane.h"
#include "core/analysis/circularity/test_program.h"
#include "core/analysis/run_stages.h"
#include "core/base/roots.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {
namespace {

using Eigen::Vector2d;

/// The time in which the block of `line` is under way.
Bracket time_of(const Trajectory& trajectory, std::uint32_t line) {
  return {trajectory.time_of_line(line), trajectory.time_of_line(line + 1)};
}

}  // namespace

CircularTest run_circular_test(const CircularRequest& request, const Setup& setup, Progress* progress) {
  CircularTest test;
  test.request = request;
  const SimulatedCircles program = simulated_circles(request);
  ReadOptions options;
  options.dialect = Dialect::iso;
  const LoadedProgram loaded = load_program(
      std::make_shared<const SourceText>(SourceText("circular test", program.text)), nullptr, options);
  const Run run = simulate_motion(loaded, setup, progress);
  const Trajectory& trajectory = *run.trajectory;
  const PlaneInfo& plane = info_of(request.plane);
  test.actual = run.actual != nullptr;
  std::vector<Vector2d> all;
  for (std::size_t i = 0; i < test.passes.size(); ++i) {
    CirclePass& pass = test.passes[i];
    pass.counter_clockwise = i == 0;
    const Bracket time = time_of(trajectory, program.lines[i]);
    pass.time = time.high - time.low;
    for (std::size_t k = 0; k < circle_places; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(circle_places - 1);
      const State state = trajectory.state(time.low + share * (time.high - time.low));
      const Vec3 at = run.actual ? run.actual->response().at(state.time).position : state.position;
      pass.reached_feed = std::max(pass.reached_feed, state.speed);
      pass.places.push_back({at[plane.first_index], at[plane.second_index]});
    }
    pass.circularity = circularity_of(pass.places, request.radius);
    all.insert(all.end(), pass.places.begin(), pass.places.end());
  }
  test.both = circularity_of(all, request.radius);
  return test;
}

}  // namespace feedscope
