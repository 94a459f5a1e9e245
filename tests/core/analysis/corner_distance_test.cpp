#include "core/analysis/contour/corner_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/analysis/run/run.h"
#include "core/trajectory/state_walk.h"
#include "tests/support/paths.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

/// A line that goes on in X all the time, in blocks of 0.01 to 5 mm: no place is passed twice.
std::vector<Vec3> forward_points(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> points{Vec3::Zero()};
  double size = 1;
  for (int i = 0; i < 20; ++i) {
    size = unit(random) < 0.3 ? std::pow(10, 2.7 * unit(random) - 2) : size;
    const double up = unit(random) < 0.5 ? 1 : 0.1;
    points.push_back(points.back() + size * Vec3(0.2 + unit(random), up * (2 * unit(random) - 1),
                                                 0.3 * up * (2 * unit(random) - 1)));
  }
  return points;
}

/// The largest distance of a point from the nearest of close samples.
double sampled_distance(const Trajectory& run, const std::vector<Vec3>& points, double step) {
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  StateWalk walk(run);
  for (double time = 0; time < run.duration(); time += step) {
    const Vec3 position = walk.at_without_length(time).position;
    for (std::size_t i = 0; i < points.size(); ++i) {
      nearest[i] = std::min(nearest[i], (position - points[i]).norm());
    }
  }
  return *std::max_element(nearest.begin(), nearest.end() - 1);
}

class CornerDistances : public ::testing::TestWithParam<std::string> {};

TEST_P(CornerDistances, AreThoseOfCloseSamples) {
  constexpr double step = 1e-5;  // [s]
  const ControlModel& model = find_model(GetParam());
  const MachineLibrary library = shipped_machines();
  std::mt19937 random(54);
  const int programs = test::random_cases(32);
  for (int i = 0; i < programs; ++i) {
    const std::vector<Vec3> points = forward_points(random);
    const Toolpath path = feedscope::testing::polyline(points, 50);
    for (const char* id : {"huron-kx10", "dmg-mori-evo40", "linuxcnc-mill", "grbl-router"}) {
      const Machine machine = library.load(id);
      const Trajectory run = model.simulate(path, machine, complete_settings(model, machine));
      const double spacing = 50 * 1.05 * step;  // of samples [mm]
      const double distance = largest_corner_distance(run);
      const double sampled = sampled_distance(run, points, step);
      EXPECT_LE(distance, sampled + 1e-9) << "program " << i << " on " << id;
      EXPECT_GE(distance, sampled - spacing / 2) << "program " << i << " on " << id;
    }
  }
}

std::vector<std::string> models_of_paths() {
  std::vector<std::string> ids;
  for (const ControlModel* model : all_models()) {
    if (model->info().id != "optimal") {  // it runs the path of another one
      ids.push_back(model->info().id);
    }
  }
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Models, CornerDistances, ::testing::ValuesIn(models_of_paths()),
                         [](const auto& model) { return model.param; });

}  // namespace
}  // namespace feedscope
