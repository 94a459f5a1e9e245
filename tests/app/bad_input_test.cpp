#include <nlohmann/json.hpp>

#include "core/models/control_model.h"
#include "tests/app/command_line.h"
#include "tests/support/folders.h"

namespace {

using feedscope::test::contents;
using feedscope::test::Result;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Input at the edge of sense: a clear message, or the exact limit case; with every model.
class BadInput : public feedscope::test::CommandLine {
 protected:
  /// Figures of `arguments` with every model; the call must end with `code`.
  template <typename F>
  void with_every_model(const std::string& arguments, int code, F check) const {
    for (const feedscope::ControlModel* model : feedscope::all_models()) {
      const std::string& id = model->info().id;
      const Result result = run("simulate " + arguments + " --json - --model " + id);
      ASSERT_EQ(result.code, code) << id << ": " << result.err;
      check(id, json::parse(result.out));
    }
  }

  std::string machine_with(const std::string& from, const std::string& to) const {
    std::string text = contents(fs::path(FEEDSCOPE_SOURCE_DIR) / "machines" / "spinner-mvc850.toml");
    return text.replace(text.find(from), from.size(), to);
  }
};

TEST_F(BadInput, ANegativeToleranceIsNamedWithItsBound) {
  expect_wrong_use("simulate corner.nc --tolerance -0.01",
                   "--tolerance = -0.01 is out of bounds; it must be at least 0 mm");
  expect_wrong_use("simulate corner.nc --set contour_tolerance_mm=-0.01",
                   "contour_tolerance_mm = -0.01 is out of bounds; it must be 0, or at least 0.000001 mm and "
                   "at most 10 mm");
}

TEST_F(BadInput, AToleranceOfZeroStopsInEveryCorner) {
  write("leg.nc", "G1 X20 F3000\n");
  const auto leg = [this](const std::string& id) {
    const Result result = run("simulate leg.nc --json - --tolerance 0 --model " + id);
    return json::parse(result.out)["cycle_time_s"].get<double>();
  };
  with_every_model("corner.nc --tolerance 0", 0, [&](const std::string& id, const json& report) {
    if (id == "grbl" || id == "klipper" || id == "linuxcnc") {  // which have rules of their own for corners
      return;
    }
    EXPECT_NEAR(report["cycle_time_s"].get<double>(), 2 * leg(id), 1e-9) << id;
    EXPECT_LE(report["max_contour_error_mm"].get<double>(), 1e-9) << id;
  });
}

TEST_F(BadInput, AToleranceLargerThanThePartLeavesHalfOfEveryBlock) {
  write("tiny.nc", "G1 X0.02 F3000\nY0.02\nX0\n");
  with_every_model("tiny.nc --set X.jerk=15 --tolerance 10", 0,
                   [](const std::string& id, const json& report) {
                     EXPECT_GT(report["cycle_time_s"].get<double>(), 0.0009) << id;
                     EXPECT_LE(report["max_contour_error_mm"].get<double>(), 0.02) << id;
                   });
}

TEST_F(BadInput, AnAxisLimitOfZeroOrNoneIsNamedWithItsPlace) {
  expect_wrong_use("simulate corner.nc --set X.jerk=0",
                   "X.jerk = 0 is out of bounds; it must be at least 0.000001 m/s3");
  write("zero.toml", machine_with("acceleration_m_s2 = { value = 1,", "acceleration_m_s2 = { value = 0,"));
  expect_wrong_use("simulate corner.nc --machine zero.toml", "zero.toml:9:");
  write("none.toml", machine_with("velocity_m_min = { value = 20, source = \"Essid 2019, table 2\" }\n", ""));
  expect_wrong_use("simulate corner.nc --machine none.toml", "velocity_m_min");
}

TEST_F(BadInput, AFilterJerkOfZeroIsThatOfTheAxes) {
  const auto cycle = [this](const std::string& jerk) {
    return json::parse(
        run("simulate corner.nc --json - --model ward --set filter_jerk_m_s3=" + jerk).out)["cycle_time_s"];
  };
  EXPECT_EQ(cycle("0"), cycle("15"));
}

TEST_F(BadInput, SevenFiltersAreNamedWithTheirBounds) {
  expect_wrong_use("simulate corner.nc --model ward --set filters=7",
                   "filters = 7 is out of bounds; it must be a whole number at least 2 and at most 3");
}

TEST_F(BadInput, AFilterTimeLongerThanTheProgramIsAddedToIt) {
  const Result result = run(
      "simulate corner.nc --json - --model ward --set enforce=off --set filters=2 --set filter_time_s=10");
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_GT(json::parse(result.out)["cycle_time_s"].get<double>(), 20);
}

TEST_F(BadInput, OneBlockAndNoneRunWithEveryModel) {
  write("one.nc", "G1 X20 F3000\n");
  write("none.nc", "(nothing)\n");
  with_every_model("one.nc", 0, [](const std::string& id, const json& report) {
    EXPECT_GE(report["cycle_time_s"].get<double>(), 0.4 - 1e-12) << id;
  });
  with_every_model("none.nc", 1, [](const std::string& id, const json& report) {
    EXPECT_EQ(report["cycle_time_s"], 0) << id;
  });
}

TEST_F(BadInput, AMillionIdenticalPointsAreOne) {
  std::string text = "G1 X20 F3000\n";
  for (int i = 0; i < 1000000; ++i) {
    text += "X20\n";
  }
  write("points.nc", text);
  const Result result = run("simulate points.nc --json -");
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["program"]["segments"], 1);
}

}  // namespace
