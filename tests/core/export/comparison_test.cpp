#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/export/export.h"

namespace feedscope {
namespace {

using Json = nlohmann::ordered_json;

/// A run with round figures on a machine of round limits.
ComparedRun sample(const std::string& model, Cause cause) {
  ComparedRun run;
  run.setup.machine.id = "mine, \"new\"";
  for (AxisLimits& axis : run.setup.machine.axes) {
    axis = {100, 1000, 20000, 10000};
  }
  run.setup.model = &find_model(model);
  run.setup.settings = complete_settings(*run.setup.model, run.setup.machine);
  run.summary.cycle_time = 3;
  run.summary.programmed_time = 2;
  run.summary.mean_feed = 0.5;
  run.summary.peak_feed = 1;
  run.summary.axes[0] = {50, 2000, 5000};
  run.summary.time_by_cause.assign(all_causes().size(), 0);
  run.summary.time_by_cause[cause_index(cause)] = 3;
  return run;
}

std::vector<ComparedRun> samples() {
  std::vector<ComparedRun> runs{sample("cam", {CauseKind::programmed_feed}),
                                sample("essid", {CauseKind::axis_jerk, 1})};
  runs[1].setup.settings.set("contour_tolerance_mm", 0.1);
  runs[1].tolerance = ToleranceInForce{0.05, 0.05, ToleranceInForce::Setter::program};
  runs[1].summary.max_contour_error = 0.04;
  runs[1].summary.cutting_contour_error = 0.03;
  runs[1].blends = 7;
  return runs;
}

TEST(ComparisonCsv, HoldsARowEachRunInUnitsOfItsColumns) {
  const std::string axes =
      "vx_mm_min,ax_m_s2,jx_m_s3,vx_share,ax_share,jx_share,"
      "vy_mm_min,ay_m_s2,jy_m_s3,vy_share,ay_share,jy_share,"
      "vz_mm_min,az_m_s2,jz_m_s3,vz_share,az_share,jz_share";
  const std::string peaks = "3000,2,5,0.5,2,0.25,0,0,0,0,0,0,0,0,0,0,0,0";
  EXPECT_EQ(comparison_csv(samples()),
            "machine,model,tolerance_mm,cycle_time_s,programmed_time_s,against_cam,mean_feed_mm_min,"
            "peak_feed_mm_min,max_contour_error_mm,blends,tolerance_min_mm,tolerance_max_mm,tolerance_set_by,"
            "max_contour_error_cutting_mm," +
                axes + ",time_programmed_feed_s,time_axis_jerk_y_s\n" +
                "\"mine, \"\"new\"\"\",cam,,3,2,1.5,30,60,0,0,,,,0," + peaks + ",3,0\n" +
                "\"mine, \"\"new\"\"\",essid,0.05,3,2,1.5,30,60,0.04,7,0.05,0.05,program,0.03," + peaks +
                ",0,3\n");
}

TEST(ComparisonJson, HoldsEveryRunWithTheKeysOfASimulation) {
  const auto program =
      load_program(std::make_shared<const SourceText>("corner.nc", "G21 G1 X20 F3000\nfoo\nY20\n"));
  const Json json = Json::parse(comparison_json(program, samples()));
  EXPECT_EQ(json["program"]["file"], "corner.nc");
  EXPECT_EQ(json["diagnostics"].size(), 1u);
  ASSERT_EQ(json["runs"].size(), 2u);
  const Json& run = json["runs"][1];
  EXPECT_EQ(run["machine"]["id"], "mine, \"new\"");
  EXPECT_EQ(run["model"]["id"], "essid");
  EXPECT_EQ(run["settings"]["contour_tolerance_mm"], 0.1);
  EXPECT_EQ(run["tolerance_in_force_mm"], Json::parse(R"({"min": 0.05, "max": 0.05})"));
  EXPECT_EQ(run["tolerance_set_by"], "program");
  EXPECT_EQ(run["notes"], Json::array());
  EXPECT_TRUE(json["runs"][0]["tolerance_in_force_mm"].is_null());
  EXPECT_EQ(run["cycle_time_s"], 3);
  EXPECT_EQ(run["against_cam"], 1.5);
  EXPECT_EQ(run["blends"], 7);
  EXPECT_EQ(run["peaks"]["axes"]["X"]["acceleration_m_s2"], 2);
  EXPECT_EQ(run["limits"]["axes"]["X"]["acceleration_m_s2"], 1);
  EXPECT_EQ(run["time_by_cause_s"], Json::parse(R"({"axis_jerk_y": 3.0})"));
}

}  // namespace
}  // namespace feedscope
