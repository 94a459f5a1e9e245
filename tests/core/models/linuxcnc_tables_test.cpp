#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/analysis/run.h"
#include "core/models/linuxcnc/linuxcnc_run.h"
#include "tests/core/models/control_tables.h"

namespace feedscope {
namespace {

/// The configuration of a row: machine/mode/planner.
LinuxCncSettings settings_of(const nlohmann::json& configurations, const std::string& configuration) {
  std::istringstream parts(configuration);
  std::string machine;
  std::string mode;
  std::string planner;
  std::getline(parts, machine, '/');
  std::getline(parts, mode, '/');
  std::getline(parts, planner, '/');
  const nlohmann::json& values = configurations.at("machines").at(machine);
  LinuxCncSettings settings;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    settings.velocity[i] = values.at("[AXIS_X/Y/Z]MAX_VELOCITY mm/s").at(at).get<double>();
    settings.acceleration[i] = values.at("[AXIS_X/Y/Z]MAX_ACCELERATION mm/s2").at(at).get<double>();
  }
  settings.max_velocity = values.at("[TRAJ]MAX_LINEAR_VELOCITY mm/s").get<double>();
  settings.max_override = values.at("[DISPLAY]MAX_FEED_OVERRIDE").get<double>();
  settings.master = planner == "master";
  settings.blends = mode != "g61";
  settings.blend_tolerance = mode.find("p05") != std::string::npos ? 0.05 : 0;
  settings.naive_tolerance = mode == "g64p05" ? 0.05 : 0;
  return settings;
}

/// The planner is not yet a model: short chains, dwells and subprograms are open. It must not become worse.
TEST(LinuxCncTables, MostTimesAreThoseOfTheControl) {
  const testing::ControlTables tables("linuxcnc");
  if (!tables) {
    GTEST_SKIP() << "no results of controls at " << testing::ControlTables::folder();
  }
  int rows = 0;
  int equal = 0;
  int close = 0;
  for (const testing::ControlRow& row : tables.rows()) {
    if (row.text.find("\tsample\t") == std::string::npos || row.total > 60) {
      continue;
    }
    const LoadedProgram program = load_program(row.program);
    LinuxCncRun run(program.toolpath, shipped_machines().load("spinner-mvc850"),
                    settings_of(tables.configurations(), row.configuration));
    const double off = std::abs(run.run(nullptr).duration() - row.total);
    ++rows;
    equal += off <= 6e-4 ? 1 : 0;
    close += off <= 1e-3 * row.total ? 1 : 0;
  }
  EXPECT_EQ(rows, 576);
  EXPECT_GE(equal, 425);
  EXPECT_GE(close, 480);
}

}  // namespace
}  // namespace feedscope
