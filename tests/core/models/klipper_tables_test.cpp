#include <gtest/gtest.h>

#include <string>

#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "tests/core/models/control_tables.h"

namespace feedscope {
namespace {

using testing::ControlRow;
using testing::ControlTables;

Machine machine_of(const nlohmann::json& configuration) {
  constexpr double unlimited = 1000;  // what Klipper does not limit
  const nlohmann::json& printer = configuration.at("[printer]");
  Machine machine;
  machine.id = machine.name = machine.control = machine.reference = "klipper";
  for (const char name : coordinate_names) {
    for (const char* limit : {"velocity", "acceleration", "jerk", "blend_jerk"}) {
      set_axis_limit(machine, name, limit, unlimited);
    }
  }
  const auto set = [&](const char* key, const char* of, double factor) {
    machine.settings.set(key, printer.at(of).get<double>() * factor);
  };
  set("max_velocity_m_min", "max_velocity", 60.0 / 1000);
  set("max_acceleration_m_s2", "max_accel", 1.0 / 1000);
  set("max_z_velocity_m_min", "max_z_velocity", 60.0 / 1000);
  set("max_z_acceleration_m_s2", "max_z_accel", 1.0 / 1000);
  set("square_corner_velocity_mm_s", "square_corner_velocity", 1);
  set("minimum_cruise_ratio", "minimum_cruise_ratio", 1);
  machine.settings.set("arc_resolution_mm", configuration.at("[gcode_arcs]").at("resolution").get<double>());
  return machine;
}

/// The file as it is, and one full line a block for lines that Klipper would not know.
TEST(KlipperTables, TotalTimesAreThoseOfTheControl) {
  const ControlTables tables("klipper");
  if (!tables) {
    GTEST_SKIP() << "no results of controls at " << ControlTables::folder();
  }
  const ControlModel& klipper = find_model("klipper");
  std::size_t compared = 0;
  for (const ControlRow& row : tables.rows()) {
    if (row.program.filename().string().starts_with("fanuc_") &&
        row.text.find("left out") != std::string::npos) {
      continue;  // what the table has is not the whole program: its cycles and macros were left out
    }
    const std::size_t slash = row.configuration.find('/');
    Machine machine = machine_of(tables.configurations().at(row.configuration.substr(0, slash)));
    machine.settings.set("refuse", row.configuration.substr(slash + 1) == "raw" ? "on" : "off");
    const LoadedProgram program = load_program(row.program);
    const Trajectory run = klipper.simulate(program.toolpath, machine, complete_settings(klipper, machine));
    EXPECT_NEAR(run.duration(), row.total, 1e-5) << row.text;
    ++compared;
  }
  EXPECT_EQ(compared, 184U);
}

/// Random programs, by a second program of the same rules that agrees with the control's results.
TEST(KlipperTables, RandomProgramsTakeAsLongAsByTheWitness) {
  const ControlModel& klipper = find_model("klipper");
  const std::vector<testing::WitnessRow> rows = testing::witness_rows("klipper");
  EXPECT_EQ(rows.size(), 40U);
  for (const testing::WitnessRow& row : rows) {
    const Machine machine = machine_of(row.configuration);
    const LoadedProgram program =
        load_program(std::make_shared<const SourceText>(SourceText("random.nc", row.program)));
    const Trajectory run = klipper.simulate(program.toolpath, machine, complete_settings(klipper, machine));
    EXPECT_NEAR(run.duration(), row.seconds, 1e-6) << row.configuration << "\n" << row.program;
  }
}

}  // namespace
}  // namespace feedscope
