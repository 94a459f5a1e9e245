#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "core/models/linuxcnc/linuxcnc_run.h"
#include "core/toolpath/machine_path.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

/// A random program and what LinuxCNC made of it, as tests/oracle/random_oracle.py records it.
struct RecordedProgram {
  LinuxCncSettings settings;
  std::string kind;
  int periods = 0;  ///< between the first and the last servo period at whose end the control's planner moves
  std::string text;
};

/// "machine": servo period [s], MAX_LINEAR_VELOCITY [mm/s], MAX_FEED_OVERRIDE, velocities of X, Y, Z [mm/s],
/// A, C [deg/s], and accelerations.
LinuxCncSettings settings_of(std::istringstream words) {
  constexpr std::size_t a = 0;
  constexpr std::size_t c = 2;
  LinuxCncSettings settings;
  words >> settings.period >> settings.max_velocity >> settings.max_override;
  const auto read_limits = [&](Vec3& linear, std::array<double, 3>& turn) {
    words >> linear.x() >> linear.y() >> linear.z() >> turn[a] >> turn[c];
    turn[a] = units::from_deg(turn[a]);
    turn[c] = units::from_deg(turn[c]);
  };
  read_limits(settings.velocity, settings.turn_velocity);
  read_limits(settings.acceleration, settings.turn_acceleration);
  EXPECT_TRUE(words);
  return settings;
}

std::vector<RecordedProgram> recorded_programs() {
  std::ifstream file(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "tests/core/models/linuxcnc_random.txt");
  std::vector<RecordedProgram> programs;
  LinuxCncSettings settings;
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with("machine ")) {
      settings = settings_of(std::istringstream(line.substr(8)));
    } else if (line.starts_with("program ")) {
      RecordedProgram& program = programs.emplace_back();
      program.settings = settings;
      program.text = "G21 G17 G90 G94\n";
      std::istringstream words(line.substr(8));
      words >> program.periods >> std::ws;
      std::getline(words, program.kind);
    } else if (!programs.empty()) {
      programs.back().text += line + "\n";
    }
  }
  return programs;
}

Trajectory motion_of(const RecordedProgram& program) {
  ReadOptions options;
  options.dialect = Dialect::linuxcnc;
  options.rotary_axes = "AC";
  const auto source = std::make_shared<const SourceText>(SourceText("random.ngc", program.text));
  Settings places;
  for (const char axis : {'x', 'y', 'z'}) {
    places.set(std::string("part_zero_") + axis + "_mm", 0.0);
  }
  const Machine machine = shipped_machines().load("spinner-mvc850");
  LinuxCncRun run(on_machine(load_program(source, nullptr, options).toolpath, Machine(), places).toolpath,
                  machine, program.settings);
  return run.run(nullptr);
}

/// Counted as on the control.
int periods_of(const Trajectory& motion, double period) {
  constexpr double moving = 1e-3;  // [mm/s]
  std::optional<int> first;
  int last = -1;
  for (int k = 0; k * period < motion.duration(); ++k) {
    if (motion.state(k * period).speed > moving) {
      first = first.value_or(k);
      last = k;
    }
  }
  return first ? last - *first + 1 : 0;
}

double distance_passed(const Trajectory& motion, const Vec3& place) {
  constexpr double step = 1e-5;  // [s]
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k * step < motion.duration(); ++k) {
    nearest = std::min(nearest, (motion.state(k * step).position - place).norm());
  }
  return nearest;
}

/// Behind an arc that rises, blends leave the corner by far more than P: the control passed these corners,
/// programmed with P0.02, at 0.1254 and 0.3756 mm.
TEST(LinuxCncRandom, CornersBehindRisingArcsArePassedAsFarAsOnTheControl) {
  const auto passed = [](const std::string& arcs, const Vec3& corner) {
    RecordedProgram program;
    program.settings =
        settings_of(std::istringstream("0.001 100 1.2 100 100 50 100 100 750 750 400 1000 1000"));
    program.text = "G21 G17 G90 G94\nG64 P0.02 Q0.02\nG1 F6000 X0 Y0 Z0\n" + arcs;
    return distance_passed(motion_of(program), corner);
  };
  constexpr double tenth_of_micrometre = 1e-4;
  EXPECT_NEAR(passed("G2 X20 Y0 Z1 I10 J-2000\nG2 X40 Y0 Z2 I10 J-2000\nG2 X60 Y0 Z3 I10 J-2000\nG1 X80\n",
                     {60, 0, 3}),
              0.1254, tenth_of_micrometre);
  EXPECT_NEAR(passed("G2 X20 Y0 Z3 I10 J-2000\nG1 X40\n", {20, 0, 3}), 0.3756, tenth_of_micrometre);
}

TEST(LinuxCncRandom, ProgramsLastAsLongAsOnTheControl) {
  constexpr double millisecond = 1.001e-3;
  constexpr double relative = 1e-4;
  const std::vector<RecordedProgram> programs = recorded_programs();
  ASSERT_GT(programs.size(), 100U);
  for (const RecordedProgram& program : programs) {
    const double period = program.settings.period;
    const double control = program.periods * period;
    const double model = periods_of(motion_of(program), period) * period;
    EXPECT_NEAR(model, control, std::max(millisecond, relative * control))
        << program.kind << ", servo period " << period << " s\n"
        << program.text;
  }
}

}  // namespace
}  // namespace feedscope
