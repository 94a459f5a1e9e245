#include "core/machine/import/linuxcnc_kinematics.h"

#include <fmt/format.h>

#include "core/base/units.h"
#include "tests/core/machine/import/import_fixture.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double deg = units::pi / 180;

constexpr const char* table_ini = R"([EMC]
MACHINE = Table
[KINS]
KINEMATICS = xyzac-trt-kins sparm=identityfirst
JOINTS = 5
[HAL]
HALCMD = net :y-offset xyzac-trt-kins.y-offset gui.y-offset
HALCMD = sets :y-offset 20
HALCMD = setp xyzac-trt-kins.z-offset 10
HALCMD = setp xyzac-trt-kins.z-rot-point -320
[EMCMOT]
SERVO_PERIOD = 1000000
[TRAJ]
COORDINATES = XYZAC
LINEAR_UNITS = mm
MAX_LINEAR_VELOCITY = 35
[AXIS_X]
MAX_VELOCITY = 20
MAX_ACCELERATION = 300
[AXIS_Y]
MAX_VELOCITY = 20
MAX_ACCELERATION = 300
[AXIS_Z]
MAX_VELOCITY = 20
MAX_ACCELERATION = 300
[AXIS_A]
MIN_LIMIT = -100
MAX_LIMIT = 50
MAX_VELOCITY = 30
MAX_ACCELERATION = 300
[AXIS_C]
MAX_VELOCITY = 90
MAX_ACCELERATION = 600
)";

class LinuxCncKinematicsTest : public test::ImportTest {};

TEST_F(LinuxCncKinematicsTest, OfATiltingTableAreImportedWithFileAndLine) {
  const ImportedMachine imported = import(table_ini, "table.ini");
  const MachineKinematics& kinematics = imported.machine.kinematics;
  EXPECT_EQ(kinematics.chain, "C A X Y frame Z");
  const RotaryAxis& a = *kinematics.find('A');
  EXPECT_NEAR(a.velocity, 30 * deg, 1e-12);
  EXPECT_NEAR(a.acceleration, 300 * deg, 1e-12);
  EXPECT_NEAR(a.minimum.value(), -100 * deg, 1e-12);
  EXPECT_NEAR(a.maximum.value(), 50 * deg, 1e-12);
  EXPECT_EQ(a.direction, Vec3(-1, 0, 0)) << "LinuxCNC counts how the table turns";
  EXPECT_EQ(a.point, Vec3(0, 20, -310));
  const RotaryAxis& c = *kinematics.find('C');
  EXPECT_FALSE(c.minimum);
  EXPECT_EQ(c.direction, Vec3(0, 0, -1));
  EXPECT_EQ(c.point, Vec3(0, 0, -320));
  EXPECT_EQ(source(imported, "A.velocity"), "table.ini, line 29: [AXIS_A] MAX_VELOCITY = 30 deg/s");
  EXPECT_THAT(source(imported, "kinematics.A.point"), HasSubstr("line 8: xyzac-trt-kins y-offset = 20 mm"));
  EXPECT_EQ(notes(imported, "table.ini"), "table.ini: info: not used: [KINS] JOINTS, [HAL] [not-used]\n");
}

/// With A at 30 degrees the table has turned its Y upwards: the tool leans towards +Y of the part.
TEST_F(LinuxCncKinematicsTest, TurnTheToolAsTheControlCounts) {
  const KinematicChain chain = chain_of(import(table_ini, "table.ini").machine.kinematics);
  std::vector<double> places(chain.size(), 0);
  for (const std::size_t k : chain.rotary()) {
    places[k] = chain.axes()[k].name == 'A' ? 30 * deg : 0;
  }
  EXPECT_LT((chain.pose(places, 0).direction - Vec3(0, 0.5, std::sqrt(0.75))).norm(), 1e-12);
}

TEST_F(LinuxCncKinematicsTest, TurnTheOtherWayWhereTheConfigurationAsksForIt) {
  for (const char* on : {"1", "true", "TRUE"}) {
    const ImportedMachine imported =
        import(replaced(table_ini, "HALCMD = setp xyzac-trt-kins.z-offset 10\n",
                        fmt::format("HALCMD = setp xyzac-trt-kins.conventional-directions {}\n", on)),
               "table.ini");
    EXPECT_EQ(imported.machine.kinematics.find('A')->direction, Vec3(1, 0, 0)) << on;
    EXPECT_EQ(imported.machine.kinematics.find('C')->direction, Vec3(0, 0, 1)) << on;
  }
}

TEST_F(LinuxCncKinematicsTest, OfATableThatTiltsAboutYAndInInches) {
  std::string text = replaced(table_ini, "xyzac-trt-kins sparm", "xyzbc-trt-kins sparm");
  text = replaced(text, "xyzac-trt-kins.y-offset", "xyzbc-trt-kins.x-offset");
  text = replaced(text, "xyzac-trt-kins.z-offset", "xyzbc-trt-kins.z-offset");
  text = replaced(text, "xyzac-trt-kins.z-rot", "xyzbc-trt-kins.z-rot");
  text = replaced(text, "COORDINATES = XYZAC", "COORDINATES = XYZBC");
  text = replaced(text, "[AXIS_A]", "[AXIS_B]");
  text = replaced(text, "LINEAR_UNITS = mm", "LINEAR_UNITS = inch");
  const ImportedMachine imported = import(text, "table.ini");
  EXPECT_EQ(imported.machine.kinematics.chain, "C B X Y frame Z");
  const RotaryAxis& b = *imported.machine.kinematics.find('B');
  EXPECT_EQ(b.direction, Vec3(0, -1, 0));
  EXPECT_LT((b.point - 25.4 * Vec3(20, 0, -310)).norm(), 1e-9);
}

TEST_F(LinuxCncKinematicsTest, SayWhatIsNotInTheFile) {
  std::string text = replaced(table_ini, "HALCMD = sets :y-offset 20\n", "");
  text = replaced(text, "HALCMD = setp xyzac-trt-kins.z-offset 10\n", "");
  text = replaced(text, "HALCMD = setp xyzac-trt-kins.z-rot-point -320\n", "");
  text = replaced(text, "MAX_VELOCITY = 90\n", "");
  const ImportedMachine imported = import(text, "table.ini");
  EXPECT_THAT(notes(imported, "table.ini"),
              HasSubstr("the offsets of xyzac-trt-kins are not in the INI file"));
  EXPECT_THAT(notes(imported, "table.ini"), HasSubstr("MAX_VELOCITY of axis C is missing"));
  EXPECT_NEAR(imported.machine.kinematics.find('C')->velocity, 60 * deg, 1e-12);
  const ImportedMachine other =
      import(replaced(table_ini, "xyzac-trt-kins sparm", "5axiskins sparm"), "t.ini");
  EXPECT_TRUE(other.machine.kinematics.empty());
  EXPECT_THAT(notes(other, "t.ini"), HasSubstr("kinematics 5axiskins sparm=identityfirst is not modelled"));
}

}  // namespace
}  // namespace feedscope
