#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "core/machine/import/machine_import.h"
#include "tests/oracle/run_linuxcnc.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t axis_count = 5;  // X, Y, Z, A, C
constexpr double tool_length = 60;     // of table.ini [mm]

/// What a servo period of a trace holds, [mm] and [deg].
struct Period {
  std::array<double, axis_count> joints;
  std::array<double, axis_count> tool;
};

/// Straight lines of the tip to random places, every other one with a stop behind it.
std::string random_program(unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::string text = "G21 G90 G94 G17\nG64\n";
  for (int i = 0; i < 24; ++i) {
    text +=
        fmt::format("G{} X{:.4f} Y{:.4f} Z{:.4f} A{:.4f} C{:.4f} F6000\n{}", i % 3 == 0 ? 0 : 1, any(-60, 60),
                    any(-60, 60), any(-60, 60), any(-90, 50), any(-180, 180), i % 2 == 0 ? "G4 P0.05\n" : "");
  }
  return text + "G0 X0 Y0 Z0 A0 C0\nM2\n";  // where the next one begins
}

/// What a trace holds of each program.
std::vector<std::vector<Period>> periods_of(const fs::path& file, std::size_t programs) {
  std::vector<std::vector<Period>> periods(programs);
  std::ifstream lines(file);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    Period period{};
    for (double& value : period.joints) {
      numbers >> value;
    }
    for (double& value : period.tool) {
      numbers >> value;
    }
    std::size_t program = 0;
    numbers >> program;
    EXPECT_TRUE(numbers) << "periods were lost: " << line;
    if (program > 0 && program <= programs) {
      periods[program - 1].push_back(period);
    }
  }
  return periods;
}

/// As the control's own configuration is imported.
KinematicChain table_of_linuxcnc() {
  const fs::path file = fs::path(FEEDSCOPE_SOURCE_DIR) / "tests" / "oracle" / "table.ini";
  return chain_of(import_machine(file, machine_file_settings()).machine.kinematics);
}

constexpr std::string_view axis_names = "XYZAC";

Vec3 tip_of(const std::array<double, axis_count>& tool) {
  return {tool[0], tool[1], tool[2] - tool_length};
}

/// With the joints of the control.
Vec3 tip_of(const KinematicChain& chain, const std::array<double, axis_count>& joints) {
  std::vector<double> places;
  for (const ChainAxis& axis : chain.axes()) {
    const double joint = joints[axis_names.find(axis.name)];
    places.push_back(axis.rotary ? units::from_deg(joint) : joint);
  }
  return chain.pose(places, tool_length).tip;
}

/// Of the machine, in the order X, Y, Z, A, C [mm], [deg], with the tool as a period says.
std::array<double, axis_count> joints_for(const KinematicChain& chain,
                                          const std::array<double, axis_count>& tool) {
  const Vec3 tip = tip_of(tool);
  std::vector<double> angles;
  for (const std::size_t k : chain.rotary()) {
    angles.push_back(units::from_deg(tool[axis_names.find(chain.axes()[k].name)]));
  }
  const std::vector<double> places = chain.places(tip, angles, tool_length);
  EXPECT_LT((chain.pose(places, tool_length).tip - tip).norm(), 1e-9);
  std::array<double, axis_count> joints{};
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const double place = places[k];
    joints[axis_names.find(chain.axes()[k].name)] = chain.axes()[k].rotary ? units::to_deg(place) : place;
  }
  return joints;
}

/// How long each motion lasts, between pauses [s]; `places`: one each period.
std::vector<double> motions_of(const std::vector<std::array<double, axis_count>>& places) {
  constexpr double moving = 1e-7;
  constexpr std::size_t shortest_pause = 30;
  std::vector<double> durations;
  std::size_t last = 0;
  std::size_t count = 0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    double step = 0;
    for (std::size_t i = 0; i < axis_count; ++i) {
      step = std::max(step, std::abs(places[k][i] - places[k - 1][i]));
    }
    if (step <= moving) {
      continue;
    }
    if (count == 0 || k - last > shortest_pause) {
      durations.push_back(0);
      count = 0;
    }
    count = count == 0 ? 1 : count + k - last;
    durations.back() = static_cast<double>(count) * 1e-3;
    last = k;
  }
  return durations;
}

/// Of the model on the imported machine.
std::vector<std::array<double, axis_count>> simulated(const fs::path& program) {
  Setup setup;
  setup.machine = import_machine(fs::path(FEEDSCOPE_SOURCE_DIR) / "tests" / "oracle" / "table.ini",
                                 machine_file_settings())
                      .machine;
  setup.model = &find_model("linuxcnc");
  setup.settings = complete_settings(*setup.model, setup.machine);
  for (const char* key : {"part_zero_x_mm", "part_zero_y_mm", "part_zero_z_mm"}) {
    setup.settings.set(key,
                       0.0);  // so that it is known how X, Y and Z follow, which the control does not look at
  }
  setup.settings.set("tool_length_mm", tool_length);
  const Run run = simulate_run(load_program(program, nullptr, reading_on({}, setup.machine)), setup);
  std::vector<std::array<double, axis_count>> places;
  for (double time = 0; time < run.trajectory->duration() + 0.1; time += 1e-3) {
    const State state = run.trajectory->state(std::min(time, run.trajectory->duration()));
    const std::array<double, 3> angles = run.sources.rotary->at(state).angles();
    places.push_back({state.position.x(), state.position.y(), state.position.z(), units::to_deg(angles[0]),
                      units::to_deg(angles[2])});
  }
  return places;
}

/// Behind its kinematics the control lays a cubic B-spline through the joints of the servo periods, two
/// periods later: (q1 + 4 q2 + q3)/6. X, Y, Z within 10 nm, A and C within 1e-6 degrees, at rest and in
/// motion; what remains are the digits of the trace.
void compare_places(const std::vector<Period>& periods, const KinematicChain& chain) {
  std::vector<std::array<double, axis_count>> ours;
  for (const Period& period : periods) {
    ours.push_back(joints_for(chain, period.tool));
  }
  std::array<double, axis_count> farthest{};
  double turned = 0;
  double farthest_tip = 0;  ///< at rest, forwards from the control's own joints [mm]
  int resting = 0;
  constexpr std::size_t delay = 2;
  for (std::size_t k = delay + 2; k < periods.size(); ++k) {
    const Period& before = periods[k - delay - 2];
    if (periods[k].tool == before.tool && periods[k].joints == before.joints) {
      farthest_tip =
          std::max(farthest_tip, (tip_of(chain, periods[k].joints) - tip_of(periods[k].tool)).norm());
      ++resting;
    }
    for (std::size_t i = 0; i < axis_count; ++i) {
      const double joint = (ours[k - delay - 1][i] + 4 * ours[k - delay][i] + ours[k - delay + 1][i]) / 6;
      farthest[i] = std::max(farthest[i], std::abs(joint - periods[k].joints[i]));
    }
    turned = std::max(turned, std::abs(periods[k].joints[3]));
  }
  EXPECT_GT(turned, 60) << "the table has tilted";
  EXPECT_GT(resting, 100);
  EXPECT_LT(farthest_tip, 1e-5);
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_LT(farthest[i], i < 3 ? 1e-5 : 1e-6) << axis_names[i];
  }
}

/// The model's motions last as long as those of the control.
void compare_times(const std::vector<Period>& periods, const fs::path& program) {
  std::vector<std::array<double, axis_count>> tool;
  for (const Period& period : periods) {
    tool.push_back(period.tool);
  }
  const std::vector<double> theirs = motions_of(tool);
  const std::vector<double> ours = motions_of(simulated(program));
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_GT(theirs.size(), 10U);
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    EXPECT_NEAR(ours[i], theirs[i], 2e-3) << i;
  }
}

TEST(KinematicsOracle, MovesTheAxesAsTheTableOfLinuxcnc) {
  const fs::path folder(FEEDSCOPE_BINARY_DIR);
  const fs::path trace = folder / "oracle_table.trace";
  const std::array programs{folder / "oracle_table_22.ngc", folder / "oracle_table_23.ngc"};
  std::ofstream(programs[0]) << random_program(22);
  std::ofstream(programs[1]) << random_program(23);
  const int code = test::run_linuxcnc("table", trace, programs);
  if (code == test::no_linuxcnc) {
    GTEST_SKIP() << "there is no LinuxCNC to run: see packaging/oracle";
  }
  ASSERT_EQ(code, 0);
  const std::vector<std::vector<Period>> periods = periods_of(trace, programs.size());
  const KinematicChain chain = table_of_linuxcnc();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    SCOPED_TRACE(programs[i].filename().string());
    ASSERT_GT(periods[i].size(), 5000U);
    compare_places(periods[i], chain);
    compare_times(periods[i], programs[i]);
  }
}

}  // namespace
}  // namespace feedscope
