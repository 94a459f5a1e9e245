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

TEST_F(StudyCommand, SaysTheFastestWithinTheBoundAndWhatLimitsAtBothEnds) {
  const Result result = run("compare corner.nc --model ward --sweep tolerance=0.01:0.16:log5 --within 0.03");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(
      in_one_line(result.out),
      AllOf(HasSubstr("ward on Spinner MVC 850"), HasSubstr("Fastest within 0.03 mm: tolerance 0.04 mm"),
            HasSubstr("contour error 0.0283 mm"), HasSubstr("At tolerance 0.01 mm the time is due to"),
            HasSubstr("; at 0.16 mm to")));
  EXPECT_THAT(
      in_one_line(run("compare corner.nc --model essid --sweep tolerance=0.1,0.2 --within 0.001").out),
      HasSubstr("No setting keeps a contour error of 0.001 mm; the least is 0.0566 mm at tolerance 0.1 mm"));
}

TEST_F(StudyCommand, WritesJsonWithAllKeysOfCompare) {
  const std::string options = "compare corner.nc --model essid --model ward --json - ";
  const json plain = json::parse(run(options + "--tolerance 0.02").out);
  const json study =
      json::parse(run(options + "--sweep tolerance=0.02,0.04 --sweep X.jerk=20,50 --within 0.02").out);
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

TEST_F(StudyCommand, WritesCsvRowsOfRunsAndOperations) {
  write("two.nc", "(rough)\nG1 X20 F3000\nY20\n(\"fine\", 2)\nX0\nY0\n");
  const Result result =
      run("compare two.nc --model essid --sweep tolerance=0.02,0.04 --operations comment --csv -");
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
  EXPECT_THAT(run("compare two.nc --model essid --sweep tolerance=0.02,0.04 --operations comment").out,
              AllOf(HasSubstr("Operations at tolerance 0.02 mm"), HasSubstr("rough")));
}

TEST_F(StudyCommand, RefusesWhatCannotBeStudied) {
  expect_wrong_use("corner.nc --sweep tolerance", {"'tolerance'", "KEY=FROM:TO:logN"});
  expect_wrong_use("corner.nc --model essid --sweep tolerence=0.1,0.2",
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
        run("compare " + name + ".nc --model essid --sweep tolerance=0.02,0.04 --json " + name + ".json")
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
  expect_wrong_use("--merge good.json broken.json", {"'broken.json'", "no JSON", "line 1, column"});
  expect_wrong_use("--merge simulated.json", {"'simulated.json'", "'runs' is missing"});
  expect_wrong_use("--merge wrong.json", {"'wrong.json'", "runs[0].cycle_time_s", "\"fast\"", "a number"});
  expect_wrong_use("--merge good.json good.json", {"'corner.nc' is in 'good.json', too"});
  expect_wrong_use("--merge none.json", {"none.json"});
  expect_wrong_use("corner.nc --merge good.json", {"corner.nc"});
}

TEST_F(StudyCommand, StudiesAFolderOvernight) {
  fs::create_directory(folder_ / "programs");
  write("programs/a b.nc", "G1 X20 F3000\nY20\n");
  write("programs/c.nc", "G1 X10 F3000\nfoo\nY10\n");
  const std::string script =
      "cd '" + folder_.string() + "' && FEEDSCOPE='" FEEDSCOPE_EXECUTABLE "' JOBS=2 '" + NIGHTLY_SCRIPT "' ";
  const std::string sweep = " --model essid --sweep tolerance=0.02,0.04 > printed.txt 2> errors.txt";
  ASSERT_EQ(std::system((script + "programs results" + sweep).c_str()), 0)
      << contents(folder_ / "errors.txt");
  EXPECT_THAT(contents(folder_ / "printed.txt"), HasSubstr("All of 2 programs"));
  EXPECT_TRUE(fs::exists(folder_ / "results" / "a b.nc.json"));
  const std::string merged = contents(folder_ / "results" / "study.csv");
  ASSERT_EQ(std::system((script + "--job 1 programs array" + sweep).c_str()), 0);
  ASSERT_EQ(std::system((script + "--job 2 programs array" + sweep).c_str()), 0);
  ASSERT_EQ(std::system((script + "--merge array > printed.txt").c_str()), 0);
  EXPECT_EQ(contents(folder_ / "array" / "study.csv"), merged);
}

}  // namespace
}  // namespace feedscope::test
