#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/export/export.h"

namespace feedscope {
namespace {

using Json = nlohmann::ordered_json;

struct Sample {
  Program program;
  Toolpath toolpath;
  Machine machine;
  ModelInfo model;
  Settings settings;
  Summary summary;

  Sample() {
    program.source = std::make_shared<const SourceText>("part \"1\".nc", "G1 X3 F60\nfoo\n");
    program.block_count = 2;
    program.bounds.add(Vec3(0, 0, 0));
    program.bounds.add(Vec3(3, 0, 0));
    program.cutting_bounds.add(Vec3(1, 0, 0));
    program.rapid_bounds.add(Vec3(2, 0, 0));
    program.diagnostics = {{Severity::error, 2, 1, "unread", "\"foo\" is no word", "hint"}};
    toolpath.segments.resize(1);
    toolpath.segments[0].length = 3;
    machine.id = "test";
    machine.name = "Test machine";
    model.id = "cam";
    model.title = "Title";
    model.reference = "Paper";
    settings.set("alpha", 0.1);
    settings.set("reading", std::string("strict"));
    summary.cycle_time = 3.25;
    summary.programmed_time = 3;
    summary.mean_feed = 0.5;
    summary.max_contour_error = 0.08;
    summary.max_corner_distance = 0.11;
    summary.worst_place = {0.08, -0.05, 0.5, 7, 4, 1, {1, 2, 3}, {1, 2, 2.92}};
    summary.peak_feed = 1;
    summary.axes[1] = {2, 3000, 4000};
    summary.time_by_cause.assign(all_causes().size(), 0);
    summary.time_by_cause[cause_index({CauseKind::axis_jerk, 1})] = 2;
    summary.time_by_cause[cause_index({CauseKind::ramp_down})] = 1.25;
    summary.time_by_slower_place.assign(all_causes().size(), 0);
    summary.time_by_slower_place[cause_index({CauseKind::exact_stop})] = 1.25;
  }
  std::string text() const {
    return simulation_json({program, toolpath, machine, model, settings, summary, 0.5, 0.25});
  }
};

TEST(SimulationJson, HoldsTheKeysOfTheDesignInTheirOrder) {
  const Json expected = Json::parse(R"({
    "program": {"file": "part \"1\".nc", "lines": 2, "dialect": "iso",
                "unit": {"name": "mm", "said_by": "nobody"}, "blocks": 2, "segments": 1, "path_mm": 3.0,
                "bounds": {"min": [0.0, 0.0, 0.0], "max": [3.0, 0.0, 0.0]},
                "cutting_bounds": {"min": [1.0, 0.0, 0.0], "max": [1.0, 0.0, 0.0]},
                "rapid_bounds": {"min": [2.0, 0.0, 0.0], "max": [2.0, 0.0, 0.0]}},
    "machine": {"id": "test", "name": "Test machine", "control": ""},
    "model": {"id": "cam", "title": "Title", "reference": "Paper"},
    "settings": {"alpha": 0.1, "reading": "strict"},
    "tolerance_in_force_mm": null, "tolerance_set_by": null, "notes": [],
    "cycle_time_s": 3.25,
    "programmed_time_s": 3.0,
    "mean_feed_mm_min": 30.0,
    "max_contour_error_mm": 0.08,
    "max_corner_distance_mm": 0.11,
    "max_contour_error_at": {"line": 4, "time_s": 0.5, "position_mm": [1.0, 2.0, 3.0], "side_mm": -0.05},
    "peaks": {"feed_mm_min": 60.0,
              "axes": {"X": {"velocity_mm_min": 0.0, "acceleration_m_s2": 0.0, "jerk_m_s3": 0.0},
                       "Y": {"velocity_mm_min": 120.0, "acceleration_m_s2": 3.0, "jerk_m_s3": 4.0},
                       "Z": {"velocity_mm_min": 0.0, "acceleration_m_s2": 0.0, "jerk_m_s3": 0.0}}},
    "time_by_cause_s": {"axis_jerk_y": 2.0, "ramp_down": 1.25},
    "ramp_down_by_slower_place_s": {"exact_stop": 1.25},
    "diagnostics": [{"severity": "error", "line": 2, "column": 1, "code": "unread",
                     "message": "\"foo\" is no word", "hint": "hint"}],
    "elapsed": {"read_s": 0.5, "simulate_s": 0.25}})");
  EXPECT_EQ(Sample().text(), expected.dump(2) + "\n");
}

TEST(SimulationJson, KeepsEveryDigit) {
  Sample sample;
  sample.summary.cycle_time = 0.1 + 0.2;
  EXPECT_EQ(Json::parse(sample.text())["cycle_time_s"].get<double>(), 0.1 + 0.2);
}

TEST(SimulationJson, GivesNullWhereThereIsNoNumber) {
  Sample sample;
  sample.program.bounds = Bounds();
  sample.summary.mean_feed = std::numeric_limits<double>::quiet_NaN();
  const Json json = Json::parse(sample.text());
  EXPECT_EQ(json["program"]["bounds"]["min"], Json::parse("[null, null, null]"));
  EXPECT_TRUE(json["mean_feed_mm_min"].is_null());
}

TEST(SimulationJson, SurvivesBytesThatAreNoUtf8) {
  Sample sample;
  sample.program.source = std::make_shared<const SourceText>("a\xff.nc", "");
  sample.program.diagnostics[0].message = "word '\xfc'";
  EXPECT_NO_THROW(Json::parse(sample.text()));
}

TEST(CheckJson, HoldsFactsAndDiagnostics) {
  const Sample sample;
  ProgramFacts facts;
  facts.lines = 2;
  facts.segments = 3;
  facts.arcs = 1;
  facts.rapid_length = 1.5;
  facts.least_feed = 1;
  facts.largest_feed = 10;
  const Json json = Json::parse(check_json(sample.program, facts));
  EXPECT_EQ(json["program"]["file"], "part \"1\".nc");
  EXPECT_EQ(json["program"]["lines"], 2);
  EXPECT_EQ(json["program"]["segments"], 3);
  EXPECT_EQ(json["program"]["arcs"], 1);
  EXPECT_EQ(json["program"]["rapid_mm"], 1.5);
  EXPECT_EQ(json["program"]["feed_mm_min"], Json::parse(R"({"min": 60.0, "max": 600.0})"));
  EXPECT_EQ(json["diagnostics"].size(), 1U);
}

}  // namespace
}  // namespace feedscope
