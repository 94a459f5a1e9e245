#include "core/base/error.h"
#include "tests/core/machine/import/import_fixture.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* grbl_settings = R"($0=10
$1=25
$11=0.020
$12=0.004
$100=80.000
$101=80.000
$102=400.000
$110=5000.000
$111=4000.000
$112=600.000
$120=400.000
$121=300.000
$122=50.000
$130=300.000
ok
)";

class GrblListing : public test::ImportTest {
 protected:
  static std::string changed(const std::string& from, const std::string& to,
                             const std::string& text = grbl_settings) {
    return replaced(text, from, to);
  }
};

TEST_F(GrblListing, GivesLimitsStepsAndSettingsWithLines) {
  const ImportedMachine imported = import(grbl_settings, "router.txt");
  const Machine& machine = imported.machine;
  EXPECT_EQ(machine.model, "grbl");
  EXPECT_EQ(machine.control, "grbl 1.1");
  EXPECT_NEAR(machine.axes[0].velocity, 5000.0 / 60, 1e-9);
  EXPECT_NEAR(machine.axes[2].velocity, 10, 1e-9);
  EXPECT_NEAR(machine.axes[1].acceleration, 300, 1e-9);
  EXPECT_EQ(machine.drives[2].steps_per_mm, 400);
  EXPECT_EQ(machine.settings.number("junction_deviation_mm"), 0.02);
  EXPECT_EQ(machine.settings.number("arc_tolerance_mm"), 0.004);
  EXPECT_EQ(machine.settings.number("idle_delay_ms"), 25);
  EXPECT_EQ(machine.settings.number("buffer_blocks"), 15);
  EXPECT_EQ(source(imported, "Y.velocity"), "router.txt, line 9: $111 = 4000.000 mm/min");
  EXPECT_EQ(source(imported, "junction_deviation_mm"), "router.txt, line 3: $11 = 0.020");
  EXPECT_THAT(source(imported, "buffer_blocks"), StartsWith("assumed: planner buffer of grbl"));
  EXPECT_EQ(notes(imported, "router.txt"), "router.txt: info: not used: $0, $130 [not-used]\n");
}

TEST_F(GrblListing, ReadsCommentsAndWhatSendersWrite) {
  std::string text = "Grbl 1.1h ['$' for help]\r\n>>> $$\r\n";
  text += changed("$110=5000.000", "Recv: $110 = 5000.000 (x max rate, mm/min)");
  const ImportedMachine imported = import(text, "router.txt");
  EXPECT_NEAR(imported.machine.axes[0].velocity, 5000.0 / 60, 1e-9);
  EXPECT_EQ(notes(imported, "router.txt"), "router.txt: info: not used: $0, $130 [not-used]\n");
  EXPECT_THAT(notes(import(changed("ok", "hello"), "a.txt"), "a.txt"),
              HasSubstr("a.txt:15: info: 'hello' is not a setting; it is skipped"));
}

TEST_F(GrblListing, NeverReleasedMotorsCostNoTime) {
  EXPECT_EQ(import(changed("$1=25", "$1=255"), "a.txt").machine.settings.number("idle_delay_ms"), 0);
}

TEST_F(GrblListing, ReadsTheBufferThatTheControlTells) {
  const std::string text = std::string(grbl_settings) + "[VER:1.1h.20190825:]\n[OPT:VN,14,128]\n";
  const ImportedMachine imported = import(text, "a.txt");
  EXPECT_EQ(imported.machine.settings.number("buffer_blocks"), 14);
  EXPECT_THAT(source(imported, "buffer_blocks"), StartsWith("a.txt, line 17: [OPT:VN,14,128]"));
}

TEST_F(GrblListing, OfGrblHalSkipsWhatNoModelUses) {
  const std::string text = "GrblHAL 1.1f ['$' or '$HELP' for help]\n" + std::string(grbl_settings) +
                           "$103=26.667\n$123=10\n$341=0\n$398=100\n$481=0\n";
  const ImportedMachine imported = import(text, "hal.txt");
  EXPECT_EQ(imported.machine.control, "grblHAL");
  EXPECT_EQ(imported.machine.settings.number("buffer_blocks"), 100);
  const std::string said = notes(imported, "hal.txt");
  EXPECT_THAT(said, HasSubstr("hal.txt:17: info: axes other than X, Y and Z"));
  EXPECT_THAT(said, HasSubstr("hal.txt:19: info: a setting that no model here uses; skipped"));
  EXPECT_THAT(said, HasSubstr("grblHAL is simulated as grbl"));
  EXPECT_FALSE(has_errors(imported.notes));
}

TEST_F(GrblListing, ReadsPathsOfFluidNc) {
  const ImportedMachine imported = import(
      "[VER:3.7 FluidNC v3.7.8:]\n$/axes/x/steps_per_mm=80.000\n$/axes/x/max_rate_mm_per_min=6000.000\n"
      "$/axes/y/acceleration_mm_per_sec2=250\n$/axes/a/steps_per_mm=3\n$/axes/x/homing/cycle=2\n",
      "fluid.txt");
  EXPECT_EQ(imported.machine.control, "FluidNC");
  EXPECT_NEAR(imported.machine.axes[0].velocity, 100, 1e-9);
  EXPECT_NEAR(imported.machine.axes[1].acceleration, 250, 1e-9);
  EXPECT_EQ(source(imported, "X.acceleration"), "assumed: fluid.txt does not give it: as Y");
}

TEST_F(GrblListing, ReportsContradictionsAndBadNumbers) {
  const ImportedMachine twice = import(std::string(grbl_settings) + "$110=100\n", "a.txt");
  EXPECT_THAT(notes(twice, "a.txt"),
              HasSubstr("a.txt:16: warning: $110 = 100, but 5000.000 in a.txt, line 8; 100 is "
                        "used"));
  EXPECT_NEAR(twice.machine.axes[0].velocity, 100.0 / 60, 1e-9);
  const ImportedMachine bad =
      import(changed("$121=300.000", "$121=abc", changed("=5000.000", "=0")), "a.txt");
  EXPECT_THAT(notes(bad, "a.txt"), HasSubstr("a.txt:8: error: $110 = 0 mm/min cannot be used"));
  EXPECT_THAT(notes(bad, "a.txt"), HasSubstr("a.txt:12: error: $121 = abc: 'abc' is not a number"));
  EXPECT_THAT(source(bad, "X.velocity"), StartsWith("assumed: "));
  EXPECT_THAT(notes(import(std::string(grbl_settings) + "$32=1\n", "a.txt"), "a.txt"),
              HasSubstr("laser mode"));
}

TEST_F(GrblListing, RefusesTheNumbersOfOldReleases) {
  const ImportedMachine imported = import(
      "$0=250.000 (x, step/mm)\n$1=250.000 (y, step/mm)\n$4=500.000 (default feed, mm/min)\n", "old.txt");
  EXPECT_THAT(notes(imported, "old.txt"),
              HasSubstr("old.txt:1: error: the settings are numbered as in grbl 0.8"));
  EXPECT_THAT(source(imported, "idle_delay_ms"), StartsWith("assumed: "));
}

}  // namespace
}  // namespace feedscope
