#include <fmt/format.h>

#include "core/base/error.h"
#include "tests/core/machine/import/import_fixture.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* mill_ini = R"(# a retrofitted mill
[EMC]
MACHINE = Bridgeport
[EMCMOT]
SERVO_PERIOD = 1000000
[TRAJ]
COORDINATES = X Y Z
LINEAR_UNITS = mm
MAX_LINEAR_VELOCITY = 100
[KINS]
KINEMATICS = trivkins
JOINTS = 3
[AXIS_X]
MAX_VELOCITY = 80   # 4.8 m/min
MAX_ACCELERATION = 500
[JOINT_0]
MAX_VELOCITY = 90
MAX_ACCELERATION = 600
[AXIS_Y]
MAX_VELOCITY = 70
MAX_ACCELERATION = 400
[JOINT_1]
MAX_VELOCITY = 90
MAX_ACCELERATION = 600
[AXIS_Z]
MAX_VELOCITY = 50
MAX_ACCELERATION = 300
[JOINT_2]
MAX_VELOCITY = 60
MAX_ACCELERATION = 400
)";

class LinuxCncIni : public test::ImportTest {
 protected:
  static std::string changed(const std::string& from, const std::string& to,
                             const std::string& text = mill_ini) {
    return replaced(text, from, to);
  }
};

TEST_F(LinuxCncIni, GivesLimitsOfTheAxesWithFileAndLine) {
  const ImportedMachine imported = import(mill_ini, "mill.ini");
  const Machine& machine = imported.machine;
  EXPECT_EQ(imported.kind, "INI file of LinuxCNC");
  EXPECT_EQ(machine.id, "mill");
  EXPECT_EQ(machine.name, "Bridgeport");
  EXPECT_EQ(machine.control, "LinuxCNC");
  EXPECT_NEAR(machine.axes[0].velocity, 80, 1e-9);
  EXPECT_NEAR(machine.axes[1].velocity, 70, 1e-9);
  EXPECT_NEAR(machine.axes[2].acceleration, 300, 1e-9);
  EXPECT_EQ(source(imported, "X.velocity"), "mill.ini, line 14: [AXIS_X] MAX_VELOCITY = 80 mm/s");
  EXPECT_EQ(source(imported, "Z.acceleration"), "mill.ini, line 27: [AXIS_Z] MAX_ACCELERATION = 300 mm/s2");
  EXPECT_THAT(source(imported, "X.jerk"), StartsWith("assumed: LinuxCNC limits no jerk"));
  EXPECT_EQ(machine.settings.number("interpolation_period_s"), 0.001);
  EXPECT_EQ(notes(imported, "mill.ini"), "mill.ini: info: not used: [KINS] JOINTS [not-used]\n");
}

TEST_F(LinuxCncIni, GivesWhatThePlannerNeeds) {
  const ImportedMachine imported =
      import(changed("[EMCMOT]", "[DISPLAY]\nMAX_FEED_OVERRIDE = 1.5\n[EMCMOT]"), "mill.ini");
  const Settings& settings = imported.machine.settings;
  EXPECT_EQ(imported.machine.model, "linuxcnc");
  EXPECT_EQ(settings.number("servo_period_s"), 0.001);
  EXPECT_EQ(settings.number("max_linear_velocity_m_min"), 6);
  EXPECT_EQ(settings.number("max_feed_override"), 1.5);
  EXPECT_EQ(source(imported, "max_linear_velocity_m_min"),
            "mill.ini, line 11: [TRAJ] MAX_LINEAR_VELOCITY = 100 mm/s");
  EXPECT_EQ(source(imported, "planner"), "assumed: mill.ini does not tell the release of LinuxCNC");
}

TEST_F(LinuxCncIni, ReadsTolerancesOfTheStartUpCode) {
  const auto with = [](const std::string& entry) {
    return import(changed("[EMCMOT]", "[RS274NGC]\n" + entry + "\n[EMCMOT]"), "mill.ini");
  };
  const ImportedMachine q = with("RS274NGC_STARTUP_CODE = G20 G64 P0.001 Q0.002");
  EXPECT_NEAR(q.machine.settings.number("naive_tolerance_mm"), 0.0508, 1e-12);
  EXPECT_EQ(q.machine.settings.number("blend_tolerance_mm"), 0);
  EXPECT_EQ(q.machine.settings.text("blend_mode"), "G64");
  EXPECT_THAT(notes(q, "mill.ini"),
              HasSubstr("mill.ini:5: warning: P of G64 in the start-up code has no effect on blends"));
  EXPECT_EQ(with("RS274NGC_STARTUP_CODE = g21g64p0.02").machine.settings.number("naive_tolerance_mm"), 0.02);
  EXPECT_EQ(with("RS274NGC_STARTUP_CODE = G21 G61").machine.settings.text("blend_mode"), "G61");
  EXPECT_EQ(with("RS274NGC_STARTUP_CODE = G21 G61.1").machine.settings.text("blend_mode"), "G61.1");
  const ImportedMachine usual = with("G64_DEFAULT_TOLERANCE = 0.03\nG64_DEFAULT_NAIVETOLERANCE = 0.01");
  EXPECT_EQ(usual.machine.settings.number("blend_tolerance_mm"), 0.03);
  EXPECT_EQ(usual.machine.settings.number("naive_tolerance_mm"), 0.01);
  EXPECT_THAT(notes(with("RS274NGC_STARTUP_CODE = G64 P0.0.2"), "mill.ini"),
              HasSubstr("'0.0.2' is not a number"));
}

TEST_F(LinuxCncIni, ConvertsInches) {
  for (const std::string unit : {"inch", "in", "Imperial", "0.03937007874015748"}) {
    const ImportedMachine imported = import(changed("LINEAR_UNITS = mm", "LINEAR_UNITS = " + unit), "a.ini");
    EXPECT_NEAR(imported.machine.axes[0].velocity, 80 * 25.4, 1e-6) << unit;
    EXPECT_NEAR(imported.machine.axes[1].acceleration, 400 * 25.4, 1e-6) << unit;
  }
}

TEST_F(LinuxCncIni, SaysWhichUnitItAssumes) {
  EXPECT_THAT(notes(import(changed("LINEAR_UNITS = mm\n", ""), "a.ini"), "a.ini"),
              HasSubstr("a.ini:6: warning: [TRAJ] LINEAR_UNITS is missing; mm is assumed"));
  const ImportedMachine wrong = import(changed("LINEAR_UNITS = mm", "LINEAR_UNITS = furlong"), "a.ini");
  EXPECT_THAT(notes(wrong, "a.ini"),
              HasSubstr("a.ini:8: error: [TRAJ] LINEAR_UNITS = furlong: 'furlong' is not"));
  EXPECT_THAT(notes(import(changed("LINEAR_UNITS = mm", "LINEAR_UNITS = 0"), "a.ini"), "a.ini"),
              HasSubstr("LINEAR_UNITS = 0 is not a unit"));
}

TEST_F(LinuxCncIni, ReadsIncludedFilesAndNamesThem) {
  write("axes/x.inc", "[AXIS_X]\nMAX_VELOCITY = 80\nMAX_ACCELERATION = fast\n");
  write("mill.ini", "[EMC]\nMACHINE = a\n#INCLUDE axes/x.inc\n[TRAJ]\nLINEAR_UNITS = mm\n");
  const ImportedMachine imported = import_file("mill.ini");
  EXPECT_EQ(source(imported, "X.velocity"), "axes/x.inc, line 2: [AXIS_X] MAX_VELOCITY = 80 mm/s");
  EXPECT_THAT(
      notes(imported, "mill.ini"),
      HasSubstr("axes/x.inc:3: error: [AXIS_X] MAX_ACCELERATION = fast mm/s2: 'fast' is not a number"));
  EXPECT_THAT(source(imported, "X.acceleration"), StartsWith("assumed: "));
}

TEST_F(LinuxCncIni, ReportsFilesThatCannotBeIncluded) {
  write("mill.ini", "[EMC]\n#INCLUDE none.inc\n#INCLUDE loop.inc\n#INCLUDE\n[TRAJ]\n");
  write("loop.inc", "#include loop.inc\n");
  const std::string text = notes(import_file("mill.ini"), "mill.ini");
  EXPECT_THAT(text, HasSubstr("mill.ini:2: error: 'none.inc' cannot be included: cannot read"));
  EXPECT_THAT(text, HasSubstr("loop.inc:1: error: 'loop.inc' cannot be included: it includes itself"));
  EXPECT_THAT(text, HasSubstr("mill.ini:4: error: '' cannot be included: no file is named"));
}

TEST_F(LinuxCncIni, ReadsSectionsOfOldReleases) {
  std::string text = mill_ini;
  for (const auto& [from, to] : {std::pair("[AXIS_X]", "[AXIS_0]"), std::pair("[AXIS_Y]", "[AXIS_1]"),
                                 std::pair("[AXIS_Z]", "[AXIS_2]")}) {
    text = changed(from, to, text);
  }
  const ImportedMachine imported = import(text, "old.ini");
  EXPECT_NEAR(imported.machine.axes[1].velocity, 70, 1e-9);
  EXPECT_EQ(source(imported, "Y.velocity"), "old.ini, line 20: [AXIS_1] MAX_VELOCITY = 70 mm/s");
}

TEST_F(LinuxCncIni, AssumesTheJointWhereTheAxisGivesNothing) {
  const ImportedMachine imported = import(changed("MAX_VELOCITY = 70\n", ""), "mill.ini");
  EXPECT_NEAR(imported.machine.axes[1].velocity, 90, 1e-9);
  EXPECT_EQ(source(imported, "Y.velocity"),
            "assumed: [AXIS_Y] gives none: as mill.ini, line 22: [JOINT_1] MAX_VELOCITY = 90 mm/s");
  EXPECT_THAT(
      notes(imported, "mill.ini"),
      HasSubstr("mill.ini:19: warning: [AXIS_Y] gives no MAX_VELOCITY; that of [JOINT_1] is assumed"));
}

TEST_F(LinuxCncIni, TakesTheJointsOfAGantryFromTheKinematics) {
  std::string text = changed("KINEMATICS = trivkins", "KINEMATICS = trivkins coordinates=xyyz kinstype=BOTH");
  text = changed("[JOINT_2]\nMAX_VELOCITY = 60", "[JOINT_2]\nMAX_VELOCITY = 65", text);
  const std::string said = notes(import(text, "mill.ini"), "mill.ini");
  EXPECT_THAT(said,
              HasSubstr("mill.ini:20: warning: [AXIS_Y] MAX_VELOCITY = 70 exceeds [JOINT_2] MAX_VELOCITY = "
                        "65 (mill.ini, line 29); the planner uses 70"));
}

TEST_F(LinuxCncIni, ReportsContradictoryLimits) {
  EXPECT_THAT(
      notes(import(changed("MAX_VELOCITY = 90", "MAX_VELOCITY = 75"), "mill.ini"), "mill.ini"),
      HasSubstr("mill.ini:14: warning: [AXIS_X] MAX_VELOCITY = 80 exceeds [JOINT_0] MAX_VELOCITY = 75 "
                "(mill.ini, line 17); the planner uses 80 [limits-contradict]"));
  EXPECT_THAT(
      notes(import(changed("[JOINT_0]\n", "[JOINT_0]\nSTEPGEN_MAXACCEL = 499\n"), "mill.ini"), "mill.ini"),
      HasSubstr("mill.ini:15: warning: [AXIS_X] MAX_ACCELERATION = 500 exceeds [JOINT_0] STEPGEN_MAXACCEL"));
  const ImportedMachine twice = import(changed("[JOINT_0]", "MAX_VELOCITY = 40\n[JOINT_0]"), "mill.ini");
  EXPECT_THAT(notes(twice, "mill.ini"),
              HasSubstr("mill.ini:16: warning: [AXIS_X] MAX_VELOCITY = 40, but 80 in "
                        "mill.ini, line 14; 80 is used [given-twice]"));
  EXPECT_NEAR(twice.machine.axes[0].velocity, 80, 1e-9);
}

TEST_F(LinuxCncIni, DoesNotUseValuesOutOfBounds) {
  for (const std::string value : {"0", "-5", "1e300", "nan", "1,2,3"}) {
    const ImportedMachine imported =
        import(changed("MAX_VELOCITY = 80", "MAX_VELOCITY = " + value), "mill.ini");
    EXPECT_TRUE(has_errors(imported.notes)) << value;
    EXPECT_THAT(notes(imported, "mill.ini"),
                HasSubstr("mill.ini:14: error: [AXIS_X] MAX_VELOCITY = " + value));
    EXPECT_EQ(source(imported, "X.velocity"), "assumed: mill.ini does not give it: as Y") << value;
  }
}

TEST_F(LinuxCncIni, NotesAxesKinematicsAndMisspeltKeys) {
  EXPECT_THAT(notes(import(changed("X Y Z", "X Y Z A"), "a.ini"), "a.ini"),
              HasSubstr("a.ini:7: info: axis A is not part of the simulation; skipped"));
  EXPECT_THAT(notes(import(changed("= trivkins", "= genhexkins"), "a.ini"), "a.ini"),
              HasSubstr("a.ini:11: warning: kinematics genhexkins is not modelled"));
  EXPECT_THAT(
      notes(import(changed("MAX_ACCELERATION = 500", "MAX_ACCELERATON = 500"), "a.ini"), "a.ini"),
      HasSubstr("a.ini:15: warning: [AXIS_X] MAX_ACCELERATON is not known; skipped [not-understood] (did you "
                "mean 'MAX_ACCELERATION'?)"));
  EXPECT_THAT(notes(import(changed("[KINS]", "[KINS]\nsome words"), "a.ini"), "a.ini"),
              HasSubstr("a.ini:11: warning: 'some words' is neither a section nor a value; skipped"));
  EXPECT_THAT(notes(import(changed("[TRAJ]", "[TRAJ]\nARC_BLEND_ENABLE = 0"), "a.ini"), "a.ini"),
              HasSubstr("a.ini:7: warning: [TRAJ] ARC_BLEND_ENABLE = 0 is not modelled"));
}

TEST_F(LinuxCncIni, OfALatheAssumesTheAxisThatItHasNot) {
  std::string text = changed("COORDINATES = X Y Z", "COORDINATES = X Z");
  text = text.substr(0, text.find("[AXIS_Y]")) + text.substr(text.find("[AXIS_Z]"));
  const ImportedMachine imported = import(text, "lathe.ini");
  EXPECT_EQ(source(imported, "Y.velocity"), "assumed: lathe.ini does not give it: as X");
  EXPECT_THAT(notes(imported, "lathe.ini"), Not(HasSubstr("axis Y")));
}

TEST_F(LinuxCncIni, OfTheCompleteControlIsUnderstoodWhole) {
  const std::filesystem::path file =
      std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "linuxcnc" / "t.ini";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no " << file;
  }
  const ImportedMachine imported = checked(import_machine(file, specs()));
  EXPECT_NEAR(imported.machine.axes[0].velocity, 166.666667, 1e-9);
  EXPECT_NEAR(imported.machine.axes[2].velocity, 83.333333, 1e-9);
  EXPECT_NEAR(imported.machine.axes[2].acceleration, 400, 1e-9);
  // On what is not used, and on G64 P in the start-up code.
  EXPECT_EQ(imported.notes.size(), 2U) << notes(imported, "t.ini");
}

}  // namespace
}  // namespace feedscope
