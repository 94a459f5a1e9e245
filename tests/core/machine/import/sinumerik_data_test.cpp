#include "tests/core/machine/import/import_fixture.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* tea_file = R"(%_N_NC_TEA
;$PATH=/_N_NC_ACT_DIR
CHANDATA(1)
N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]="X1"
N10000 $MN_AXCONF_MACHAX_NAME_TAB[1]="Z1"
N10000 $MN_AXCONF_MACHAX_NAME_TAB[2]="Y1"
N10071 $MN_IPO_CYCLE_TIME=0.002
N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[0]=1
N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[1]=2
N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[2]=3
N20060 $MC_AXCONF_GEOAX_NAME_TAB[0]="X"
N20060 $MC_AXCONF_GEOAX_NAME_TAB[1]="Y"
N20060 $MC_AXCONF_GEOAX_NAME_TAB[2]="Z"
N20070 $MC_AXCONF_MACHAX_USED[0]=1
N20070 $MC_AXCONF_MACHAX_USED[1]=3
N20070 $MC_AXCONF_MACHAX_USED[2]=2
N20170 $MC_COMPRESS_BLOCK_PATH_LIMIT=20
N20600 $MC_MAX_PATH_JERK[0]=40
N29000 $MC_LOOKAH_NUM_CHECKED_BLOCKS=150
N32000 $MA_MAX_AX_VELO[AX1]=30000 ;mm/min
N32000 $MA_MAX_AX_VELO[AX2]=20000
N32000 $MA_MAX_AX_VELO[AX3]=25000
N32300 $MA_MAX_AX_ACCEL[0,AX1]=4
N32300 $MA_MAX_AX_ACCEL[4,AX1]=2.5
N32300 $MA_MAX_AX_ACCEL[0,AX2]=3
N32300 $MA_MAX_AX_ACCEL[0,AX3]=3.5
N32431 $MA_MAX_AX_JERK[0,AX1]=60
N32431 $MA_MAX_AX_JERK[0,AX2]=50
N32431 $MA_MAX_AX_JERK[0,AX3]=55
N32200 $MA_POSCTRL_GAIN[0,AX1]=3
N32610 $MA_VELO_FFW_WEIGHT[0,AX1]=1
N32810 $MA_EQUIV_SPEEDCTRL_TIME[0,AX1]=0.004
M17
)";

class SinumerikData : public test::ImportTest {
 protected:
  static std::string changed(const std::string& from, const std::string& to,
                             const std::string& text = tea_file) {
    return replaced(text, from, to);
  }
};

TEST_F(SinumerikData, GivesLimitsByTheAxesOfTheChannel) {
  const ImportedMachine imported = import(tea_file, "nc.tea");
  const Machine& machine = imported.machine;
  EXPECT_EQ(imported.kind, "machine data of a Sinumerik");
  EXPECT_EQ(machine.model, "essid");
  EXPECT_NEAR(machine.axes[0].velocity, 500, 1e-9);
  EXPECT_NEAR(machine.axes[1].velocity, 25000.0 / 60, 1e-9);  // machine axis 3
  EXPECT_NEAR(machine.axes[2].velocity, 20000.0 / 60, 1e-9);
  EXPECT_NEAR(machine.axes[0].acceleration, 4000, 1e-9);
  EXPECT_NEAR(machine.axes[1].jerk, 55000, 1e-9);
  EXPECT_EQ(source(imported, "Y.velocity"), "nc.tea, line 22: $MA_MAX_AX_VELO[AX3] = 25000 mm/min");
  EXPECT_EQ(source(imported, "X.jerk"), "nc.tea, line 27: $MA_MAX_AX_JERK[0,AX1] = 60 m/s3");
  EXPECT_EQ(source(imported, "X.blend_jerk"), "assumed: as the jerk: nc.tea gives none for blends");
}

TEST_F(SinumerikData, GivesSettingsAndDrives) {
  const ImportedMachine imported = import(tea_file, "nc.tea");
  const Settings& settings = imported.machine.settings;
  EXPECT_EQ(settings.number("interpolation_period_s"), 0.002);
  EXPECT_EQ(settings.number("lookahead_blocks"), 150);
  EXPECT_EQ(settings.number("compressor_block_mm"), 20);
  EXPECT_EQ(settings.number("curvilinear_jerk_m_s3"), 40);
  const AxisDrive& drive = imported.machine.drives[0];
  EXPECT_NEAR(*drive.gain, 50, 1e-12);  // 3 m/min over 1 mm
  EXPECT_EQ(drive.feedforward, 1);
  EXPECT_NEAR(*drive.lag, 0.004, 1e-15);
  EXPECT_TRUE(imported.machine.drives[1].follows_exactly());
}

TEST_F(SinumerikData, UsesDynnormAndTellsOtherModes) {
  EXPECT_THAT(
      notes(import(tea_file, "nc.tea"), "nc.tea"),
      HasSubstr(
          "nc.tea:24: info: $MA_MAX_AX_ACCEL[4,AX1] = 2.5 holds with DYNFINISH; the value of DYNNORM, 4, "
          "is used"));
}

TEST_F(SinumerikData, AssumesTheOrderOfAxesWithoutTables) {
  const ImportedMachine imported =
      import("$MA_MAX_AX_VELO[X1]=12000\nN32300 $MA_MAX_AX_ACCEL[AX2]=2\n", "a.txt");
  EXPECT_NEAR(imported.machine.axes[0].velocity, 200, 1e-9);
  EXPECT_NEAR(imported.machine.axes[1].acceleration, 2000, 1e-9);
  EXPECT_EQ(source(imported, "X.acceleration"), "assumed: a.txt does not give it: as Y");
  EXPECT_THAT(source(imported, "X.jerk"), StartsWith("assumed: a.txt does not give it: usual"));
  EXPECT_THAT(notes(imported, "a.txt"), HasSubstr("AX1, AX2 and AX3 are assumed"));
}

TEST_F(SinumerikData, SkipsRotaryAxesAndInchSystems) {
  EXPECT_THAT(notes(import(changed("M17", "N30300 $MA_IS_ROT_AX[AX3]=TRUE\nM17"), "a.txt"), "a.txt"),
              HasSubstr("a.txt:33: warning: machine axis AX3 would be Y but is a rotary axis"));
  const ImportedMachine inch =
      import(changed("CHANDATA(1)", "N10240 $MN_SCALING_SYSTEM_IS_METRIC=0"), "a.txt");
  EXPECT_THAT(notes(inch, "a.txt"), HasSubstr("a.txt:3: error: the basic system is inch"));
  EXPECT_THAT(source(inch, "X.velocity"), StartsWith("assumed: "));
}

TEST_F(SinumerikData, ReportsContradictionsAndBadLines) {
  EXPECT_THAT(
      notes(import(changed("M17", "N32000 $MA_MAX_AX_VELO[AX1]=8000\nM17"), "a.txt"), "a.txt"),
      HasSubstr("a.txt:33: warning: $MA_MAX_AX_VELO[AX1] = 8000, but 30000 in a.txt, line 20; 8000 is used"));
  const std::string said =
      notes(import(changed("CHANDATA(1)", "hello", changed("[AX1]=30000", "[AX1]=-1")), "a.txt"), "a.txt");
  EXPECT_THAT(said, HasSubstr("a.txt:3: info: 'hello' is no machine datum; skipped"));
  EXPECT_THAT(said, HasSubstr("a.txt:20: error: $MA_MAX_AX_VELO[AX1] = -1 mm/min cannot be used"));
}

}  // namespace
}  // namespace feedscope
