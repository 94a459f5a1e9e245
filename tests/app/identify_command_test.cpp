#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class IdentifyCommand : public CommandLine {
 protected:
  /// What a machine with other accelerations would have recorded.
  IdentifyCommand() {
    write("moves.nc",
          "G21 G90\nG1 X30 F6000\nG4 P0.1\nX0\nG4 P0.1\nY30\nG4 P0.1\nX20 Y0\nG4 P0.1\nX0\nM30\n");
    run("simulate moves.nc --machine linuxcnc-mill --set X.acceleration=1.3 --set Y.acceleration=0.6 "
        "--csv trace.csv --step 0.001");
  }
};

TEST_F(IdentifyCommand, WritesAMachineFileWithTheSourceOfEachNumber) {
  const Result result =
      run("identify trace.csv --program moves.nc --model linuxcnc --fit acceleration --out mine.toml --json "
          "mine.json");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("mine.toml: machine file"));
  const json report = json::parse(contents(folder_ / "mine.json"));
  EXPECT_EQ(report["format"]["name"], "feedscope-identification");
  const json& x = report["parameters"]["X.acceleration"];
  EXPECT_TRUE(x["told"].get<bool>());
  EXPECT_NEAR(x["value"].get<double>(), 1.3, 0.013);
  EXPECT_NEAR(report["parameters"]["Y.acceleration"]["value"].get<double>(), 0.6, 0.006);
  EXPECT_FALSE(report["parameters"]["Z.acceleration"]["told"].get<bool>());
  EXPECT_TRUE(report["parameters"]["Z.acceleration"]["uncertainty"].is_null());
  EXPECT_EQ(report["parameters"]["Z.acceleration"]["told_by"], "SINGLE MOVES OF Z");
  EXPECT_EQ(x["told_by"], "");
  EXPECT_THAT(result.out, HasSubstr("Test program: SINGLE MOVES OF Z"));
  EXPECT_NEAR(report["agreement"]["cycle_time_s"].get<double>(),
              report["agreement"]["measured_s"].get<double>(), 5e-3);
  EXPECT_THAT(run("machines mine.toml").out, HasSubstr("identified from trace.csv"));
  EXPECT_THAT(run("machines mine.toml").out, HasSubstr("not determined by trace.csv"));
  EXPECT_THAT(result.out, HasSubstr("not determined, and said so in the file: Z.acceleration;"));
  write("lift.nc", "G21 G90 G61\nG1 X10 F3000\nG1 Z20 F2000\nZ0\nM30\n");
  const Result lift = run("simulate lift.nc --machine mine.toml --json lift.json");
  EXPECT_THAT(lift.out, HasSubstr("Z.acceleration limits "));
  EXPECT_THAT(json::parse(contents(folder_ / "lift.json"))["notes"].dump(),
              HasSubstr("Z.acceleration limits "));
  EXPECT_THAT(run("simulate moves.nc --machine mine.toml").out, Not(HasSubstr("Z.acceleration limits ")));
  EXPECT_THAT(run("trace trace.csv moves.nc --machine mine.toml").out, HasSubstr("cycle time"));
}

TEST_F(IdentifyCommand, FindsDrivesFromSetAndActualPositions) {
  run("simulate moves.nc --machine linuxcnc-mill --set X.kv=40 --set X.velocity_lag=4 --csv drives.csv "
      "--step "
      "0.001");
  const Result result = run(
      "identify drives.csv --program moves.nc --model linuxcnc --fit X.kv --fit Y.kv --out mine.toml --json "
      "mine.json");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("following error rms um"));
  const json report = json::parse(contents(folder_ / "mine.json"));
  EXPECT_NEAR(report["parameters"]["X.kv"]["value"].get<double>(), 40, 0.4);
  EXPECT_NEAR(report["parameters"]["X.velocity_lag"]["value"].get<double>(), 4, 0.1);
  EXPECT_FALSE(report["parameters"]["Y.kv"]["told"].get<bool>()) << "Y follows exactly";
  const json& drives = report["models"][0]["drives"];
  ASSERT_EQ(drives.size(), 2U);
  EXPECT_EQ(drives[0]["axis"], "X");
  EXPECT_TRUE(drives[0]["explains"].get<bool>());
  EXPECT_LT(drives[0]["left_um"].get<double>(), 0.01 * drives[0]["following_error_um"].get<double>());
  EXPECT_FALSE(drives[1]["explains"].get<bool>());
  const std::string machine = contents(folder_ / "mine.toml");
  EXPECT_THAT(machine, HasSubstr("kv_1_s"));
  EXPECT_THAT(run("simulate moves.nc --machine mine.toml").out, HasSubstr("Drives, largest values"));
}

TEST_F(IdentifyCommand, ComparesModelsByHowWellTheyExplain) {
  const Result result =
      run("identify trace.csv --program moves.nc --model klipper --model linuxcnc --fit "
          "X.acceleration,Y.acceleration "
          "--json -");
  const json report = json::parse(result.out);
  EXPECT_EQ(report["models"][0]["id"], "linuxcnc");
  EXPECT_EQ(report["models"].size(), 2U);
}

/// Klipper refuses arcs by their radius, so that what it runs is another path than the trace's.
TEST_F(IdentifyCommand, ComparesTheOtherModelsWhereOneCannotBeFitted) {
  write("arcs.ngc", "G21 G90 G17\nG1 X10 F6000\nG2 X110 R60\nG2 X210 R60\nG1 X300 Y40\nM30\n");
  run("simulate arcs.ngc --machine linuxcnc-mill --set X.acceleration=1.3 --csv arcs.csv --step 0.001");
  const std::string identify =
      "identify arcs.csv --program arcs.ngc --fit X.acceleration --dialect linuxcnc ";
  const Result result = run(identify + "--model klipper --model linuxcnc --json arcs.json");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("not fitted"));
  EXPECT_THAT(result.out, HasSubstr("klipper: arcs.csv: the trace does not belong to its program"));
  const json report = json::parse(contents(folder_ / "arcs.json"));
  ASSERT_EQ(report["models"].size(), 1U);
  EXPECT_EQ(report["models"][0]["id"], "linuxcnc");
  ASSERT_EQ(report["unfitted"].size(), 1U);
  EXPECT_EQ(report["unfitted"][0]["id"], "klipper");
  EXPECT_THAT(report["unfitted"][0]["reason"].get<std::string>(), HasSubstr("does not belong"));
  expect_wrong_use(identify + "--model klipper", "does not belong to its program");
  expect_wrong_use(identify + "--model linuxcnc --model klippr", "klippr");
#ifdef FEEDSCOPE_WITH_UI
  EXPECT_EQ(run(identify + "--model klipper --model linuxcnc --report arcs.html").code, 0);
  EXPECT_THAT(contents(folder_ / "arcs.html"), HasSubstr("not fitted"));
#endif
}

/// The drives follow whatever set positions there were.
TEST_F(IdentifyCommand, TellsDrivesWhereTheModelDoesNotExplainTheTimes) {
  run("simulate moves.nc --machine linuxcnc-mill --set X.kv=40 --set X.acceleration=0.2 --csv drives.csv "
      "--step 0.001");
  const std::string identify = "identify drives.csv --program moves.nc --model linuxcnc --fit ";
  const Result alone = run(identify + "X.kv");
  EXPECT_THAT(alone.out, HasSubstr("model linuxcnc as it is does not explain the times"));
  EXPECT_EQ(alone.out.find("no value of it is told"), std::string::npos);
  const Result with_others = run(identify + "X.kv,Z.acceleration");
  EXPECT_THAT(with_others.out, HasSubstr("no value of it is told"));
  EXPECT_THAT(with_others.out, HasSubstr("drives are found without it"));
}

#ifdef FEEDSCOPE_WITH_UI
TEST_F(IdentifyCommand, WritesAReportOnTheMachineThatWasFound) {
  const std::string identify =
      "identify trace.csv --program moves.nc --model linuxcnc --fit X.acceleration,Y.acceleration ";
  const Result result = run(identify + "--out mine.toml --report report.html");
  EXPECT_EQ(result.code, 0) << result.err;
  const std::string report = contents(folder_ / "report.html");
  EXPECT_THAT(report, HasSubstr("Limits and settings of the machine, found from what it recorded."));
  EXPECT_THAT(report, HasSubstr("identified from trace.csv, "));
  EXPECT_THAT(report, HasSubstr("moves.nc on mine")) << "the run is on the machine that was found";
  EXPECT_THAT(report, HasSubstr("Agreement with the control"));
  EXPECT_THAT(report, HasSubstr("feedscope identify trace.csv --program moves.nc --model linuxcnc --fit"));
  EXPECT_EQ(report.find("have changed since"), std::string::npos);
  EXPECT_EQ(run(identify + "--language fr --report report.pdf").code, 0);
  EXPECT_EQ(contents(folder_ / "report.pdf").substr(0, 4), "%PDF");
  expect_wrong_use(identify + "--report report.doc", "report.doc");
  expect_wrong_use(identify + "--report trace.csv", "trace.csv");
  expect_wrong_use(identify + "--language fr", "--language has no effect without --report");
  expect_wrong_use("identify --program --dialect iso --report report.pdf", "identify needs traces");
}
#endif

TEST_F(IdentifyCommand, WritesTheTestProgramAndWhatItsPartsTell) {
  const Result result =
      run("identify --program --dialect heidenhain --size 100 --feed-max 6000 --out test.h");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("X and Y within +-50 mm"));
  EXPECT_THAT(result.out, HasSubstr("CORNERS OF 10 TO 170 DEGREES"));
  EXPECT_EQ(run("simulate test.h").code, 0);
  EXPECT_EQ(run("identify --program --dialect iso --size 100 --out test.nc --picture test.png").code, 0);
  EXPECT_EQ(contents(folder_ / "test.png").substr(1, 3), "PNG");
  expect_wrong_use("identify --program --dialect iso --picture test.svg", "end its name in .png");
  expect_wrong_use("identify trace.csv --program moves.nc --model linuxcnc --picture test.png",
                   "--picture are of the test program");
  expect_wrong_use("identify --program --out test.h", "the test program needs --dialect");
  expect_wrong_use("identify --program moves.nc --model linuxcnc", "identify needs traces");
}

/// Taken from the motion that a machine with other accelerations would have had, row by row.
TEST_F(IdentifyCommand, TakesTimesOfSectionsInsteadOfATrace) {
  std::map<int, int> rows;
  std::istringstream motion(contents(folder_ / "trace.csv"));
  std::string row;
  for (std::getline(motion, row); std::getline(motion, row);) {
    const auto line = row.find(',', row.find(',') + 1) + 1;
    ++rows[std::stoi(row.substr(line))];
  }
  std::string table = "lines,ms\n";
  for (const auto& [line, count] : rows) {
    table += fmt::format("{}-{},{}\n", line, line, count);
  }
  write("times.csv", table);
  const Result result =
      run("identify times.csv --program moves.nc --model linuxcnc --fit X.acceleration,Y.acceleration --out "
          "mine.toml "
          "--json mine.json");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("sections missed most"));
  const json report = json::parse(contents(folder_ / "mine.json"));
  EXPECT_NEAR(report["parameters"]["X.acceleration"]["value"].get<double>(), 1.3, 0.026);
  EXPECT_NEAR(report["parameters"]["Y.acceleration"]["value"].get<double>(), 0.6, 0.012);
  EXPECT_EQ(report["models"][0]["traces"][0]["sections"].size(), rows.size());
  EXPECT_THAT(contents(folder_ / "mine.toml"), HasSubstr("identified from times.csv"));
  std::string wrong = "lines,seconds\n";
  for (const auto& [line, count] : rows) {
    wrong += fmt::format("{}-{},{}\n", line, line, count);
  }
  write("wrong.csv", wrong);
  expect_wrong_use("identify wrong.csv --program moves.nc --model linuxcnc", "they seem to be in ms");
  write("few.csv", "section,seconds\n1,2\n");
  expect_wrong_use("identify few.csv --program moves.nc --model linuxcnc", "at least 4 can tell something");
  write("other.csv", "section,seconds\n1,2\n2,2\n3,2\n4,2\n");
  expect_wrong_use("identify other.csv --program moves.nc --model linuxcnc", "moves.nc has no section '1'");
}

TEST_F(IdentifyCommand, SaysWhatIsMissingOrWrong) {
  expect_wrong_use("identify trace.csv --model linuxcnc", "needs the program of each trace");
  expect_wrong_use("identify trace.csv --program moves.nc", "needs the model that is fitted");
  expect_wrong_use("identify trace.csv --program moves.nc --model linuxcnc --fit X.acceleratoin",
                   "did you mean 'X.acceleration'?");
  expect_wrong_use("identify trace.csv trace.csv trace.csv --model linuxcnc --program moves.nc corner.nc",
                   "3 traces and 2 programs");
  expect_wrong_use("identify trace.csv --program moves.nc --model linuxcnc --out trace.csv", "trace.csv");
}

}  // namespace
}  // namespace feedscope::test
