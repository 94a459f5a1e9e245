#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

using CheckCommand = CommandLine;

TEST_F(CheckCommand, TellsFacts) {
  const Result result = run("check corner.nc");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("2; 2 blocks run"), HasSubstr("2 lines, 0 arcs"),
                                HasSubstr("0.0000 to 20.0000 mm"), HasSubstr("40.000 mm"),
                                HasSubstr("3000 to 3000 mm/min")));
  EXPECT_EQ(run("check wrong.nc").code, 1);
  const json report = json::parse(run("check wrong.nc --json -").out);
  EXPECT_EQ(report["program"]["segments"], 2);
  EXPECT_EQ(report["diagnostics"][0]["severity"], "error");
}

TEST_F(CheckCommand, MarksThePlaceOfADiagnostic) {
  write("arc.nc", "G1 X10 F100\n\tG2 X20 R4\n" + std::string(200, ' ') + "G0 X1 @\n");
  const Result result = run("check arc.nc");
  EXPECT_THAT(result.err, HasSubstr("arc.nc:2:9: error: radius 4.0000 mm is too small"));
  EXPECT_THAT(result.err, HasSubstr("\n   G2 X20 R4\n          ^\n")) << "a tab is shown as one blank";
  EXPECT_THAT(result.err, HasSubstr("G0 X1 @\n" + std::string(62, ' ') + "^\n")) << "long lines are cut";
}

TEST_F(CheckCommand, TellsPathControlByLines) {
  write("control.ngc", "G64 P0.2\nG1 X10 F3000\nY10\nG61\nX0\n");
  EXPECT_THAT(run("check control.ngc").out,
              AllOf(HasSubstr("LinuxCNC"), HasSubstr("lines 2 to 3: continuous, contour tolerance 0.2 mm"),
                    HasSubstr("line 5: exact stops")));
  const json report = json::parse(run("check control.ngc --json -").out);
  EXPECT_EQ(report["program"]["dialect"], "linuxcnc");
  EXPECT_EQ(report["program"]["path_control"][0]["contour_tolerance_mm"], 0.2);
  EXPECT_EQ(report["program"]["path_control"][1]["exact_stop"], true);
}

TEST_F(CheckCommand, ListsPathControlByLinesAlsoWhereTheyRunInAnotherOrder) {
  write("back.mpf",
        "GOTOF LATER\nEARLY: G64\nG1 X20\nGOTOF FIN\nLATER: G1 F1000 G60 X10\nGOTOB EARLY\nFIN: M30\n");
  const std::string out = run("check back.mpf").out;
  const auto early = out.find("line 3:");
  ASSERT_NE(early, std::string::npos) << out;
  EXPECT_LT(early, out.find("line 5:"));
}

TEST_F(CheckCommand, TellsWhatAMachineCannotDo) {
  write("tilted.nc", "G0 X0 Y0 Z0\nG43.4 H1\nG1 X10 A60 F1000\nX20 A10\nM30\n");
  EXPECT_THAT(run("check tilted.nc --dialect fanuc").err, HasSubstr("which is not simulated"));
  const Result here = run("check tilted.nc --dialect fanuc --machine five-axis-table-ac");
  EXPECT_EQ(here.code, 1);
  EXPECT_THAT(here.err, AllOf(HasSubstr("tilted.nc:3: error: axis A goes to 60 degrees, beyond its travel"),
                              testing::Not(HasSubstr("not simulated"))));
  const json report =
      json::parse(run("check tilted.nc --dialect fanuc --machine five-axis-table-ac --json -").out);
  const auto is_travel = [](const json& message) { return message["code"] == "rotary-travel"; };
  EXPECT_EQ(std::ranges::count_if(report["diagnostics"], is_travel), 1);
  EXPECT_EQ(run("check tilted.nc --dialect fanuc --machine no-such").code, 2);
  std::vector<std::string> commands{"simulate tilted.nc", "explain tilted.nc", "circular tilted.nc"};
#ifdef FEEDSCOPE_WITH_UI
  commands.emplace_back("render tilted.nc --view charts --out charts.png");
  commands.emplace_back("report tilted.nc --out report.html");
#endif
  for (const std::string& command : commands) {
    const Result result = run(command + " --dialect fanuc --machine five-axis-table-ac");
    EXPECT_EQ(result.code, 1) << command;
    EXPECT_THAT(result.err + result.out, HasSubstr("axis A goes to 60 degrees")) << command;
  }
}

TEST_F(CheckCommand, AsksForTheOffsetThatHasNoValue) {
  write("offsets.nc", "G21 G90\nG54 G0 X0 Y0\nG1 X10 F1000\nG55 X20\nM30\n");
  EXPECT_THAT(run("check offsets.nc").err, HasSubstr("--offset G55=X,Y,Z"));
  EXPECT_THAT(run("check offsets.nc --offset G55=5,5,0").err, HasSubstr("--offset G54=X,Y,Z"));
  EXPECT_THAT(run("check offsets.nc --offset G54=0,0,0").err, HasSubstr("--offset G55=X,Y,Z"));
  write("offsets.mpf", "G90 G54\nG1 X10 F1000\nG55 X20\nM30\n");
  EXPECT_THAT(run("check offsets.mpf --offset G55=5,5,0").err, HasSubstr("--offset G54=X,Y,Z"));
  EXPECT_THAT(run("check offsets.nc").out, HasSubstr("G55 (line 4): 1 motion, assumed as zero"));
}

TEST_F(CheckCommand, TakesTheDialectThatIsNamed) {
  write("dwell.nc", "G4 P2\nG1 X1 F100\n");
  const auto dwell = [this](const std::string& options) {
    return json::parse(run("check dwell.nc --json - " + options).out)["program"]["dwell_s"].get<double>();
  };
  EXPECT_EQ(dwell("--dialect fanuc"), 0.002);
  EXPECT_EQ(dwell("--dialect linuxcnc"), 2);
  expect_wrong_use("check dwell.nc --dialect linuxcmc", "did you mean \"linuxcnc\"?");
}

TEST_F(CheckCommand, CutterRadiiComeFromOptionsAndTables) {
  write("part.nc", "G21 G17\nG42 D7 G1 X10 F600\nX20\nX30\n");
  const Result unknown = run("check part.nc --dialect fanuc");
  EXPECT_EQ(unknown.code, 1);
  EXPECT_THAT(unknown.err, AllOf(HasSubstr("[tool-radius]"), HasSubstr("--tool 7=RADIUS")));
  EXPECT_THAT(unknown.out, HasSubstr("7 (line 2): radius not known"));
  const Result given = run("check part.nc --dialect fanuc --tool 7=4,5");
  EXPECT_EQ(given.code, 0) << given.err;
  EXPECT_THAT(given.out, HasSubstr("7 (line 2): radius 4.5 mm (asked for)"));
  write("mine.tbl", "T7 P1 D0.5 ; half an inch\n");
  const json cutter =
      json::parse(run("check part.nc --dialect fanuc --tools mine.tbl --tools-unit inch --json -")
                      .out)["program"]["cutters"][0];
  EXPECT_EQ(cutter["tool"], "7");
  EXPECT_EQ(cutter["radius_mm"], 6.35);
  EXPECT_EQ(cutter["source"], "tool table");
  EXPECT_EQ(cutter["line"], 2);
}

TEST_F(CheckCommand, RefusesWhatIsNoCutterRadius) {
  write("part.nc", "G1 X10 F600\n");
  expect_wrong_use("check part.nc --tool 7", "is not TOOL=RADIUS");
  expect_wrong_use("check part.nc --tool =3", "is not TOOL=RADIUS");
  expect_wrong_use("check part.nc --tool 7=wide", "wide");
  expect_wrong_use("check part.nc --tool 7=-1", "-1");
  expect_wrong_use("check part.nc --tools none.tbl", "none.tbl");
  write("bad.tbl", "hello\n");
  expect_wrong_use("check part.nc --tools bad.tbl", "is not a supported tool table");
}

TEST_F(CheckCommand, EndlessLoopsEndAtALimitThatCanBeRaised) {
  write("loop.ngc", "#1=0\no1 while [#1 LT 100]\n#1=[#1+1]\nG1 X#1 F100\no1 endwhile\nM2\n");
  EXPECT_EQ(run("check loop.ngc").code, 0);
  const Result stopped = run("check loop.ngc --repeat-limit 30");
  EXPECT_EQ(stopped.code, 1);
  EXPECT_THAT(stopped.err, AllOf(HasSubstr("[run-limit]"), HasSubstr("--repeat-limit")));
}

TEST_F(CheckCommand, AProgramThatWasCutOffIsSimulatedOnlyIfAskedFor) {
  write("loop.ngc", "G21\no1 while [1]\nG91 G1 X1 F100\no1 endwhile\nM2\n");
  const Result refused = run("simulate loop.ngc --repeat-limit 30 --json out.json");
  EXPECT_NE(refused.code, 0);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("loop.ngc, line"), HasSubstr("--repeat-limit"),
                                 HasSubstr("--simulate-cut-off")));
  EXPECT_FALSE(fs::exists(folder_ / "out.json"));
  const Result asked = run("simulate loop.ngc --repeat-limit 30 --simulate-cut-off --json -");
  EXPECT_EQ(asked.code, 1) << "the program has an error";
  EXPECT_GT(json::parse(asked.out)["cycle_time_s"].get<double>(), 0);
}

TEST_F(CheckCommand, AProgramThatWasCutOffInACalledFileNamesFileLineAndCause) {
  write("MAIN.H", "BEGIN PGM MAIN MM\nTOOL CALL 1 Z S5000\nCALL PGM FACE.H\nEND PGM MAIN MM\n");
  write("FACE.H",
        "BEGIN PGM FACE MM\nQ2 = 0\nLBL 1\nL IX+1 F1000\nQ2 = Q2 + Q108\nFN 12: IF +Q2 LT +5 GOTO LBL 1\nEND "
        "PGM FACE MM\n");
  const Result refused = run("simulate MAIN.H --repeat-limit 30");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, testing::ContainsRegex("FACE.H, line [345]: loops and calls have run 30 lines"));
  EXPECT_THAT(refused.err, HasSubstr("FACE.H, line 5: the tool radius Q108 is not known (0 is used; give it "
                                     "as an import option (--tool 1=RADIUS)"));
  const Result given = run("simulate MAIN.H --repeat-limit 30 --tool 1=2.5");
  EXPECT_EQ(given.code, 0) << given.err;
  EXPECT_THAT(given.err, testing::Not(HasSubstr("is not used")));
}

TEST_F(CheckCommand, PathsThatAreCompensatedNeedNoRadius) {
  write("part.nc", "G21 G17\nG42 D7 G1 X10 F600\nX20\nX30\n");
  const Result wear = run("check part.nc --dialect fanuc --wear-only");
  EXPECT_EQ(wear.code, 0) << wear.err;
  EXPECT_THAT(wear.out, HasSubstr("7 (line 2): radius 0 mm (asked for)"));
}

TEST_F(CheckCommand, TellsExtentsWithArcsCuttingAndRapidApart) {
  write("circle.nc", "G21 G0 X50 Y0 Z5\nG1 Z0 F500\nG2 I-50\nG0 Z80\n");
  EXPECT_THAT(
      run("check circle.nc").out,
      AllOf(HasSubstr("-50.0000 to 50.0000 mm; cutting -50.0000 to 50.0000 mm; rapid 50.0000 to 50.0000 mm"),
            HasSubstr("0.0000 to 80.0000 mm; cutting 0.0000 to 5.0000 mm; rapid 0.0000 to 80.0000 mm")));
  const json program = json::parse(run("check circle.nc --json -").out)["program"];
  EXPECT_EQ(program["bounds"]["min"][1], -50);
  EXPECT_EQ(program["cutting_bounds"]["max"][2], 5);
  EXPECT_EQ(program["rapid_bounds"]["min"][0], 50);
}

TEST_F(CheckCommand, SaysOnceWhatAppliesToManyLines) {
  std::string text = "G21 F100\n";
  for (int i = 0; i < 40; ++i) {
    text += "G1 X" + std::to_string(i) + " X1\n";
  }
  write("twice.nc", text);
  const Result result = run("check twice.nc");
  std::size_t messages = 0;
  for (std::size_t at = result.err.find("[duplicate-word]"); at != std::string::npos;
       at = result.err.find("[duplicate-word]", at + 1)) {
    ++messages;
  }
  EXPECT_EQ(messages, 1U) << result.err;
  EXPECT_THAT(result.err, HasSubstr("also in lines 3, 4, 5"));
  EXPECT_THAT(result.err, HasSubstr("30 more up to line 41"));
}

TEST_F(CheckCommand, ToleranceReplacesTheProgramsOwnAndSaysSo) {
  write("control.ngc", "G21 G64 P0.2\nG1 X10 F3000\nY10\n");
  const Result own = run("simulate control.ngc --machine spinner-mvc850 --json - --blends blends.csv");
  EXPECT_EQ(
      own.err,
      "feedscope: note: The program is written for LinuxCNC, but Spinner MVC 850 has a Siemens Sinumerik "
      "840D: path and times are those of that control. Use machine linuxcnc-mill, whose control "
      "reads it.\n"
      "feedscope: note: Compaction requested by the program is not simulated: "
      "short blocks are not joined.\n");
  EXPECT_NEAR(json::parse(own.out)["max_corner_distance_mm"].get<double>(), 0.16, 1e-9);
  const Result replaced = run("simulate control.ngc --machine spinner-mvc850 --tolerance 0.05 --json -");
  EXPECT_THAT(replaced.err, HasSubstr("note: --tolerance replaces the program's own path control"));
  EXPECT_NEAR(json::parse(replaced.out)["max_corner_distance_mm"].get<double>(), 0.04, 1e-9);
}

TEST_F(CheckCommand, WorkOffsetsComeFromAnOption) {
  write("two.nc", "G21 G90 G54\nG1 X10 Y0 Z0 F600\nG55\nG1 X10 Y0 Z0\n");
  const auto report = [this](const std::string& options) {
    return json::parse(run("check two.nc --dialect fanuc --json - " + options).out);
  };
  const json zero = report("");
  EXPECT_EQ(zero["program"]["bounds"]["max"][0], 10);
  EXPECT_EQ(zero["program"]["work_offsets"].size(), 2U);
  EXPECT_EQ(zero["program"]["work_offsets"][1]["name"], "G55");
  EXPECT_EQ(zero["program"]["work_offsets"][1]["given"], false);
  const json given = report("--offset G54=0,0,0 --offset G55=100,-5.5,0");
  EXPECT_EQ(given["program"]["bounds"]["max"][0], 110);
  EXPECT_EQ(given["program"]["bounds"]["min"][1], -5.5);
  EXPECT_EQ(given["program"]["work_offsets"][1]["given"], true);
  EXPECT_THAT(run("check two.nc --dialect fanuc").out,
              AllOf(HasSubstr("work offsets"), HasSubstr("G55 (line 3): 1 motion, assumed as zero")));
  for (const char* wrong :
       {"G55", "G55=", "G55=1,2", "G55=1,2,3,4", "55=1,2,3", "G55=1,a,3", "G55=1;2", "G55=1;2;3;4"}) {
    expect_wrong_use("check two.nc --offset '" + std::string(wrong) + "'", "--offset");
  }
}

TEST_F(CheckCommand, AnOffsetThatTheProgramSetsWhileItIsInUseIsGiven) {
  write("set.nc", "G21 G90 G54\nG0 X0 Y0 Z5\nG10 L2 P1 X10 Y5 Z0\nG1 Z0 F500\nX20\nG55\nG1 X30\n");
  const json offsets =
      json::parse(run("check set.nc --dialect fanuc --json -").out)["program"]["work_offsets"];
  ASSERT_EQ(offsets.size(), 2U);
  EXPECT_EQ(offsets[0]["given"], true);
  EXPECT_EQ(offsets[1]["given"], false);
}

TEST_F(CheckCommand, SaysWhichOffsetsAndRadiiAreNotUsed) {
  write("two.nc", "G21 G90 G54\nG0 X0 Y0\nG55\nG1 X10 F100\n");
  EXPECT_THAT(run("check two.nc --offset G56=1,2,3").err,
              HasSubstr("note: work offset 'G56' is not used; the program uses: G54, G55"));
  EXPECT_THAT(run("simulate two.nc --offset g55=1,2,3").err, Not(HasSubstr("is not used")));
  EXPECT_THAT(run("compare two.nc --tool 7=3").err,
              HasSubstr("note: the cutter radius of tool '7' is not used; the program uses no cutter radius "
                        "compensation"));
  write("one.nc", "G21 G90\nG1 X10 F100\n");
  EXPECT_THAT(run("simulate one.nc --offset G55=1,2,3").err, HasSubstr("the program uses no work offset"));
}

TEST_F(CheckCommand, TellsWhatHasNoTime) {
  write("part.nc", "G21 G90 G54\nT1 M6\nM3 S100\nG1 X10 F600\nM0\nG28 G91 Z0\nG90 G0 X0 Y0 Z5\nA30\n");
  const json report = json::parse(run("check part.nc --dialect fanuc --json -").out);
  std::map<std::string, int> counts;
  for (const json& item : report["program"]["not_counted"]) {
    counts[item["what"]] = item["count"];
  }
  const std::map<std::string, int> expected{
      {"tool_change", 1}, {"spindle_start", 1}, {"stop", 1}, {"machine_move", 2}, {"other_axis", 1}};
  EXPECT_EQ(counts, expected);
  EXPECT_THAT(run("check part.nc --dialect fanuc").out,
              HasSubstr("1 tool change, 1 spindle start, 1 program stop (M0, M1)"));
}

}  // namespace
}  // namespace feedscope::test
