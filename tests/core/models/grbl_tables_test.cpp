#include <gtest/gtest.h>

#include <cmath>

#include "core/analysis/run/run.h"
#include "tests/core/models/control_tables.h"

namespace feedscope {
namespace {

using testing::ControlRow;
using testing::ControlTables;

/// The machine whose $ settings are `listing`.
Machine machine_of(const nlohmann::json& listing) {
  constexpr double unlimited = 1000;  // what grbl does not limit
  Machine machine;
  machine.id = machine.name = machine.control = machine.reference = "grbl";
  for (int axis = 0; axis < 3; ++axis) {
    const char name = coordinate_names[static_cast<std::size_t>(axis)];
    const auto number = [&](int first) {
      return listing.at("$" + std::to_string(first + axis)).get<double>();
    };
    set_axis_value(machine, name, "steps_per_mm", number(100));
    set_axis_limit(machine, name, "velocity", number(110) / 1000);
    set_axis_limit(machine, name, "acceleration", number(120) / 1000);
    set_axis_limit(machine, name, "jerk", unlimited);
    set_axis_limit(machine, name, "blend_jerk", unlimited);
  }
  machine.settings.set("junction_deviation_mm", listing.at("$11").get<double>());
  machine.settings.set("arc_tolerance_mm", listing.at("$12").get<double>());
  machine.settings.set("idle_delay_ms", listing.at("$1").get<double>());
  return machine;
}

/// Times are given to 0.1 ms. One row of 101 is further off, by 4e-7 of 731 s; it has 20 000 chords of arcs.
TEST(GrblTables, TotalTimesAreThoseOfTheControl) {
  const ControlTables tables("grbl");
  if (!tables) {
    GTEST_SKIP() << "no results of controls at " << ControlTables::folder();
  }
  const ControlModel& grbl = find_model("grbl");
  EXPECT_EQ(tables.rows().size(), 101U);
  for (const ControlRow& row : tables.rows()) {
    const Machine machine = machine_of(tables.configurations().at(row.configuration).at("settings"));
    const LoadedProgram program = load_program(row.program);
    const Trajectory run = grbl.simulate(program.toolpath, machine, complete_settings(grbl, machine));
    EXPECT_NEAR(run.duration(), row.total, 6e-5 + 5e-7 * row.total) << row.text;
  }
}

/// `profile_s`, the sum of the times as they are planned. Ramps are laid from their speeds here; in the
/// control a last segment of a block may stand nearly still for some 10 ms by the last bit.
TEST(GrblTables, PlannedTimesAreThoseOfTheControl) {
  const ControlTables tables("grbl");
  if (!tables) {
    GTEST_SKIP() << "no results of controls at " << ControlTables::folder();
  }
  const ControlModel& grbl = find_model("grbl");
  constexpr double hold = 0.025;
  for (const ControlRow& row : tables.rows()) {
    Machine machine = machine_of(tables.configurations().at(row.configuration).at("settings"));
    machine.settings.set("step_timing", "off");
    const LoadedProgram program = load_program(row.program);
    const Trajectory run = grbl.simulate(program.toolpath, machine, complete_settings(grbl, machine));
    std::istringstream fields(row.text);
    std::string field;
    std::vector<std::string> all;
    while (std::getline(fields, field, '\t')) {
      all.push_back(field);
    }
    const double planned = std::stod(all.at(6)) + std::stod(all.at(7));
    const double holds = hold * std::max(0.0, std::stod(all.at(8)) - 1);
    EXPECT_NEAR(run.duration(), planned + holds, 1e-4 + 1e-4 * row.total) << row.text;
  }
}

/// Random programs, by a second program of the same rules that agrees with the control's results.
TEST(GrblTables, RandomProgramsTakeAsLongAsByTheWitness) {
  const ControlModel& grbl = find_model("grbl");
  const std::vector<testing::WitnessRow> rows = testing::witness_rows("grbl");
  EXPECT_EQ(rows.size(), 40U);
  for (const testing::WitnessRow& row : rows) {
    const Machine machine = machine_of(row.configuration.at("settings"));
    const LoadedProgram program =
        load_program(std::make_shared<const SourceText>(SourceText("random.nc", row.program)));
    const Trajectory run = grbl.simulate(program.toolpath, machine, complete_settings(grbl, machine));
    EXPECT_NEAR(run.duration(), row.seconds, 1e-5) << row.configuration << "\n" << row.program;
  }
}

}  // namespace
}  // namespace feedscope
