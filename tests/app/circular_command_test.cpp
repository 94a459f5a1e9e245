#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class CircularCommand : public CommandLine {};

TEST_F(CircularCommand, GivesBothDirectionsOfEveryRadiusAndFeed) {
  const Result result =
      run("circular --radius 30 --radius 2,5 --feed 6000 --feed 9000 --machine mikron-ucp710 --json -");
  ASSERT_EQ(result.code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["format"]["name"], "feedscope-circular");
  ASSERT_EQ(report["circular"].size(), 8U);
  EXPECT_EQ(report["circular"][0]["direction"], "ccw");
  EXPECT_EQ(report["circular"][1]["direction"], "cw");
  EXPECT_EQ(report["circular"][7]["radius_mm"], 2.5);
  EXPECT_EQ(report["circular"][7]["feed_mm_min"], 9000);
  EXPECT_EQ(report["circular"][0]["path"], "actual");
  EXPECT_EQ(report["drives"]["axes"]["X"]["kv_1_s"], 60);
  EXPECT_NEAR(report["circular"][0]["Fmax_um"].get<double>(), 33.27, 0.2);
}

TEST_F(CircularCommand, TableSaysWhichPathIsJudgedAndWhatTheLettersMean) {
  const Result actual = run("circular --radius 30 --feed 6000 --machine mikron-ucp710");
  EXPECT_EQ(actual.code, 0);
  EXPECT_THAT(actual.out, HasSubstr("actual path of the axes"));
  EXPECT_THAT(actual.out, HasSubstr("ISO 230-4"));
  EXPECT_THAT(actual.out, Not(HasSubstr("-0.00")));
  const Result set = run("circular --radius 30 --feed 3000 --machine spinner-mvc850");
  EXPECT_THAT(set.out, HasSubstr("set path; the machine has no drives"));
}

TEST_F(CircularCommand, WritesTheProgramOfTheTestForTheMachine) {
  const Result result =
      run("circular --radius 30 --feed 6000 --program test.mpf --dialect sinumerik --csv results.csv");
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(contents(folder_ / "test.mpf"), HasSubstr("G3 X30.0000 Y0.0000 I-30.0000 J0.0000 F6000"));
  EXPECT_THAT(contents(folder_ / "results.csv"),
              testing::StartsWith("radius_mm,feed_mm_min,plane,direction,"));
  const Result read = run("check test.mpf");
  EXPECT_EQ(read.code, 0) << read.err;
}

#ifdef FEEDSCOPE_WITH_UI
TEST_F(CircularCommand, DrawsPolarPlotsInTheFormatOfTheName) {
  const std::string tests = "circular --radius 30 --feed 6000 --feed 9000 --machine mikron-ucp710";
  for (const auto& [name, begins] : {std::pair("a.png", "\x89PNG"), {"a.svg", "<?xml"}, {"a.pdf", "%PDF"}}) {
    const Result result = run(tests + " --out " + name, no_display);
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string first = contents(folder_ / name);
    EXPECT_TRUE(first.starts_with(begins)) << name;
    run(tests + " --out " + name, no_display);
    EXPECT_TRUE(contents(folder_ / name) == first) << name << " differs from time to time";
  }
  expect_wrong_use(tests + " --out a.gif", "its name must end in .png, .svg or .pdf");
  expect_wrong_use(tests + " --out a.png --size 100x100", "too small");
}
#endif

// One turn each way about (5, 0), one of halves about (0, 0), and a helix.
constexpr const char* circles =
    "G21 G90 G17 G94 F6000\nG0 X35 Y0\nG3 I-30 J0\nG2 I-30 J0\nG0 X20\nG3 X-20 I-20\nX20 I20\n"
    "G3 I-20 Z-1\nM30\n";

TEST_F(CircularCommand, EvaluatesTheFullCirclesOfAProgram) {
  write("circles.nc", circles);
  const Result result = run("circular circles.nc --machine mikron-ucp710 --json - --csv circles.csv");
  ASSERT_EQ(result.code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["program"]["full_circles"], 3);
  EXPECT_EQ(report["program"]["evaluated_circles"], 3);
  EXPECT_EQ(report["program"]["helices"], 1);
  const json& list = report["circular"];
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0]["direction"], "ccw");
  EXPECT_EQ(list[1]["direction"], "cw");
  EXPECT_EQ(list[0]["line"], 3);
  EXPECT_EQ(list[1]["line"], 4);
  EXPECT_NEAR(list[0]["centre_mm"]["X"].get<double>(), 5, 1e-9);
  EXPECT_EQ(list[0]["Gb_um"], list[1]["Gb_um"]);
  EXPECT_NEAR(list[0]["Fmax_um"].get<double>(), 33.27, 0.2);
  EXPECT_EQ(list[2]["line"], 6);
  EXPECT_EQ(list[2]["last_line"], 7);
  EXPECT_TRUE(list[2]["Gb_um"].is_null());
  EXPECT_TRUE(list[2]["D_um"].is_null());
  EXPECT_NEAR(list[2]["sweep_deg"].get<double>(), 360, 1e-9);
  EXPECT_THAT(contents(folder_ / "circles.csv"), HasSubstr(",6,7,0,0,0,"));
  const Result text = run("circular circles.nc --machine mikron-ucp710");
  EXPECT_THAT(text.out, HasSubstr("circles.nc on Mikron UCP 710, model tapie: actual path of the axes"));
  EXPECT_THAT(text.out, HasSubstr("6-7"));
  EXPECT_THAT(text.out, HasSubstr("Not evaluated: 1 helix with full turns."));
}

TEST_F(CircularCommand, ProgramsWithoutFullCirclesAreNamedSo) {
  const Result text = run("circular corner.nc");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("The program has no full circle"));
  const json report = json::parse(run("circular corner.nc --json -").out);
  EXPECT_TRUE(report["circular"].empty());
#ifdef FEEDSCOPE_WITH_UI
  expect_wrong_use("circular corner.nc --out a.svg", "cannot be drawn: The program has no full circle");
#endif
}

#ifdef FEEDSCOPE_WITH_UI
TEST_F(CircularCommand, DrawsTheCirclesOfAProgramThatAreAskedFor) {
  write("circles.nc", circles);
  const std::string program = "circular circles.nc --machine mikron-ucp710";
  ASSERT_EQ(run(program + " --out all.svg", no_display).code, 0);
  ASSERT_EQ(run(program + " --out second.svg --circle 2", no_display).code, 0);
  EXPECT_LT(contents(folder_ / "second.svg").size(), 0.7 * contents(folder_ / "all.svg").size());
  expect_wrong_use(program + " --circle 1", "give --out FILE.png too");
  expect_wrong_use(program + " --out a.svg --circle 3", "--circle = 3 is out of bounds");
  expect_wrong_use(program + " --out a.svg --circle 1,000", "--circle = '1,000': the comma");
  expect_wrong_use("circular --radius 3 --feed 100 --out a.svg --circle 1", "--circle needs a program");
}
#endif

TEST_F(CircularCommand, WrongUseNamesValueAndBound) {
  expect_wrong_use("circular --feed 6000", "no circle to evaluate: --radius is missing");
  expect_wrong_use("circular --radius 30", "no circle to evaluate: --feed is missing");
  expect_wrong_use("circular --radius 30 --feed 6000 --tool 1=5", "--tool needs a program");
  expect_wrong_use("circular corner.nc --radius 30",
                   "--radius describes a circle to be tested, but 'corner.nc'");
  expect_wrong_use("circular corner.nc --program out.nc", "--program describes");
  expect_wrong_use("circular --radius 0 --feed 6000",
                   "--radius = 0 is out of bounds; it must be at least 0.001 mm");
  expect_wrong_use("circular --radius 30 --feed 0", "--feed = 0 is out of bounds");
  expect_wrong_use("circular --radius 30 --feed 6000 --plane XZ", "XY, ZX, YZ");
  expect_wrong_use("circular --radius 30 --feed 6000 --entry-radius 40",
                   "entry radius = 40 mm is out of bounds");
  expect_wrong_use("circular --radius 30 --feed 6000 --set X.kv=0", "X.kv = 0 is out of bounds");
  expect_wrong_use("circular --radius 30 --feed 6000 --dialect fanuc", "--program");
}

TEST_F(CircularCommand, SimulationOnDrivesReportsFollowingErrors) {
  const std::string drives = " --set X.kv=50 --set Y.kv=40";
  const Result result = run("simulate corner.nc" + drives + " --json - --csv motion.csv");
  ASSERT_EQ(result.code, 0) << result.err;
  const json report = json::parse(result.out);
  // 50 mm/s without feed-forward: 50/50 mm in X, 50/40 mm in Y.
  EXPECT_NEAR(report["actual"]["max_following_error_um"]["X"].get<double>(), 1000, 1);
  EXPECT_NEAR(report["actual"]["max_following_error_um"]["Y"].get<double>(), 1250, 2);
  EXPECT_EQ(report["actual"]["max_following_error_um"]["Z"], 0);
  EXPECT_GT(report["actual"]["max_contour_error_mm"].get<double>(),
            report["max_contour_error_mm"].get<double>());
  EXPECT_THAT(contents(folder_ / "motion.csv"), HasSubstr(",actual_contour_error_um\n"));
  EXPECT_THAT(report["notes"].dump(), HasSubstr("No drive is given for Z: followed exactly."));
  const Result text = run("simulate corner.nc" + drives);
  EXPECT_THAT(text.out, HasSubstr("following error of X"));
  const Result without = run("simulate corner.nc --json -");
  EXPECT_TRUE(json::parse(without.out)["actual"].is_null());
}

TEST_F(CircularCommand, PicturesSpeakTheLanguageThatIsAskedFor) {
  const std::string circle = "circular --radius 30 --feed 2000 --out ";
  EXPECT_EQ(run(circle + "en.svg", no_display).code, 0);
  EXPECT_EQ(run(circle + "fr.svg --language fr", no_display).code, 0);
  EXPECT_THAT(contents(folder_ / "en.svg"), HasSubstr("<title>Circular test (ISO 230-4)</title>"));
  EXPECT_THAT(contents(folder_ / "fr.svg"), HasSubstr("<title>Essai circulaire (ISO 230-4)</title>"));
  expect_wrong_use(circle + "x.svg --language xx", "--language: xx not in {en,fr}");
  expect_wrong_use("circular --radius 30 --feed 2000 --language fr", "--language requires --out");
  const std::string bars = "compare corner.nc --tolerance 0.01 --tolerance 0.05 --png ";
  EXPECT_EQ(run(bars + "en.png", no_display).code, 0);
  EXPECT_EQ(run(bars + "fr.png --language fr", no_display).code, 0);
  EXPECT_TRUE(contents(folder_ / "en.png") != contents(folder_ / "fr.png"));
}

TEST_F(CircularCommand, PoorDampingIsNotedWithItsOvershoot) {
  for (const std::string command : {"simulate corner.nc", "circular --radius 30 --feed 2000"}) {
    const Result result = run(command + " --set X.kv=200 --set X.velocity_lag=20");
    EXPECT_EQ(result.code, 0);
    // Damping 1/(2 sqrt(4)) = 0.25.
    EXPECT_THAT(result.err, HasSubstr("The drive of axis X is poorly damped: it overshoots a step by 44 %"));
  }
  expect_wrong_use("simulate corner.nc --set X.velocity_lag=6", "give X.kv in 1/s");
}

}  // namespace
}  // namespace feedscope::test
