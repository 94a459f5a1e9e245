#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/analysis/run.h"
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
  return text + "M2\n";
}

std::vector<Period> periods_of(const fs::path& file) {
  std::vector<Period> periods;
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
    int program = 0;
    numbers >> program;
    EXPECT_TRUE(numbers) << "periods were lost: " << line;
    if (program == 1) {
      periods.push_back(period);
    }
  }
  return periods;
}

/// As the control's own configuration is imported.
KinematicChain table_of_linuxcnc() {
  const fs::path file = fs::path(FEEDSCOPE_SOURCE_DIR) / "tests" / "oracle" / "table.ini";
  return chain_of(import_machine(file, machine_file_settings()).machine.kinematics);
}

/// Of the machine, in the order X, Y, Z, A, C [mm], [deg], with the tool as a period says.
std::array<double, axis_count> joints_for(const KinematicChain& chain,
                                          const std::array<double, axis_count>& tool) {
  constexpr std::string_view names = "XYZAC";
  const Vec3 tip(tool[0], tool[1], tool[2] - tool_length);
  std::vector<double> angles;
  for (const std::size_t k : chain.rotary()) {
    angles.push_back(units::from_deg(tool[names.find(chain.axes()[k].name)]));
  }
  const std::vector<double> places = chain.places(tip, angles, tool_length);
  EXPECT_LT((chain.pose(places, tool_length).tip - tip).norm(), 1e-9);
  std::array<double, axis_count> joints{};
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const double place = places[k];
    joints[names.find(chain.axes()[k].name)] = chain.axes()[k].rotary ? units::to_deg(place) : place;
  }
  return joints;
}

/// Behind its kinematics the control lays a cubic B-spline through the joints of the servo periods, two
/// periods later: (q1 + 4 q2 + q3)/6. X, Y, Z within 10 nm, A and C within 1e-6 degrees, at rest and in
/// motion; what remains are the digits of the trace.
TEST(KinematicsOracle, PutsTheAxesWhereTheTableOfLinuxcncHasThem) {
  const fs::path trace = fs::path(FEEDSCOPE_BINARY_DIR) / "oracle_table.trace";
  const std::array programs{fs::path(FEEDSCOPE_BINARY_DIR) / "oracle_table.ngc"};
  std::ofstream(programs[0]) << random_program(22);
  const int code = test::run_linuxcnc("table", trace, programs);
  if (code == test::no_linuxcnc) {
    GTEST_SKIP() << "there is no LinuxCNC to run: see packaging/oracle";
  }
  ASSERT_EQ(code, 0);
  const std::vector<Period> periods = periods_of(trace);
  ASSERT_GT(periods.size(), 5000U);
  const KinematicChain chain = table_of_linuxcnc();
  std::vector<std::array<double, axis_count>> ours;
  for (const Period& period : periods) {
    ours.push_back(joints_for(chain, period.tool));
  }
  std::array<double, axis_count> farthest{};
  double turned = 0;
  constexpr std::size_t delay = 2;
  for (std::size_t k = delay + 1; k < periods.size(); ++k) {
    for (std::size_t i = 0; i < axis_count; ++i) {
      const double joint = (ours[k - delay - 1][i] + 4 * ours[k - delay][i] + ours[k - delay + 1][i]) / 6;
      farthest[i] = std::max(farthest[i], std::abs(joint - periods[k].joints[i]));
    }
    turned = std::max(turned, std::abs(periods[k].joints[3]));
  }
  EXPECT_GT(turned, 60) << "the table has tilted";
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_LT(farthest[i], i < 3 ? 1e-5 : 1.1e-6) << i;
    RecordProperty(fmt::format("axis_{}", i), fmt::format("{:.3g}", farthest[i]));
  }
}

}  // namespace
}  // namespace feedscope
