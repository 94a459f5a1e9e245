#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

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
  const Result result = run("explain stairs.nc --set tool_change_time_s=4");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("What it consists of"), HasSubstr("tool changes"),
                    HasSubstr("Operations by tool"), HasSubstr("tool 2"), HasSubstr("corners: "),
                    HasSubstr("turn 90 deg"), HasSubstr("What would help"),
                    HasSubstr("without pauses of 8.000 s. "), HasSubstr("feedscope simulate ... --")));
}

TEST_F(ExplainCommand, WhatItProposesGainsWhatItSays) {
  const json report = json::parse(run("explain stairs.nc --json -").out);
  EXPECT_EQ(report["format"], (json{{"name", "feedscope-explanation"}, {"version", 1}}));
  std::size_t checked = 0;
  for (const json& change : report["changes"]) {
    if (change["rank"].is_null() || change["options"] == "") {
      continue;
    }
    // Another machine has a default model of its own; the change keeps the one of the run.
    const std::string options =
        change["options"].get<std::string>() + " --model " + report["model"]["id"].get<std::string>();
    if (change["kind"] != "machine") {
      const json simulated = json::parse(run("simulate stairs.nc --json - " + options).out);
      EXPECT_NEAR(simulated["cycle_time_s"].get<double>(), change["cycle_time_s"].get<double>(), 1e-9);
      EXPECT_NEAR(simulated["max_contour_error_mm"].get<double>(),
                  change["max_contour_error_mm"].get<double>(), 1e-9);
      ++checked;
    }
  }
  EXPECT_GE(checked, 1U);
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
