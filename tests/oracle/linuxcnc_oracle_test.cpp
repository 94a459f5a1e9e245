#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/machine/import/machine_import.h"
#include "tests/oracle/run_linuxcnc.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

constexpr double period = 1e-3;  // [s]

/// At the end of a servo period.
struct Sample {
  Vec3 place = Vec3::Zero();  ///< [mm]
  double speed = 0;           ///< [mm/s]
  bool overlaps = false;      ///< two blocks move at once, and the control shows the speed of one of them
};

using Samples = std::vector<Sample>;

fs::path folder() {
  return fs::path(FEEDSCOPE_SOURCE_DIR) / "tests" / "oracle";
}

fs::path program_file(const std::string& name) {
  return folder() / "programs" / (name + ".ngc");
}

/// What a trace holds of each program.
std::vector<Samples> read_trace(const fs::path& file, std::size_t programs) {
  std::vector<Samples> traces(programs);
  std::ifstream lines(file);
  std::string line;
  while (std::getline(lines, line)) {
    Sample sample;
    unsigned program = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), "%lf %lf %lf %lf %u", &sample.place.x(), &sample.place.y(),
                          &sample.place.z(), &sample.speed, &program),
              5)
        << "periods were lost: " << line;
    if (program > 0 && program <= programs) {
      traces[program - 1].push_back(sample);
    }
  }
  return traces;
}

/// The model on the machine of the control's own configuration.
Run simulate(const std::string& name) {
  Setup setup;
  setup.machine = import_machine(folder() / "linuxcnc.ini", machine_file_settings()).machine;
  setup.model = &find_model("linuxcnc");
  setup.settings = complete_settings(*setup.model, setup.machine);
  return simulate_run(load_program(program_file(name)), setup);
}

Samples samples_of(const Trajectory& motion) {
  constexpr int standing_at_the_end = 100;
  Samples samples;
  const auto periods = static_cast<int>(motion.duration() / period) + standing_at_the_end;
  for (int k = 0; k < periods; ++k) {
    const State state = motion.state(std::min(k * period, motion.duration()));
    const bool moves = k * period < motion.duration();
    samples.push_back(
        {state.position, moves ? state.speed : 0, state.cause.kind == CauseKind::contour_tolerance});
  }
  return samples;
}

/// From the first sample that moves to the last, without longer pauses.
struct Stretch {
  std::size_t first;
  std::size_t last;
  double duration() const { return static_cast<double>(last - first + 1) * period; }
};

std::vector<Stretch> stretches_of(const Samples& samples) {
  constexpr double moving = 1e-3;
  constexpr std::size_t longest_stop = 50;
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (samples[k].speed <= moving) {
      continue;
    }
    if (stretches.empty() || k - stretches.back().last > longest_stop) {
      stretches.push_back({k, k});
    }
    stretches.back().last = k;
  }
  return stretches;
}

struct Difference {
  double speed = 0;  ///< [mm/s]
  double place = 0;  ///< [mm]
};

/// The interpolator behind the planner delays places by two periods.
Difference difference(const Samples& model, const Stretch& ours, const Samples& control,
                      const Stretch& theirs) {
  constexpr std::size_t delay = 2;
  Difference most;
  const std::size_t count = std::min(ours.last - ours.first, theirs.last - theirs.first);
  for (std::size_t k = 0; k < count; ++k) {
    const Sample& a = model[ours.first + k];
    if (!a.overlaps) {
      most.speed = std::max(most.speed, std::abs(a.speed - control[theirs.first + k].speed));
    }
    const Vec3 off = a.place - control[theirs.first + k + delay].place;
    most.place = std::max(most.place, off.cwiseAbs().maxCoeff());
  }
  return most;
}

struct Case {
  const char* program;
  std::size_t stretches;
};

TEST(LinuxCncOracle, TheInstalledControlMovesAsTheModelSays) {
  constexpr double duration = 3e-3;
  constexpr double speed = 0.5;
  constexpr double place = 3e-4;  // what the interpolator rounds: a T^2/6, 0.2 um
  constexpr auto cases = std::to_array<Case>({{"corners", 1}, {"arcs", 1}, {"short_blocks", 2}});
  const fs::path trace = fs::path(FEEDSCOPE_BINARY_DIR) / "oracle.trace";
  const std::array programs{program_file(cases[0].program), program_file(cases[1].program),
                            program_file(cases[2].program)};
  const int code = test::run_linuxcnc("linuxcnc", trace, programs);
  if (code == test::no_linuxcnc) {
    GTEST_SKIP() << "there is no LinuxCNC to run: see packaging/oracle";
  }
  ASSERT_EQ(code, 0);
  const std::vector<Samples> traces = read_trace(trace, cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].program);
    const Samples model = samples_of(*simulate(cases[i].program).trajectory);
    const std::vector<Stretch> ours = stretches_of(model);
    const std::vector<Stretch> theirs = stretches_of(traces[i]);
    ASSERT_EQ(theirs.size(), cases[i].stretches);
    ASSERT_EQ(ours.size(), cases[i].stretches);
    for (std::size_t j = 0; j < ours.size(); ++j) {
      const Difference most = difference(model, ours[j], traces[i], theirs[j]);
      EXPECT_NEAR(ours[j].duration(), theirs[j].duration(), duration);
      EXPECT_LT(most.speed, speed);
      EXPECT_LT(most.place, place);
      fmt::print("{} {}: {:.3f} s, {:+.1f} ms, {:.4f} mm/s, {:.2f} um\n", cases[i].program, j + 1,
                 theirs[j].duration(), 1e3 * (ours[j].duration() - theirs[j].duration()), most.speed,
                 1e3 * most.place);
    }
  }
}

}  // namespace
}  // namespace feedscope
