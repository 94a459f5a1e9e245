#include "tests/core/machine/import/import_fixture.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* fanuc_listing = R"(%
N00000P00000010
N01001P00000000
N01020A1P88A2P89A3P90A4P65
N01420A1P36000.A2P36000.A3P24000.A4P12000.
N01432A1P20000.A2P40000.A3P24000.A4P0
N01660A1P3000.A2P3000.A3P2500.A4P100.
N01772P50
N01825A1P5000A2P5000A3P4000A4P3000
%
)";

constexpr const char* tnc_listing = R"(;machine parameters
MP1010.0 : 30000 ;rapid traverse X
MP1010.1 : 30000
MP1010.2 : 20000
MP1060.0 : 3.5
MP1060.1 : 3
MP1060.2 : 2.5
MP1085.0 : 50
MP1085.1 : 0
MP1090.0 : 35
MP1061.0 : 5
MP7230 : 0
)";

class NumberedParametersTest : public test::ImportTest {};

TEST_F(NumberedParametersTest, OfAFanucGiveLimitsByNumberAndAxis) {
  const ImportedMachine imported = import(fanuc_listing, "param.txt");
  const Machine& machine = imported.machine;
  EXPECT_EQ(imported.kind, "parameters of a Fanuc");
  EXPECT_NEAR(machine.axes[0].velocity, 600, 1e-9);
  EXPECT_NEAR(machine.axes[2].acceleration, 2500, 1e-9);
  EXPECT_NEAR(machine.axes[2].jerk, 2500 / 0.05, 1e-6);
  EXPECT_NEAR(*machine.drives[2].gain, 40, 1e-12);
  EXPECT_EQ(source(imported, "Z.velocity"), "param.txt, line 5: N1420 A3 P24000. mm/min");
  EXPECT_EQ(source(imported, "Z.jerk"),
            "param.txt, line 8: N1772 P50 ms, in which the acceleration is reached");
  EXPECT_EQ(machine.settings.number("cutting_feed_x_m_min"), 20);
  EXPECT_EQ(source(imported, "cutting_feed_x_m_min"), "param.txt, line 6: N1432 A1 P20000. mm/min");
}

/// 1432 is the cutting feed under look-ahead control, and where it is 0 that of 1430.
TEST_F(NumberedParametersTest, OfAFanucGiveTheCuttingFeed) {
  const auto of = [](const std::string& lines) {
    return import("N1420A1P30000A2P28000A3P20000\nN1660A1P2500A2P2500A3P2500\n" + lines, "a.txt");
  };
  const ImportedMachine plain = of("N1430A1P12000A2P11000A3P9000\nN1432A1P0A2P10000\n");
  EXPECT_EQ(plain.machine.settings.number("cutting_feed_x_m_min"), 12);
  EXPECT_EQ(plain.machine.settings.number("cutting_feed_y_m_min"), 10);
  EXPECT_EQ(plain.machine.settings.number("cutting_feed_z_m_min"), 9);
  EXPECT_THAT(
      notes(plain, "a.txt"),
      HasSubstr(
          "a.txt:3: info: N1430 A2 P11000 is the cutting feed without look-ahead control; that with it, "
          "N1432 A2 P10000, is used"));
  EXPECT_FALSE(of("N1430A1P0\n").machine.settings.has("cutting_feed_x_m_min"));
}

TEST_F(NumberedParametersTest, ListAllThatIsNotUsed) {
  const std::string fanuc =
      notes(import("N1420A1P30000A2P28000A3P20000\nN1660A1P2500A2P2500A3P2500\nN1622A1P50\n"
                   "N1783A1P200.\nN1732P525.\nN1424A1P0\nN6711P3\nN1424A2P0\n",
                   "a.txt"),
            "a.txt");
  EXPECT_THAT(
      fanuc,
      HasSubstr(
          "a.txt:3: info: N1622A1P50 (time constant of cutting feeds after interpolation) is not modelled"));
  EXPECT_THAT(fanuc, HasSubstr("a.txt:4: info: N1783A1P200. (difference of feeds"));
  EXPECT_THAT(fanuc, HasSubstr("a.txt:5: info: N1732P525. (feed below which arcs"));
  EXPECT_THAT(fanuc, HasSubstr("info: not used: N1424, N6711 [not-used]"));
  EXPECT_THAT(notes(import(std::string(tnc_listing) + "MP7440 : 5\n", "tnc.mp"), "tnc.mp"),
              HasSubstr("not used: MP7230, MP7440"));
}

TEST_F(NumberedParametersTest, OfAFanucFollowTheNamesOfTheAxes) {
  const ImportedMachine lathe =
      import(replaced(fanuc_listing, "A1P88A2P89A3P90", "A1P88A2P90A3P67"), "a.txt");
  EXPECT_EQ(source(lathe, "Z.velocity"), "a.txt, line 5: N1420 A2 P36000. mm/min");
  EXPECT_THAT(notes(lathe, "a.txt"), HasSubstr("there is no linear axis Y; its limits are assumed"));
  const ImportedMachine bare = import("N1420 A1 P24000 A2 P24000 A3 P20000\nN1660 A1 P0\n", "a.txt");
  EXPECT_NEAR(bare.machine.axes[2].velocity, 20000.0 / 60, 1e-9);
  EXPECT_THAT(notes(bare, "a.txt"), HasSubstr("the first three are assumed"));
  EXPECT_THAT(notes(bare, "a.txt"), HasSubstr("a.txt:2: error: N1660 A1 P0 mm/s2 cannot be used"));
}

TEST_F(NumberedParametersTest, OfAFanucInInchesAreNotUsed) {
  const ImportedMachine inch = import(replaced(fanuc_listing, "P00000000", "P00000001"), "a.txt");
  EXPECT_THAT(notes(inch, "a.txt"), HasSubstr("a.txt:3: error: the machine measures in inches"));
  EXPECT_THAT(source(inch, "X.velocity"), StartsWith("assumed: "));
}

TEST_F(NumberedParametersTest, OfAHeidenhainGiveLimitsByIndex) {
  const ImportedMachine imported = import(tnc_listing, "tnc.mp");
  const Machine& machine = imported.machine;
  EXPECT_EQ(imported.kind, "machine parameters of a Heidenhain");
  EXPECT_EQ(machine.model, "ward");
  EXPECT_NEAR(machine.axes[2].velocity, 20000.0 / 60, 1e-9);
  EXPECT_NEAR(machine.axes[1].acceleration, 3000, 1e-9);
  EXPECT_EQ(source(imported, "X.velocity"), "tnc.mp, line 2: MP1010.0 = 30000 mm/min");
  // The jerk of the path is the largest of all axes, and holds where an axis gives none.
  EXPECT_EQ(source(imported, "X.jerk"), "tnc.mp, line 10: MP1090.0 = 35 m/s3");
  EXPECT_EQ(source(imported, "Y.jerk"), "tnc.mp, line 10: MP1090.0 = 35 m/s3");
  EXPECT_THAT(notes(imported, "tnc.mp"), HasSubstr("tnc.mp:11: info: the acceleration along the path"));
}

TEST_F(NumberedParametersTest, ReportContradictionsAndBadLines) {
  EXPECT_THAT(
      notes(import(std::string(fanuc_listing) + "N01420A1P100.\nhello\n", "a.txt"), "a.txt"),
      testing::AllOf(HasSubstr("a.txt:11: warning: N1420 A1 P100., but 36000 in a.txt, line 5; 100 is used"),
                     HasSubstr("a.txt:12: info: 'hello' is not a parameter; it is skipped")));
  EXPECT_THAT(
      notes(import(std::string(tnc_listing) + "MP1060.0 : fast\nMP1010.1 : 5\n!!\n", "a.txt"), "a.txt"),
      testing::AllOf(HasSubstr("a.txt:13: error: MP1060.0 = fast: 'fast' is not a number"),
                     HasSubstr("a.txt:14: warning: MP1010.1 = 5, but 30000 in a.txt, line 3; 5 is used"),
                     HasSubstr("a.txt:15: info: '!!' is not a machine parameter; it is skipped")));
}

}  // namespace
}  // namespace feedscope
