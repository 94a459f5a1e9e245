#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Where sentences break into lines hangs on the lengths of numbers.
std::string in_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// `compare` with --sweep, --within, --operations and --merge.
class StudyCommand : public CommandLine {
 protected:
  void expect_wrong_use(const std::string& arguments, const std::vector<std::string>& parts) const {
    const Result result = run("compare " + arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    for (const std::string& part : parts) {
      EXPECT_THAT(result.err, HasSubstr(part)) << arguments;
    }
  }
};

TEST_F(StudyCommand, RecommendsWithinTheBoundAndSaysWhatLimitsAtBothEnds) {
  const Result result = run("compare corner.nc --model ward --sweep tolerance=0.01:0.16:log5 --within 0.03");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(
      in_one_line(result.out),
      AllOf(HasSubstr("ward on Spinner MVC 850"), HasSubstr("Recommended within 0.03 mm: tolerance 0.02 mm"),
            HasSubstr("contour error 0.0141 mm"), HasSubstr("At tolerance 0.01 mm the time is due to"),
            HasSubstr("; at 0.16 mm to")));
  EXPECT_THAT(
      in_one_line(run("compare corner.nc --model essid --sweep 'tolerance=0.1;0.2' --within 0.001").out),
      HasSubstr(
          "No value has a contour error within 0.001 mm; the smallest is 0.0566 mm at tolerance 0.1 mm"));
}

TEST_F(StudyCommand, AClampingThatTheMachineDoesNotReachIsNeverTheFastest) {
  write("tilt.mpf",
        "G17 G710 G90 G94\nTRAORI\nG0 X0 Y0 Z20 A3=0 B3=0.5 C3=0.866\n"
        "G1 X10 A3=0.3 B3=0.5 C3=0.8 F3000\nG1 X20 A3=0.5 B3=0 C3=0.866\nM30\n");
  const std::string on_machine = "compare tilt.mpf --machine five-axis-table-ac --model essid ";
  const Result study = run(on_machine + "--sweep 'part_angle_x_deg=0;180' --csv tilt.csv --json tilt.json");
  EXPECT_EQ(study.code, 1);
  EXPECT_THAT(study.out, HasSubstr("180   out of reach"));
  EXPECT_THAT(in_one_line(study.out), HasSubstr("Recommended: part_angle_x_deg 0"));
  const json runs = json::parse(contents(folder_ / "tilt.json"))["runs"];
  EXPECT_EQ(runs[0]["fastest"], true);
  EXPECT_EQ(runs[0]["out_of_reach"], false);
  EXPECT_EQ(runs[1]["fastest"], false);
  EXPECT_EQ(runs[1]["out_of_reach"], true);
  EXPECT_EQ(runs[1]["cycle_time_s"], nullptr);
  EXPECT_THAT(contents(folder_ / "tilt.csv"), HasSubstr("five-axis-table-ac,essid,0.01,,,"));
  const Result none = run(on_machine + "--sweep 'part_angle_x_deg=175;180'");
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(in_one_line(none.out),
              AllOf(HasSubstr("No run is possible"), Not(HasSubstr("Recommended")), Not(HasSubstr("*"))));
  const Result plain = run(on_machine + "--set part_angle_x_deg=180");
  EXPECT_EQ(plain.code, 1);
  EXPECT_THAT(plain.out, HasSubstr("out of reach"));
  EXPECT_EQ(run(on_machine + "--set part_angle_x_deg=0").code, 0);
}

TEST_F(StudyCommand, ASettingThatMakesNoDifferenceHasNoFastestValue) {
  const std::string jerk =
      run("compare corner.nc --machine grbl-router --model grbl --sweep 'X.jerk=5;10;20'").out;
  EXPECT_THAT(in_one_line(jerk),
              AllOf(HasSubstr("X.jerk makes no difference to the cycle time: "),
                    HasSubstr("Model grbl limits no jerk and does not use it. The contour error is "),
                    Not(HasSubstr("Recommended")), Not(HasSubstr("*"))));
  // Within the programmed feed; its model uses the velocity.
  const std::string velocity =
      in_one_line(run("compare corner.nc --model essid --sweep 'Z.velocity=10;20'").out);
  EXPECT_THAT(velocity, AllOf(HasSubstr("Z.velocity makes no difference to the cycle time: "),
                              Not(HasSubstr("does not use it")), Not(HasSubstr("Recommended"))));
  // The bound tells them apart.
  EXPECT_THAT(run("compare corner.nc --model essid --sweep 'tolerance=0.02;0.04' --within 0.02").out,
              HasSubstr("Recommended within 0.02 mm"));
}

TEST_F(StudyCommand, WritesJsonWithAllKeysOfCompare) {
  const std::string options = "compare corner.nc --model essid --model ward --json - ";
  const json plain = json::parse(run(options + "--tolerance 0.02").out);
  const json study =
      json::parse(run(options + "--sweep 'tolerance=0.02;0.04' --sweep 'X.jerk=20;50' --within 0.02").out);
  EXPECT_EQ(study["runs"].size(), 8u);
  EXPECT_EQ(study["within_mm"], 0.02);
  EXPECT_EQ(study["sweeps"][1], (json{{"key", "X.jerk"}, {"unit", "m/s3"}, {"values", {20.0, 50.0}}}));
  for (const auto& [key, value] : plain["runs"][0].items()) {
    EXPECT_TRUE(study["runs"][0].contains(key)) << key;
  }
  EXPECT_EQ(study["runs"][1]["swept"], (json{{"tolerance", 0.04}, {"X.jerk", 20.0}}));
  EXPECT_EQ(study["runs"][1]["limits"]["axes"]["X"]["jerk_m_s3"], 20.0);
  std::size_t fastest = 0;
  for (const json& one : study["runs"]) {
    fastest += one["fastest"] ? 1 : 0;
    EXPECT_TRUE(!one["fastest"] || one["max_contour_error_mm"] <= 0.02 + 1e-9);
  }
  EXPECT_GE(fastest, 2u);
}

TEST_F(StudyCommand, DrawsTwoSettingsAsAMap) {
  const std::string two = "corner.nc --model essid --sweep 'tolerance=0.02;0.04' --sweep 'X.jerk=20;50' ";
  EXPECT_EQ(run("compare " + two + "--png map.png").code, 0);
  EXPECT_EQ(run("compare " + two + "--png again.png").code, 0);
  EXPECT_EQ(contents(folder_ / "map.png"), contents(folder_ / "again.png"));
  expect_wrong_use(two + "--png small.png --size 200x100", {"200 x 100 pixels is too small"});
  expect_wrong_use(two + "--sweep Y.jerk=1:100:lin99 --png many.png", {"too many for one picture"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "many.png"));
}

TEST_F(StudyCommand, WritesCsvRowsOfRunsAndOperations) {
  write("two.nc", "(rough)\nG1 X20 F3000\nY20\n(\"fine\", 2)\nX0\nY0\n");
  const Result result =
      run("compare two.nc --model essid --sweep 'tolerance=0.02;0.04' --operations comment --csv -");
  std::istringstream text(result.out);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_THAT(lines[0],
              AllOf(StartsWith("machine,model,tolerance_mm,cycle_time_s,"),
                    HasSubstr(",setting_tolerance,within_bound,fastest,limiting_cause,limiting_share,"
                              "operation,operation_line,cutting_length_mm")));
  EXPECT_THAT(lines[2], HasSubstr(",rough,1,"));
  EXPECT_THAT(lines[3], HasSubstr(",\"\"\"fine\"\", 2\",4,"));
  EXPECT_THAT(run("compare two.nc --model essid --sweep 'tolerance=0.02;0.04' --operations comment").out,
              AllOf(HasSubstr("Operations at tolerance 0.02 mm"), HasSubstr("rough")));
}

TEST_F(StudyCommand, RefusesWhatCannotBeStudied) {
  expect_wrong_use("corner.nc --sweep tolerance", {"'tolerance'", "KEY=FROM:TO:logN"});
  expect_wrong_use("corner.nc --model essid --sweep 'tolerence=0.1;0.2'",
                   {"'tolerence'", "did you mean 'tolerance'?"});
  expect_wrong_use("corner.nc --model essid --sweep tolerance=1:20:log3", {"contour_tolerance_mm", "10 mm"});
  expect_wrong_use("corner.nc --within small", {"--within", "small"});
  expect_wrong_use("corner.nc --operations tools", {"'tools'", "did you mean 'tool'?"});
  expect_wrong_use("", {"no program given"});
}

TEST_F(StudyCommand, MergesResultsOfPrograms) {
  write("other.nc", "G1 X5 F3000\nY5\n");
  for (const std::string name : {"corner", "other"}) {
    ASSERT_EQ(
        run("compare " + name + ".nc --model essid --sweep 'tolerance=0.02;0.04' --json " + name + ".json")
            .code,
        0);
  }
  const Result result = run("compare --merge corner.json other.json --json - --csv all.csv");
  EXPECT_EQ(result.code, 0);
  const json merged = json::parse(result.out);
  ASSERT_EQ(merged["programs"].size(), 2u);
  ASSERT_EQ(merged["sums"].size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const json& sum = merged["sums"][i];
    EXPECT_EQ(sum["programs"], 2);
    const json& first = merged["programs"][0]["runs"][i];
    const json& second = merged["programs"][1]["runs"][i];
    EXPECT_DOUBLE_EQ(sum["cycle_time_s"],
                     first["cycle_time_s"].get<double>() + second["cycle_time_s"].get<double>());
    EXPECT_EQ(sum["setting"], first["setting"]);
  }
  EXPECT_EQ(merged["sums"][1]["setting"], "tolerance=0.04");
  EXPECT_THAT(contents(folder_ / "all.csv"),
              StartsWith("program,machine,model,setting,programs,cycle_time_s,"));
  EXPECT_THAT(run("compare --merge corner.json other.json").out,
              AllOf(HasSubstr("All of 2 programs"), HasSubstr("other.nc")));
}

TEST_F(StudyCommand, NamesFileAndKeyOfWhatCannotBeMerged) {
  ASSERT_EQ(run("compare corner.nc --model essid --json good.json").code, 0);
  ASSERT_EQ(run("simulate corner.nc --json simulated.json").code, 0);
  write("broken.json", "{\"program\": ");
  json wrong = json::parse(contents(folder_ / "good.json"));
  wrong["runs"][0]["cycle_time_s"] = "fast";
  write("wrong.json", wrong.dump());
  write("large.json", "{\"program\": 1e999}");
  write("deep.json", "{\"program\": " + std::string(100000, '[') + std::string(100000, ']') + "}");
  wrong = json::parse(contents(folder_ / "good.json"));
  wrong["program"]["segments"] = -1;
  write("count.json", wrong.dump());
  expect_wrong_use("--merge good.json broken.json", {"'broken.json'", "not valid JSON", "line 1, column"});
  expect_wrong_use("--merge simulated.json", {"'simulated.json'", "'runs' is missing"});
  expect_wrong_use("--merge wrong.json", {"'wrong.json'", "runs[0].cycle_time_s", "\"fast\"", "a number"});
  expect_wrong_use("--merge good.json large.json", {"'large.json'", "a number is too large"});
  expect_wrong_use("--merge deep.json", {"'deep.json'", "nested deeper than 64 levels"});
  expect_wrong_use("--merge count.json", {"'count.json'", "program.segments", "-1", "a whole number from 0"});
  expect_wrong_use("--merge good.json good.json", {"'corner.nc' is also in 'good.json'"});
  expect_wrong_use("--merge none.json", {"none.json"});
  expect_wrong_use("corner.nc --merge good.json", {"corner.nc"});
}

TEST_F(StudyCommand, MarksIncompleteProgramsInTheTableOfAll) {
  write("empty.nc", "(nothing)\n");
  const std::string study = " --model essid --sweep 'tolerance=0.02;0.04' --within 0.02 --json ";
  ASSERT_EQ(run("compare corner.nc" + study + "1.json").code, 0);
  ASSERT_EQ(run("compare wrong.nc" + study + "2.json").code, 1);
  ASSERT_EQ(run("compare empty.nc" + study + "3.json").code, 1);
  const Result text = run("compare --merge 1.json 2.json 3.json");
  EXPECT_THAT(text.out, AllOf(HasSubstr("\n corner.nc\n"), HasSubstr("wrong.nc (1 error, read in part)"),
                              HasSubstr("empty.nc (1 error, read in part; no motion)"),
                              HasSubstr("All of 3 programs, 2 of them incomplete (wrong.nc: 1 error")));
  const json merged = json::parse(run("compare --merge 1.json 2.json 3.json --json -").out);
  EXPECT_EQ(merged["programs"][0]["errors"], 0);
  EXPECT_EQ(merged["programs"][1]["errors"], 1);
  EXPECT_EQ(merged["programs"][2]["segments"], 0);
  std::istringstream csv(run("compare --merge 1.json 2.json 3.json --csv -").out);
  std::string line;
  while (std::getline(csv, line)) {
    EXPECT_EQ(std::ranges::count(line, ','), 11) << line;
    EXPECT_FALSE(line.starts_with(",")) << "a row without a name: " << line;
  }
  EXPECT_THAT(line, testing::IsEmpty());
}

/// Brute force: the fastest setting that keeps the bound in every program.
TEST_F(StudyCommand, FindsTheFastestSettingWithinTheBoundOverAllPrograms) {
  write("other.nc", "G1 X5 F3000\nX10 Y0.1\nY5\n");
  const std::string study = " --model essid --sweep tolerance=0.01:0.16:log5 --json ";
  ASSERT_EQ(run("compare corner.nc" + study + "1.json").code, 0);
  ASSERT_EQ(run("compare other.nc" + study + "2.json --within 0.5").code, 0);
  const std::string merge = "compare --merge 1.json 2.json --json - ";
  EXPECT_TRUE(json::parse(run(merge).out)["within_mm"].is_null())
      << "the two were made with different bounds";
  EXPECT_EQ(json::parse(run("compare --merge 2.json --json -").out)["within_mm"], 0.5);
  for (const double bound : {0.001, 0.012, 0.03, 0.05, 1.0}) {
    const json merged = json::parse(run(merge + "--within " + std::to_string(bound)).out);
    EXPECT_EQ(merged["within_mm"], bound);
    std::string best;
    double least = 1e9;
    for (std::size_t i = 0; i < merged["sums"].size(); ++i) {
      double time = 0, error = 0;
      for (const json& program : merged["programs"]) {
        time += program["runs"][i]["cycle_time_s"].get<double>();
        error = std::max(error, program["runs"][i]["max_contour_error_mm"].get<double>());
      }
      if (error <= bound && time < least) {
        least = time;
        best = merged["sums"][i]["setting"];
      }
    }
    std::string marked;
    for (const json& sum : merged["sums"]) {
      marked += sum["fastest"] ? sum["setting"].get<std::string>() : "";
    }
    EXPECT_EQ(marked, best) << bound;
    const std::string text = run("compare --merge 1.json 2.json --within " + std::to_string(bound)).out;
    EXPECT_THAT(text, HasSubstr(best.empty() ? "No value has" : best)) << bound;
  }
}

TEST_F(StudyCommand, SaysThatNoSettingRanOnAllProgramsWhateverTheBound) {
  write("heidenhain.h", "BEGIN PGM A MM\nL X+10 F3000\nL Y+10\nEND PGM A MM\n");
  run("compare corner.nc --sweep 'tolerance=0.01;0.02' --json iso.json");
  run("compare heidenhain.h --sweep 'tolerance=0.01;0.02' --json heidenhain.json");
  EXPECT_THAT(in_one_line(run("compare --merge iso.json heidenhain.json --within 5").out),
              AllOf(HasSubstr("No setting ran in all 2 programs"), HasSubstr("--machine"),
                    Not(HasSubstr("No value has"))));
}

/// The script of the examples: every way its head names, with programs that cannot be studied among the
/// others.
class NightlyStudy : public StudyCommand {
 protected:
  NightlyStudy() {
    fs::create_directory(folder_ / "programs");
    write("programs/a b.nc", "G1 X20 F3000\nY20\n");
    write("programs/c.nc", "G1 X10 F3000\nfoo\nY10\n");
  }

  /// `arguments` of the script; `before` stands before its name.
  int night(const std::string& arguments, const std::string& before = "") const {
    const std::string line = "cd '" + folder_.string() + "' && FEEDSCOPE='" FEEDSCOPE_EXECUTABLE "' JOBS=2 " +
                             before + " '" + NIGHTLY_SCRIPT "' " + arguments + " > printed.txt 2> errors.txt";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string printed() const { return contents(folder_ / "printed.txt"); }
  std::string errors() const { return contents(folder_ / "errors.txt"); }

  static constexpr const char* sweep = " --model essid --sweep 'tolerance=0.02;0.04'";
};

TEST_F(NightlyStudy, MakesOneTableOfAFolder) {
  ASSERT_EQ(night(std::string("programs results") + sweep), 0) << errors();
  EXPECT_THAT(printed(), HasSubstr("All of 2 programs, 1 of them incomplete"));
  EXPECT_TRUE(fs::exists(folder_ / "results" / "a b.nc.json"));
  const std::string merged = contents(folder_ / "results" / "study.csv");
  ASSERT_EQ(night(std::string("programs by_sh") + sweep, "sh"), 0) << errors();
  EXPECT_EQ(contents(folder_ / "by_sh" / "study.csv"), merged);
  ASSERT_EQ(night(std::string("--job 1 programs array") + sweep), 0) << errors();
  ASSERT_EQ(night(std::string("--job 2 programs array") + sweep), 0) << errors();
  EXPECT_EQ(night(std::string("--job 3 programs array") + sweep), 2);
  ASSERT_EQ(night("--merge array"), 0) << errors();
  EXPECT_EQ(contents(folder_ / "array" / "study.csv"), merged);
  for (const std::string program : {"'programs/a b.nc'", "programs/c.nc"}) {
    ASSERT_EQ(night("--one " + program + " one/by/one" + sweep), 0) << errors();
  }
  ASSERT_EQ(night("--merge one/by/one --within 0.02"), 0) << errors();
  EXPECT_THAT(printed(), HasSubstr("* Fastest within 0.02 mm. Of all 2 programs: essid"));
}

TEST_F(NightlyStudy, ListsWhatCouldNotBeStudiedBesideTheTableOfTheRest) {
  write("programs/d.nc", "G1" + std::string(100, '\0') + "X1");
  EXPECT_EQ(night(std::string("programs results") + sweep), 1);
  EXPECT_THAT(printed(), HasSubstr("All of 2 programs"));
  EXPECT_THAT(errors(), AllOf(HasSubstr("Not studied, and not in the table:"), HasSubstr("  d.nc: "),
                              HasSubstr("is not a text file"), HasSubstr("exit code 2")));
  EXPECT_TRUE(fs::exists(folder_ / "results" / "study.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "results" / "d.nc.failed"));
  // mended the next night, and another one broken: nothing of the night before is shown
  write("programs/d.nc", "G1 X5 F1000\n");
  write("programs/c.nc", "G1" + std::string(100, '\0') + "X1");
  EXPECT_EQ(night(std::string("programs results") + sweep), 1);
  EXPECT_THAT(printed(), AllOf(HasSubstr("d.nc"), Not(HasSubstr("c.nc"))));
  EXPECT_THAT(errors(), AllOf(HasSubstr("  c.nc: "), Not(HasSubstr("  d.nc: "))));
}

TEST_F(NightlyStudy, EndsWithTwoWhereNothingWasStudied) {
  fs::create_directory(folder_ / "none");
  EXPECT_EQ(night("none results"), 2);
  EXPECT_THAT(errors(), HasSubstr("no program was studied"));
  EXPECT_EQ(night("programs results --model nonsense"), 2);
  EXPECT_THAT(errors(), AllOf(HasSubstr("  a b.nc: "), HasSubstr("  c.nc: "), HasSubstr("nonsense")));
  EXPECT_EQ(night(""), 2);
  EXPECT_THAT(errors(), HasSubstr("nightly_study.sh PROGRAMS RESULTS"));
}

}  // namespace
}  // namespace feedscope::test
