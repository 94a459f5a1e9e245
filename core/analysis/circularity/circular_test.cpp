#include "core/analysis/circularity/circular_test.h"

#include "core/analysis/circularity/test_program.h"
#include "core/analysis/run/run_stages.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {
namespace {

/// Time during which the block of `line` is under way.
Bracket time_of(const Trajectory& trajectory, std::uint32_t line) {
  return {trajectory.time_of_line(line), trajectory.time_of_line(line + 1)};
}

}  // namespace

void CircularTest::join() {
  if (passes.size() < 2) {
    return;
  }
  std::vector<Eigen::Vector2d> all;
  for (const CirclePass& pass : passes) {
    all.insert(all.end(), pass.places.begin(), pass.places.end());
  }
  both = circularity_of(all, request.radius);
}

CircularTest run_circular_test(const CircularRequest& request, const Setup& setup, Progress* progress) {
  CircularTest test;
  test.request = request;
  const SimulatedCircles program = simulated_circles(request);
  ReadOptions options;
  options.dialect = Dialect::iso;
  const LoadedProgram loaded = load_program(
      std::make_shared<const SourceText>(SourceText("circular test", program.text)), nullptr, options);
  Setup bare = setup;
  bare.load = {};  // belongs to another program
  const Run run = simulate_motion(loaded, std::move(bare), progress);
  test.actual = run.sources.actual != nullptr;
  for (const std::uint32_t line : program.lines) {
    CirclePass pass =
        pass_between(run, time_of(*run.trajectory, line), {request.plane, test.center, request.radius});
    pass.counter_clockwise = test.passes.empty();
    pass.start = request.start;
    test.passes.push_back(std::move(pass));
  }
  test.join();
  return test;
}

}  // namespace feedscope
