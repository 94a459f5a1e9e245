#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ExplainCommand : public CommandLine {
 protected:
  ExplainCommand() {
    std::string program = "G21 G90\nT1 M6\nG0 X0 Y0\n";
    for (int i = 1; i <= 20; ++i) {
      program += "G1 X" + std::to_string(5 * i) + " F6000\nY" + std::to_string(3 * i) + "\n";
    }
    write("stairs.nc", program + "T2 M6\nG1 X0 Y0 F3000\nM30\n");
  }
};

TEST_F(ExplainCommand, SaysWhereTheTimeGoesAndWhatHelps) {
  Result result = run("explain stairs.nc --set tool_change_time_s=4");
  EXPECT_EQ(result.code, 0) << result.err;
  std::ranges::replace(result.out, '\n', ' ');
  EXPECT_THAT(result.out, AllOf(HasSubstr("What it consists of"), HasSubstr("tool changes"),
                                HasSubstr("Operations by tool"), HasSubstr("tool 2"), HasSubstr("corners: "),
                                HasSubstr("turn 90 deg"), HasSubstr("What would help"),
                                HasSubstr("without pauses of 8.000 s. "),
                                HasSubstr("feedscope simulate stairs.nc --set tool_change_time_s=4 --")));
}

TEST_F(ExplainCommand, SaysThatTheProgrammedTimeHasAFeedOverride) {
  const std::string words = "Programmed means with the feed override of 80 %.";
  std::string out = run("explain stairs.nc --set feed_override_percent=80").out;
  std::ranges::replace(out, '\n', ' ');
  EXPECT_THAT(out, HasSubstr(words));
  EXPECT_THAT(run("explain stairs.nc").out, testing::Not(HasSubstr("feed override of")));
  EXPECT_THAT(run("explain stairs.nc --set feed_override_percent=100").out,
              testing::Not(HasSubstr("feed override of")));
}

TEST_F(ExplainCommand, SaysWhatItsShareIsOf) {
  const json report = json::parse(run("explain stairs.nc --json -").out);
  const double lost = report["lost_s"];
  const double cycle_time = report["cycle_time_s"];
  std::string out = run("explain stairs.nc").out;
  std::ranges::replace(out, '\n', ' ');
  EXPECT_THAT(out, HasSubstr(fmt::format("({:.1f} % of the cycle time; {:.2f} times the programmed time)",
                                         100 * lost / cycle_time, cycle_time / (cycle_time - lost))));
}

TEST_F(ExplainCommand, OfAProgramWithoutMotionItSaysOnlyThat) {
  write("nothing.nc", "(nothing)\nM30\n");
  EXPECT_THAT(run("explain nothing.nc").out, AllOf(HasSubstr("Nothing in this program takes time."),
                                                   Not(HasSubstr("changes")), Not(HasSubstr("What"))));
}

TEST_F(ExplainCommand, WhatItProposesGainsWhatItSays) {
  const json report = json::parse(run("explain stairs.nc --json -").out);
  EXPECT_EQ(report["format"], (json{{"name", "feedscope-explanation"}, {"version", 1}}));
  std::size_t checked = 0;
  bool has_machine = false;
  for (const json& change : report["changes"]) {
    if (change["rank"].is_null() || change["options"] == "") {
      continue;
    }
    const json simulated =
        json::parse(run("simulate stairs.nc --json - " + change["options"].get<std::string>()).out);
    EXPECT_NEAR(simulated["cycle_time_s"].get<double>(), change["cycle_time_s"].get<double>(), 1e-9);
    EXPECT_NEAR(simulated["max_contour_error_mm"].get<double>(), change["max_contour_error_mm"].get<double>(),
                1e-9);
    ++checked;
    has_machine = has_machine || change["kind"] == "machine";
  }
  EXPECT_GE(checked, 2U);
  EXPECT_TRUE(has_machine);
}

TEST_F(ExplainCommand, TheCommandsThatItPrintsGiveWhatItSays) {
  for (const std::string asked :
       {"", " --model tapie --tolerance 0.02 --set X.jerk=12", " --set contour_tolerance_mm=0.03"}) {
    const std::string explained = "explain stairs.nc" + asked;
    const json report = json::parse(run(explained + " --json -").out);
    std::istringstream lines(run(explained).out);
    std::vector<std::string> commands;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("  feedscope ")) {
        commands.push_back(line.substr(std::string("  feedscope ").size()));
      }
    }
    std::size_t next = 0;
    for (int rank = 1; rank <= 3; ++rank) {
      for (const json& change : report["changes"]) {
        if (change["rank"] != rank || change["options"] == "") {
          continue;
        }
        ASSERT_LT(next, commands.size()) << explained;
        const json simulated = json::parse(run(commands[next++] + " --json -").out);
        EXPECT_NEAR(simulated["cycle_time_s"].get<double>(), change["cycle_time_s"].get<double>(), 1e-9)
            << commands[next - 1];
        EXPECT_NEAR(simulated["max_contour_error_mm"].get<double>(),
                    change["max_contour_error_mm"].get<double>(), 1e-9)
            << commands[next - 1];
      }
    }
    EXPECT_EQ(next, commands.size()) << explained;
    EXPECT_GE(next, 1U) << explained;
  }
}

/// In another folder than the session's, with a program whose name a shell would take apart.
TEST_F(ExplainCommand, TheCommandsOfASessionNameItsProgramAndHowItIsRead) {
  fs::create_directories(folder_ / "kept");
  fs::copy(folder_ / "stairs.nc", folder_ / "kept" / "part 7's steps.nc");
  write("kept/part.feedscope", R"({"format": "feedscope-session", "version": 1,
    "program": {"file": "part 7's steps.nc"},
    "reading": {"dialect": "fanuc", "unit": "mm", "cutter_radii_mm": {"1": 5}, "work_offsets_mm": {"G55": [1, 2.5, -3]}},
    "runs": [{"machine": "spinner-mvc850", "model": "essid", "name": "one", "colour": "#0072b2",
              "set": {"contour_tolerance_mm": 0.05}}]})");
  const Result result = run("explain kept/part.feedscope");
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr(" --dialect fanuc --unit mm --tool 1=5 --offset G55=1,2.5,-3 --machine "),
                    Not(HasSubstr("..."))));
  std::istringstream lines(result.out);
  std::size_t commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  feedscope ")) {
      ++commands;
      EXPECT_EQ(run(line.substr(std::string("  feedscope ").size())).code, 0) << line;
    }
  }
  EXPECT_GE(commands, 1U);
}

TEST_F(ExplainCommand, SaysWhyThePlacesAddUpToAnotherTotal) {
  const std::string out = run("explain stairs.nc").out;
  EXPECT_THAT(out, AllOf(HasSubstr("path shorter than programmed"),
                         HasSubstr("All of this is lost along the path against its programmed feed"),
                         HasSubstr("(path shorter than programmed)")));
  write("line.nc", "G21 G90 F3000\nG1 X50\nM30\n");
  EXPECT_THAT(run("explain line.nc").out, Not(HasSubstr("All of this is lost")));
}

TEST_F(ExplainCommand, ABlendAtTheLowerFeedIsNoLongerPath) {
  write("slow.nc", "G21 G90 F6000\nG1 X50 F10\nY50 F6000\nM30\n");
  EXPECT_THAT(run("explain slow.nc").out,
              AllOf(HasSubstr("path at a lower programmed feed"), Not(HasSubstr("longer"))));
}

TEST_F(ExplainCommand, PartsAddUpToTheCycleTime) {
  const json report = json::parse(run("explain stairs.nc --json - --set tool_change_time_s=4").out);
  const double cycle_time = report["cycle_time_s"];
  const auto sum = [](const json& list, const char* key) {
    double total = 0;
    for (const json& entry : list) {
      total += entry[key].get<double>();
    }
    return total;
  };
  EXPECT_NEAR(sum(report["time_by_kind"], "time_s"), cycle_time, 1e-9);
  EXPECT_NEAR(sum(report["causes"], "time_s"), cycle_time, 1e-9);
  EXPECT_NEAR(sum(report["operations"], "time_s"), cycle_time, 1e-9);
  EXPECT_NEAR(sum(report["causes"], "lost_s") - report["saved_by_path_s"].get<double>(),
              report["lost_s"].get<double>(), 1e-9);
  EXPECT_EQ(report["operations_by"], "tool");
}

TEST_F(ExplainCommand, WrongUseIsSaid) {
  expect_wrong_use("explain stairs.nc --operations tol", "did you mean 'tool'");
  expect_wrong_use("explain stairs.nc --run 2", "is not a session");
  expect_wrong_use("explain stairs.nc --json stairs.nc", "stairs.nc");
  EXPECT_EQ(run("explain wrong.nc").code, 1);
}

}  // namespace
}  // namespace feedscope::test
