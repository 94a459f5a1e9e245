#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

class TraceCommand : public CommandLine {
 protected:
  /// What a control would have recorded of corner.nc.
  TraceCommand() { run("simulate corner.nc --machine linuxcnc-mill --csv trace.csv --step 0.001"); }
};

TEST_F(TraceCommand, TellsWhatATraceHolds) {
  const Result result = run("trace trace.csv");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("trace.csv: table of samples"));
  EXPECT_THAT(result.out, HasSubstr("x: column 4 'x_mm' [mm]"));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(TraceCommand, LaysItBesideTheSimulationOfItsProgram) {
  const Result result = run("trace trace.csv corner.nc --machine linuxcnc-mill --json -");
  EXPECT_EQ(result.code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["format"]["name"], "feedscope-trace");
  const json& agreement = report["agreement"];
  EXPECT_NEAR(agreement["cycle_time_s"].get<double>(), agreement["measured_s"].get<double>(), 2e-3);
  EXPECT_LT(agreement["feed_rms_mm_min"].get<double>(), 5);
  EXPECT_TRUE(agreement["whole"].get<bool>());
  const json other = json::parse(
      run("trace trace.csv corner.nc --machine linuxcnc-mill --set X.acceleration=0.3 --json -").out);
  EXPECT_GT(other["agreement"]["feed_rms_mm_min"].get<double>(), 100);
}

TEST_F(TraceCommand, PicturesAndReportsShowItBesideTheRun) {
  const std::string beside = " corner.nc --machine linuxcnc-mill --trace trace.csv --out ";
  const Result report = run("report" + beside + "r.html", no_display);
  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("Agreement with the control"));
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("--trace trace.csv"));
  const std::string alone = " corner.nc --machine linuxcnc-mill --out ";
  for (const std::string view : {"3d", "charts", "sheet"}) {
    EXPECT_EQ(run("render --view " + view + beside + "with.svg", no_display).code, 0);
    EXPECT_EQ(run("render --view " + view + alone + "without.svg", no_display).code, 0);
    EXPECT_NE(contents(folder_ / "with.svg"), contents(folder_ / "without.svg")) << view;
  }
}

TEST_F(TraceCommand, WarnsEverywhereOfATraceOfAnotherProgram) {
  write("other.nc", "G21 G90\nG1 X7 Y3 F3000\nX2 Y9\nX11 Y12\nX0 Y0\nM30\n");
  const std::string warning = "trace.csv: warning: the trace does not belong to this program: ";
  const std::string machine = " --machine linuxcnc-mill ";
  const Result beside = run("trace trace.csv other.nc" + machine);
  EXPECT_EQ(beside.code, 2);
  EXPECT_THAT(beside.err, HasSubstr(warning));
  for (const std::string command : {"report other.nc --out r.html", "render other.nc --out r.svg"}) {
    const Result result = run(command + machine + "--trace trace.csv", no_display);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr(warning)) << command;
    EXPECT_THAT(result.err, HasSubstr("open the program that was recorded")) << command;
  }
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("does not belong to this program"));
  const json report = json::parse(run("trace trace.csv other.nc --json -" + machine).out);
  EXPECT_FALSE(report["agreement"]["belongs"].get<bool>());
  EXPECT_FALSE(report["agreement"]["whole"].get<bool>());
  EXPECT_EQ(report["agreement"]["messages"][0]["code"], "trace-other-program");
  expect_wrong_use("identify trace.csv --program other.nc --model linuxcnc",
                   "the trace does not belong to its program");
}

TEST_F(TraceCommand, TellsReportsOfACoarseTraceWithTimesThatGoBack) {
  run("simulate corner.nc --machine linuxcnc-mill --csv coarse.csv --step 0.02");
  const std::string text = contents(folder_ / "coarse.csv");
  const auto second = text.find('\n', text.find('\n') + 1) + 1;
  write("back.csv", text + text.substr(second, text.find('\n', second) + 1 - second));
  const Result result =
      run("report corner.nc --machine linuxcnc-mill --trace back.csv --out r.html", no_display);
  EXPECT_THAT(result.err, HasSubstr("one sample each 20 ms"));
  EXPECT_THAT(result.err, HasSubstr("the time goes back"));
  EXPECT_THAT(contents(folder_ / "r.html"), HasSubstr("One sample each 20 ms"));
}

TEST_F(TraceCommand, WhatCannotBeShownBesideTheRunIsRefused) {
  const std::string report = "report corner.nc --out r.html ";
  expect_wrong_use(report + "--trace none.csv", "trace 'none.csv'");
  expect_wrong_use(report + "--columns time=1", "--columns says how --trace is read; give --trace FILE too");
  expect_wrong_use("render corner.nc --view window --trace trace.csv --out w.png",
                   "--trace has no effect with --view window");
  EXPECT_FALSE(fs::exists(folder_ / "r.html"));
}

TEST_F(TraceCommand, TakesColumnsFromAFileToo) {
  write("spec.txt", "time=1:s,x=x_mm:-mm\n");
  const Result result = run("trace trace.csv --columns spec.txt");
  EXPECT_THAT(result.out, HasSubstr("[-mm]"));
}

/// Every second sample of a control that samples each millisecond, without times.
TEST_F(TraceCommand, SaysWhereItsRateComesFromAndWhenThatIsWrong) {
  write("moves.nc", "G21 G90 G61\nG1 X60 F6000\nY60\nX0\nY0\nX5\nX10\nX15\nX20\nX60 Y60\nM30\n");
  run("simulate moves.nc --machine linuxcnc-mill --csv moves.csv --step 0.002");
  std::istringstream rows(contents(folder_ / "moves.csv"));
  std::string sampler;
  std::string row;
  std::getline(rows, row);
  for (int number = 0; std::getline(rows, row); ++number) {
    std::array<std::string, 6> fields;
    std::istringstream in(row);
    for (std::string& field : fields) {
      std::getline(in, field, ',');
    }
    sampler += fmt::format("{} {} {} {}\n", number, fields[3], fields[4], fields[5]);
  }
  write("sampler.txt", sampler);
  const std::string beside =
      "trace sampler.txt moves.nc --machine linuxcnc-mill --json - --columns linuxcnc-xyz";
  const auto expect = [&](const std::string& options, double period, const std::string& from, double error) {
    const json report = json::parse(run(beside + options).out);
    EXPECT_EQ(report["trace"]["period_from"], from) << options;
    EXPECT_EQ(report["agreement"]["period_from"], from) << options;
    EXPECT_NEAR(report["trace"]["period_s"].get<double>(), period, 1e-12) << options;
    const json& agreement = report["agreement"];
    EXPECT_NEAR(agreement["cycle_time_s"].get<double>() / agreement["measured_s"].get<double>() - 1, error,
                0.02)
        << options;
  };
  expect(",rate=500", 2e-3, "option", 0);
  expect(" --set servo_period_s=0.002", 2e-3, "machine", 0);
  expect("", 1e-3, "machine", 1);
  EXPECT_EQ(json::parse(run("trace sampler.txt --json - --columns linuxcnc-xyz").out)["trace"]["period_from"],
            "assumed");
  EXPECT_THAT(run("trace sampler.txt --columns linuxcnc-xyz,rate=500").out,
              HasSubstr("one each 2 ms (rate as given)"));
  EXPECT_THAT(run("trace sampler.txt moves.nc --machine linuxcnc-mill --columns linuxcnc-xyz").err,
              HasSubstr("warning: the trace runs at 200 % of the simulated feed"));
  const std::string identify = "identify sampler.txt --program moves.nc --model linuxcnc --fit acceleration ";
  const Result refused = run(identify + "--out mine.toml --columns linuxcnc-xyz");
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, HasSubstr("give the right rate, 500 samples a second"));
  EXPECT_FALSE(fs::exists(folder_ / "mine.toml"));
  EXPECT_THAT(run(identify + "--columns linuxcnc-xyz,rate=500").out, HasSubstr("2 ms (rate as given)"));
}

TEST_F(TraceCommand, RefusesWhatItCannotRead) {
  expect_wrong_use("trace none.csv", "cannot read trace 'none.csv'");
  expect_wrong_use("trace corner.nc", "'corner.nc' is no trace");
  expect_wrong_use("trace .", "is a folder");
  using namespace std::string_literals;
  write("broken.csv.gz", "\x1f\x8b\x08\0\0\0\0\0\0\x03\xff\xff\xff"s);
  expect_wrong_use("trace broken.csv.gz", "cannot read trace 'broken.csv.gz': invalid block type");
  expect_wrong_use("trace trace.csv --columns q=1", "unknown key 'q'");
  expect_wrong_use("trace trace.csv --json trace.csv", "trace.csv");
}

}  // namespace
}  // namespace feedscope::test
