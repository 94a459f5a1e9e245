#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/analysis/run/run.h"
#include "core/models/linuxcnc/linuxcnc_run.h"
#include "core/toolpath/machine_path.h"
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
  settings.path_mode = mode == "g61" ? LinuxCncPathMode::exact_path : LinuxCncPathMode::blend;
  settings.blend_tolerance = mode.find("p05") != std::string::npos ? 0.05 : 0;
  settings.naive_tolerance = mode == "g64p05" ? 0.05 : 0;
  return settings;
}

/// The control of the tables stands at its zero, and no work offset is set.
std::shared_ptr<const Toolpath> path_of(const std::filesystem::path& file) {
  Settings places;
  for (const char axis : {'x', 'y', 'z'}) {
    places.set(std::string("part_zero_") + axis + "_mm", 0.0);
  }
  return on_machine(load_program(file).toolpath, Machine(), places).toolpath;
}

Trajectory run_of(const testing::ControlRow& row, const testing::ControlTables& tables) {
  LinuxCncRun run(path_of(row.program), shipped_machines().load("spinner-mvc850"),
                  settings_of(tables.configurations(), row.configuration));
  return run.run(nullptr);
}

/// Corners with an arc that the planner laid.
std::size_t arcs_laid(const Trajectory& motion) {
  std::size_t arcs = 0;
  for (std::size_t i = 0; i < motion.path().rounded_count(); ++i) {
    arcs += motion.path().kind(motion.path().rounded(i).first) == ElementKind::arc ? 1 : 0;
  }
  return arcs;
}

bool is_cut_short(const testing::ControlRow& row) {
  return row.text.find("\tERR") != std::string::npos;  // the control stopped at a line that it refuses
}

TEST(LinuxCncTables, TimesOfSamplesAreThoseOfTheControlToTheMillisecond) {
  constexpr double millisecond = 5e-4;
  const testing::ControlTables tables("linuxcnc");
  if (!tables) {
    GTEST_SKIP() << "no results of controls at " << testing::ControlTables::folder();
  }
  int rows = 0;
  int equal_arcs = 0;
  for (const testing::ControlRow& row : tables.rows()) {
    if (row.text.find("\tsample\t") == std::string::npos || row.total > 100 || is_cut_short(row)) {
      continue;
    }
    const Trajectory motion = run_of(row, tables);
    const double off = std::abs(motion.duration() - row.total);
    const std::size_t arcs = arcs_laid(motion);
    equal_arcs += arcs == row.blend_arcs ? 1 : 0;
    ++rows;
    EXPECT_LT(off, millisecond) << row.text;
  }
  EXPECT_EQ(rows, 548);
  EXPECT_GE(equal_arcs, 538);
}

/// Those of up to 1000 s.
TEST(LinuxCncTables, TimesOfOtherProgramsStayAsNearTheControlAsTheyAre) {
  constexpr double millisecond = 5e-4;
  constexpr double usual = 1e-3;
  constexpr double of_nurbs = 1.5e-3;  // which LinuxCNC cuts into arcs of its own
  const testing::ControlTables tables("linuxcnc");
  if (!tables || !testing::ControlTables::has_corpus()) {
    GTEST_SKIP() << "no results of controls, or no programs, at " << testing::ControlTables::folder();
  }
  constexpr double longest = 1000;  // [s]
  int rows = 0;
  int equal = 0;
  int near = 0;
  for (const testing::ControlRow& row : tables.rows()) {
    if (row.text.find("\tcorpus\t") == std::string::npos || row.total > longest || is_cut_short(row)) {
      continue;
    }
    const double off = std::abs(run_of(row, tables).duration() - row.total);
    const bool nurbs = row.text.starts_with("LinuxCNC__nurbs_G5_Curva_Delfino.ngc\t");
    ++rows;
    equal += off < millisecond ? 1 : 0;
    near += off < usual * row.total + millisecond ? 1 : 0;
    EXPECT_LT(off, (nurbs ? of_nurbs : usual) * row.total + millisecond) << row.text;
  }
  EXPECT_EQ(rows, 288);
  EXPECT_GE(equal, 193);
  EXPECT_GE(near, 284);
}

}  // namespace
}  // namespace feedscope
