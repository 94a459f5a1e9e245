#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/base/geometry.h"
#include "core/machine/machine.h"
#include "core/models/control_model.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

const std::filesystem::path folder = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "machines";

MachineLibrary library() {
  return MachineLibrary(folder, all_model_settings());
}

std::string row(const Machine& machine, const std::string& name, const std::string& key, const auto& value) {
  const Provenance& provenance = machine.provenance.at(key);
  return fmt::format("| `{}` | {} | {}{} |\n", name, value, provenance.assumed ? "assumed: " : "",
                     provenance.source);
}

/// The section of machines/README.md that a machine file asks for.
std::string readme_section(const Machine& machine) {
  std::string text = fmt::format("\n## {}\n\n{}, {}. {}.\n\n| Number | Value | Source |\n|---|---|---|\n",
                                 machine.id, machine.name, machine.control, machine.reference);
  for (const char axis : axis_names(machine)) {
    for (const SettingSpec& spec : axis_specs_of(axis)) {
      const SettingValue value = axis_value(machine, axis, spec.key);
      if (const double* number = std::get_if<double>(&value)) {
        text += row(machine, fmt::format("axes.{}.{}", axis, file_key(spec)),
                    fmt::format("{}.{}", axis, spec.key), *number);
      }
    }
  }
  if (!machine.kinematics.empty()) {
    text += row(machine, "kinematics.chain", "kinematics.chain", machine.kinematics.chain);
  }
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    for (const auto& [name, v] : {std::pair("direction", axis.direction), std::pair("point", axis.point)}) {
      const std::string key = fmt::format("kinematics.{}.{}", axis.name, name);
      text += row(machine, key, key, fmt::format("{}, {}, {}", v.x(), v.y(), v.z()));
    }
  }
  for (const auto& [key, value] : machine.settings.values()) {
    text +=
        std::visit([&, key = key](const auto& v) { return row(machine, "settings." + key, key, v); }, value);
  }
  return text;
}

TEST(ShippedMachines, AreThoseOfThePapersOfOpenControlsAndOfFiveAxes) {
  EXPECT_EQ(library().ids(),
            (std::vector<std::string>{"dmg-mori-evo40", "five-axis-head-b-table-c", "five-axis-head-bc",
                                      "five-axis-table-ac", "grbl-router", "hermle-c800u", "huron-kx10",
                                      "klipper-corexy", "linuxcnc-mill", "mikron-ucp710", "spinner-mvc850"}));
}

TEST(ShippedMachines, LoadWithTheirFileNameAsId) {
  const MachineLibrary machines = library();
  for (const std::string& id : machines.ids()) {
    EXPECT_EQ(machines.load(id).id, id);
  }
}

TEST(ShippedMachines, NameAModelAndGiveEverySettingItReads) {
  const MachineLibrary machines = library();
  for (const std::string& id : machines.ids()) {
    const Machine machine = machines.load(id);
    for (const std::string& key : find_model(machine.model).info().uses) {
      if (key == "program_tolerance" || key == "merge_collinear_mm" || key == block_time_key ||
          key == exact_stop_window_key) {
        continue;  // choices of the run, and what nobody has measured
      }
      EXPECT_TRUE(machine.settings.has(key)) << id << ": " << key;
    }
  }
}

TEST(ShippedMachines, HoldTheNumbersOfTheirPapers) {
  const Machine spinner = library().load("spinner-mvc850");  // Essid 2019, table 2
  EXPECT_EQ(spinner.axes[0], (AxisLimits{20000.0 / 60, 1000, 15000, 10000}));
  EXPECT_EQ(spinner.axes[1], spinner.axes[0]);
  EXPECT_EQ(spinner.settings.number("interpolation_period_s"), 0.001);
  EXPECT_EQ(spinner.settings.number("lookahead_blocks"), 8);
  EXPECT_EQ(spinner.settings.number("radial_acceleration_share"), 0.2);
  EXPECT_EQ(spinner.settings.number("radial_jerk_share"), 0.2);

  const Machine mikron = library().load("mikron-ucp710");  // Tapie 2007, table 1
  EXPECT_EQ(mikron.axes[0].velocity, 500);
  EXPECT_EQ(mikron.axes[0].acceleration, 2500);
  EXPECT_EQ(mikron.axes[1].acceleration, 3000);
  EXPECT_EQ(mikron.axes[2].acceleration, 2100);
  EXPECT_EQ(mikron.axes[0].jerk, 5000);
  EXPECT_EQ(mikron.axes[2].jerk, 50000);
  EXPECT_EQ(mikron.settings.number("interpolation_period_s"), 0.012);
  EXPECT_EQ(mikron.settings.number("curvilinear_jerk_m_s3"), 10);
  EXPECT_EQ(mikron.settings.number("tangential_share"), 0.6);

  const Machine huron = library().load("huron-kx10");  // Msaddek 2011, table 1
  EXPECT_EQ(huron.axes[2].acceleration, 3000);
  EXPECT_EQ(huron.axes[1].jerk, 50000);
  EXPECT_EQ(huron.settings.number("contour_tolerance_mm"), 0.007);
  EXPECT_EQ(huron.settings.number("lookahead_blocks"), 100);
}

TEST(ShippedMachines, StandInTheReadmeWithEveryNumberAndSource) {
  std::stringstream readme;
  readme << std::ifstream(folder / "README.md").rdbuf();
  const MachineLibrary machines = library();
  for (const std::string& id : machines.ids()) {
    const std::string section = readme_section(machines.load(id));
    EXPECT_NE(readme.str().find(section), std::string::npos) << "machines/README.md should hold:\n"
                                                             << section;
  }
}

TEST(ShippedMachines, SurviveWritingAndReading) {
  const MachineLibrary machines = library();
  for (const std::string& id : machines.ids()) {
    const Machine machine = machines.load(id);
    const auto copy =
        std::filesystem::temp_directory_path() / fmt::format("feedscope-{}-{}.toml", id, getpid());
    std::ofstream(copy) << write_machine(machine);
    EXPECT_EQ(read_machine(copy, all_model_settings()), machine) << id;
    std::filesystem::remove(copy);
  }
}

}  // namespace
}  // namespace feedscope
