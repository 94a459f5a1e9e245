#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/models/linuxcnc/linuxcnc_run.h"
#include "tests/core/models/control_tables.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

struct Sample {
  Vec3 place = Vec3::Zero();  ///< [mm]
  double speed = 0;           ///< [mm/s]
};

/// A trace of the complete control, one sample a millisecond, from the first that moves to the last.
std::vector<Sample> trace_of(const fs::path& file) {
  std::vector<Sample> samples;
  FILE* lines = popen(("gzip -dc '" + file.string() + "'").c_str(), "r");
  if (lines == nullptr) {
    return samples;
  }
  Sample sample;
  char line[256];
  while (std::fgets(line, sizeof line, lines) != nullptr) {
    double number = 0;
    double block = 0;
    if (std::sscanf(line, "%lf %lf %lf %lf %lf %lf", &number, &sample.place.x(), &sample.place.y(),
                    &sample.place.z(), &block, &sample.speed) == 6) {
      samples.push_back(sample);
    }
  }
  pclose(lines);
  const auto moves = [](const Sample& one) { return one.speed > 1e-3; };
  samples.erase(samples.begin(), std::ranges::find_if(samples, moves));
  while (!samples.empty() && !moves(samples.back())) {
    samples.pop_back();
  }
  return samples;
}

/// The machine of ../shared/linuxcnc/t.ini.
LinuxCncSettings settings() {
  LinuxCncSettings settings;
  settings.velocity = Vec3(166.666667, 166.666667, 83.333333);
  settings.acceleration = Vec3(1000, 1000, 400);
  settings.max_velocity = 500;
  return settings;
}

class LinuxCncTraces : public ::testing::TestWithParam<const char*> {};

/// The interpolator behind the planner delays the place by two periods.
TEST_P(LinuxCncTraces, TimeSpeedAndPlaceAreThoseOfTheCompleteControl) {
  constexpr double duration = 3e-3;
  constexpr double speed = 0.5;
  constexpr double place = 3e-4;  // what the interpolator rounds: a T^2/6, 0.17 um
  constexpr double period = 1e-3;
  constexpr std::size_t delay = 2;
  const fs::path folder = testing::ControlTables::folder() / ".." / "linuxcnc" / "traces";
  const fs::path program = folder / (std::string(GetParam()) + ".ngc");
  const fs::path file = folder / (std::string(GetParam()) + ".txt.gz");
  if (!fs::exists(program) || !fs::exists(file)) {
    GTEST_SKIP() << "no traces of LinuxCNC at " << folder;
  }
  const std::vector<Sample> trace = trace_of(file);
  ASSERT_GT(trace.size(), 100U);
  LinuxCncRun run(load_program(program).toolpath, shipped_machines().load("spinner-mvc850"), settings());
  const Trajectory motion = run.run(nullptr);
  EXPECT_NEAR(motion.duration(), static_cast<double>(trace.size()) * period, duration);
  double most_of_speed = 0;
  double most_of_place = 0;
  for (std::size_t k = 0; k + delay < trace.size(); ++k) {
    const double time = static_cast<double>(k + 1) * period;
    if (time >= motion.duration()) {
      break;
    }
    const State state = motion.state(time);
    const Vec3 off = (state.position - trace[k + delay].place).cwiseAbs();
    most_of_place = std::max(most_of_place, off.maxCoeff());
    if (state.cause.kind != CauseKind::contour_tolerance) {  // in overlaps the control shows one of the two
      most_of_speed = std::max(most_of_speed, std::abs(state.speed - trace[k].speed));
    }
  }
  EXPECT_LT(most_of_speed, speed);
  EXPECT_LT(most_of_place, place);
  std::printf("%s: %.1f ms, %.4f mm/s, %.2f um\n", GetParam(),
              1e3 * (motion.duration() - static_cast<double>(trace.size()) * period), most_of_speed,
              1e3 * most_of_place);
}

INSTANTIATE_TEST_SUITE_P(Programs, LinuxCncTraces,
                         ::testing::Values("essid_spline", "essid_table1", "lesson_approach",
                                           "lesson_corners", "lesson_short_wave", "lesson_zigzag_6000",
                                           "msaddek_pocket", "tapie_bore", "tapie_half_spiral",
                                           "tapie_quarter_spiral_30"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace feedscope
