#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class MachinesCommand : public CommandLine {
 protected:
  MachinesCommand() {
    write("router.txt", "$11=0.02\n$110=5000\n$111=5000\n$112=600\n$120=400\n$121=400\n$122=100\n");
    write("printer.cfg", "[include limits.cfg]\n[printer]\nkinematics: corexy\n[gcode_arcs]\n");
    write("limits.cfg", "[printer]\nmax_velocity: 200\nmax_accel: fast\n");
  }
};

TEST_F(MachinesCommand, ImportsAConfigurationThatProgramsRunOn) {
  const Result result = run("machines import router.txt --out my-router.toml");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out,
              HasSubstr("router.txt -> my-router.toml: 7 numbers from the listing of grbl settings"));
  EXPECT_THAT(result.err, IsEmpty());
  const Result shown = run("machines my-router.toml");
  EXPECT_THAT(shown.out, StartsWith("my-router: router, grbl 1.1"));
  EXPECT_THAT(shown.out, HasSubstr("router.txt, line 2: $110 = 5000 mm/min"));
  const Result simulated = run("simulate corner.nc --machine my-router.toml");
  EXPECT_EQ(simulated.code, 0);
  EXPECT_THAT(simulated.out, HasSubstr("model grbl"));
}

TEST_F(MachinesCommand, WritesWhatItUnderstoodAndReportsTheRest) {
  const Result result = run("machines import printer.cfg");
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.out, HasSubstr("limits.cfg, line 2: [printer] max_velocity = 200 mm/s"));
  EXPECT_THAT(result.err,
              HasSubstr("limits.cfg:3: error: [printer] max_accel = fast mm/s2: 'fast' is not a number"));
}

TEST_F(MachinesCommand, ImportsStandardInput) {
  const Result result = run("machines import - <router.txt");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("standard-input, line 2: $110 = 5000 mm/min"));
  expect_wrong_use("machines import - </dev/null", "'standard-input' is not the configuration of a control");
}

TEST_F(MachinesCommand, RefusesWhatItCannotImport) {
  expect_wrong_use("machines import", "machines import needs a FILE");
  expect_wrong_use("machines import corner.nc", "'corner.nc' is not the configuration of a control");
  expect_wrong_use("machines import none.ini", "cannot read configuration of a control 'none.ini'");
  expect_wrong_use("machines import .", "is a folder");
  expect_wrong_use("machines huron-kx10 router.txt", "write feedscope machines import FILE");
  expect_wrong_use("machines --out a.toml", "write feedscope machines import FILE");
  expect_wrong_use("machines import router.txt --out router.txt", "router.txt");
  expect_wrong_use("machines import router.txt --out none/a.toml", "none/a.toml");
  EXPECT_THAT(contents(folder_ / "router.txt"), StartsWith("$11"));
}

TEST_F(MachinesCommand, ShowsUnitsOfDataSheetsToo) {
  EXPECT_THAT(run("machines spinner-mvc850").out, ContainsRegex("X.acceleration +1 +m/s2 = 0.102 g +Essid"));
  EXPECT_THAT(run("machines mikron-ucp710").out,
              ContainsRegex("X.kv +60 +1/s = 3.6 \\(m/min\\)/mm +assumed"));
  std::string text = contents(fs::path(FEEDSCOPE_SOURCE_DIR) / "machines" / "mikron-ucp710.toml");
  write("mine.toml",
        text.replace(text.find("kv_1_s = { value = 60"), 21, "kv_1_s = { value = \"2 (m/min)/mm\""));
  EXPECT_THAT(run("machines mine.toml").out,
              ContainsRegex("X.kv +33.33333 +1/s = 2 \\(m/min\\)/mm +assumed"));
}

TEST_F(MachinesCommand, DrawsTheKinematicsOfMachinesWithRotaryAxes) {
  for (const std::string id : {"five-axis-table-ac", "five-axis-head-b-table-c", "five-axis-head-bc"}) {
    EXPECT_EQ(run("machines " + id + " --picture axes.png").code, 0) << id;
    EXPECT_THAT(contents(folder_ / "axes.png"), StartsWith("\x89PNG")) << id;
  }
  EXPECT_EQ(run("machines five-axis-table-ac --picture axes.svg").code, 0);
  const std::string svg = contents(folder_ / "axes.svg");
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_EQ(run("machines five-axis-table-ac --picture axes.svg --language en").code, 0);
  EXPECT_TRUE(contents(folder_ / "axes.svg") == svg);
  EXPECT_EQ(run("machines five-axis-table-ac --picture axes.svg --language fr").code, 0);
  EXPECT_FALSE(contents(folder_ / "axes.svg") == svg);
  expect_wrong_use("machines five-axis-table-ac --language fr", "--picture");
  expect_wrong_use("machines five-axis-table-ac --picture axes.svg --language xx", "xx");
  expect_wrong_use("machines five-axis-table-ac --picture axes.bmp",
                   "its name must end in .png, .svg or .pdf");
  expect_wrong_use("machines spinner-mvc850 --picture none.png", "has no rotary axes");
  expect_wrong_use("machines --picture none.png", "--picture needs a machine");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.png"));
}

}  // namespace
}  // namespace feedscope::test
