#include "core/base/error.h"
#include "tests/core/machine/import/import_fixture.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* printer_cfg = R"([mcu]
serial: /dev/ttyACM0
[printer]
kinematics: corexy
max_velocity: 300  # mm/s
max_accel = 5000
max_z_velocity: 15
max_z_accel: 100
square_corner_velocity: 8.0
[gcode_arcs]
resolution: 0.1
[gcode_macro START]
gcode:
    SET_VELOCITY_LIMIT ACCEL=1000
    G28
)";

class KlipperConfig : public test::ImportTest {
 protected:
  static std::string changed(const std::string& from, const std::string& to,
                             const std::string& text = printer_cfg) {
    return replaced(text, from, to);
  }
};

TEST_F(KlipperConfig, GivesLimitsOfThePathAndOfZ) {
  const ImportedMachine imported = import(printer_cfg, "printer.cfg");
  const Machine& machine = imported.machine;
  EXPECT_EQ(machine.model, "klipper");
  EXPECT_EQ(machine.name, "printer (corexy)");
  EXPECT_EQ(machine.settings.number("max_velocity_m_min"), 18);
  EXPECT_EQ(machine.settings.number("max_acceleration_m_s2"), 5);
  EXPECT_EQ(machine.settings.number("max_z_velocity_m_min"), 0.9);
  EXPECT_EQ(machine.settings.number("max_z_acceleration_m_s2"), 0.1);
  EXPECT_EQ(machine.settings.number("square_corner_velocity_mm_s"), 8);
  EXPECT_EQ(machine.settings.number("arc_resolution_mm"), 0.1);
  EXPECT_NEAR(machine.axes[1].velocity, 300, 1e-9);
  EXPECT_NEAR(machine.axes[2].acceleration, 100, 1e-9);
  EXPECT_EQ(source(imported, "max_velocity_m_min"), "printer.cfg, line 5: [printer] max_velocity = 300 mm/s");
  EXPECT_EQ(source(imported, "minimum_cruise_ratio"),
            "assumed: printer.cfg does not give minimum_cruise_ratio: default of Klipper");
  EXPECT_EQ(notes(imported, "printer.cfg"),
            "printer.cfg: info: not used: [mcu], [gcode_macro START] [not-used]\n");
}

TEST_F(KlipperConfig, GivesLimitsOfTheExtruderAlone) {
  const auto of = [](const std::string& extruder) {
    return import(std::string(printer_cfg) + "[extruder]\n" + extruder, "printer.cfg").machine;
  };
  const Machine given = of("max_extrude_only_velocity: 120\nmax_extrude_only_accel: 1500\n");
  EXPECT_EQ(given.settings.number("max_extrude_velocity_mm_s"), 120);
  EXPECT_EQ(given.settings.number("max_extrude_acceleration_m_s2"), 1.5);
  // A square of twice the nozzle's diameter, over the section of the filament.
  const Machine usual = of("nozzle_diameter: 0.6\nfilament_diameter: 1.75\n");
  EXPECT_NEAR(usual.settings.number("max_extrude_velocity_mm_s"), 300 * 1.44 / 2.405282, 1e-4);
  EXPECT_NEAR(usual.settings.number("max_extrude_acceleration_m_s2"), 5 * 1.44 / 2.405282, 1e-5);
  const Machine section = of("nozzle_diameter: 0.6\nfilament_diameter: 1.75\nmax_extrude_cross_section: 5\n");
  EXPECT_NEAR(section.settings.number("max_extrude_velocity_mm_s"), 300 * 5 / 2.405282, 1e-3);
  EXPECT_FALSE(of("rotation_distance: 7\n").settings.has("max_extrude_velocity_mm_s"));
}

TEST_F(KlipperConfig, LaterFilesReplaceEarlierValues) {
  write("printer.cfg", std::string(printer_cfg) + "[include tuned/*.cfg]\n[include more.cfg] ; own\n");
  write("tuned/b.cfg", "[printer]\nmax_accel: 7000\n");
  write("tuned/a.cfg", "[printer]\nmax_accel: 6000\n");
  write("more.cfg", "#[printer]\nmax_nothing\n");
  const ImportedMachine imported = import_file("printer.cfg");
  EXPECT_EQ(imported.machine.settings.number("max_acceleration_m_s2"), 7);
  EXPECT_EQ(source(imported, "max_acceleration_m_s2"),
            "tuned/b.cfg, line 2: [printer] max_accel = 7000 mm/s2");
  const std::string said = notes(imported, "printer.cfg");
  EXPECT_THAT(
      said, HasSubstr("tuned/a.cfg:2: warning: [printer] max_accel = 6000, but 5000 in printer.cfg, line 6; "
                      "6000 is used"));
  EXPECT_THAT(said, HasSubstr("more.cfg:2: warning: 'max_nothing' is neither a section nor a value"));
}

TEST_F(KlipperConfig, IncludesTheFilesThatMatchAPattern) {
  const std::vector<std::string> files{".a1.cfg", "a1.cfg", "a2.cfg", "a22.cfg", "b.cfg", "b[.cfg"};
  for (const std::string& name : files) {
    write("parts/" + name, "max_nothing\n");
  }
  const auto included = [&](const std::string& pattern) {
    write("printer.cfg", std::string(printer_cfg) + "[include parts/" + pattern + "]\n");
    const std::string said = notes(import_file("printer.cfg"), "printer.cfg");
    std::vector<std::string> found;
    std::ranges::copy_if(files, std::back_inserter(found), [&](const std::string& name) {
      return said.find("parts/" + name + ":1: warning") != std::string::npos;
    });
    return found;
  };
  EXPECT_THAT(included("*"), ElementsAre("a1.cfg", "a2.cfg", "a22.cfg", "b.cfg", "b[.cfg"));
  EXPECT_THAT(included("a?.cfg"), ElementsAre("a1.cfg", "a2.cfg"));
  EXPECT_THAT(included("*2*.c*g"), ElementsAre("a2.cfg", "a22.cfg"));
  EXPECT_THAT(included("*2.cfg"), ElementsAre("a2.cfg", "a22.cfg"));
  EXPECT_THAT(included("a[2-9]*"), ElementsAre("a2.cfg", "a22.cfg"));
  EXPECT_THAT(included("[!b]*"), ElementsAre("a1.cfg", "a2.cfg", "a22.cfg"));
  EXPECT_THAT(included("?[[]*"), ElementsAre("b[.cfg"));
  EXPECT_THAT(included("b[.*"), ElementsAre("b[.cfg"));
  EXPECT_THAT(included(".*"), ElementsAre(".a1.cfg"));
  EXPECT_THAT(included("?.*x"), IsEmpty());
}

TEST_F(KlipperConfig, ReadsWhatSaveConfigWrites) {
  const std::string text = std::string(printer_cfg) +
                           "#*# <---------------------- SAVE_CONFIG ---------------------->\n#*#\n"
                           "#*# [printer]\n#*# square_corner_velocity = 3\n";
  EXPECT_EQ(import(text, "printer.cfg").machine.settings.number("square_corner_velocity_mm_s"), 3);
}

TEST_F(KlipperConfig, MakesACruiseRatioOfTheFormerSetting) {
  const ImportedMachine imported =
      import(changed("max_z_velocity", "max_accel_to_decel: 1250\nmax_z_velocity"), "p.cfg");
  EXPECT_EQ(imported.machine.settings.number("minimum_cruise_ratio"), 0.75);
  EXPECT_THAT(source(imported, "minimum_cruise_ratio"),
              StartsWith("p.cfg, line 7: [printer] max_accel_to_decel = 1250 mm/s2 as minimum cruise ratio"));
}

TEST_F(KlipperConfig, ReportsWhatKlipperRefuses) {
  EXPECT_THAT(
      notes(import(changed("max_z_velocity: 15", "max_z_velocity: 400"), "p.cfg"), "p.cfg"),
      HasSubstr("p.cfg:7: error: [printer] max_z_velocity = 400 mm/s exceeds max_velocity = 300 (p.cfg, line "
                "5): Klipper does not start with it [limits-contradict]"));
  EXPECT_THAT(notes(import(changed("max_accel = 5000", "max_accel = 0"), "p.cfg"), "p.cfg"),
              HasSubstr("p.cfg:6: error: [printer] max_accel = 0 mm/s2 must be above 0"));
  EXPECT_THAT(notes(import(changed("= 5000", "= much"), "p.cfg"), "p.cfg"),
              HasSubstr("'much' is not a number"));
  EXPECT_THAT(notes(import("[mcu]\n[stepper_x]\n", "p.cfg"), "p.cfg"),
              HasSubstr("p.cfg: error: section [printer] is missing"));
}

TEST_F(KlipperConfig, NotesWhatTheModelDoesNotShow) {
  const std::string text = changed("[gcode_arcs]\nresolution: 0.1\n", "[input_shaper]\nshaper_freq_x: 50\n",
                                   changed("corexy", "delta"));
  const std::string said = notes(import(text, "p.cfg"), "p.cfg");
  EXPECT_THAT(said, HasSubstr("p.cfg:4: warning: kinematics delta are not modelled"));
  EXPECT_THAT(said, HasSubstr("p.cfg:10: info: input shaping is not modelled"));
  EXPECT_THAT(said, HasSubstr("there is no section [gcode_arcs]"));
  EXPECT_THAT(said, Not(HasSubstr("SET_VELOCITY_LIMIT ACCEL")));
  EXPECT_THAT(
      notes(import(changed("max_accel =", "max_acel ="), "p.cfg"), "p.cfg"),
      HasSubstr(
          "p.cfg:6: warning: [printer] max_acel is not used here; skipped [not-understood] (did you mean "
          "'max_accel'?)"));
}

}  // namespace
}  // namespace feedscope
