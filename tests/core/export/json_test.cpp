#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/export/export.h"

namespace feedscope {
namespace {

using Json = nlohmann::ordered_json;

/// A program of two lines, and a run with round figures.
struct Sample {
  Program program;
  Toolpath toolpath;
  ComparedRun run;

  Sample() {
    program.source = std::make_shared<const SourceText>("part \"1\".nc", "G1 X3 F60\nfoo\n");
    program.block_count = 2;
    program.bounds.add(Vec3(0, 0, 0));
    program.bounds.add(Vec3(3, 0, 0));
    program.cutting_bounds.add(Vec3(1, 0, 0));
    program.rapid_bounds.add(Vec3(2, 0, 0));
    program.diagnostics = {{Severity::error, 2, 1, "unread", Message::as_written("\"foo\" is not a word"),
                            Message::as_written("hint")}};
    toolpath.segments.resize(1);
    toolpath.segments[0].length = 3;
    toolpath.segments[0].feed = 1;
    Machine& machine = run.setup.machine;
    machine.id = "test";
    machine.name = "Test machine";
    for (AxisLimits& axis : machine.axes) {
      axis = {100, 1000, 20000, 10000};
    }
    run.setup.model = &find_model("cam");
    run.setup.settings.set("alpha", 0.1);
    run.setup.settings.set("reading", std::string("strict"));
    run.path_length = 2.5;
    run.blends = 7;
    run.simulate_time = 0.25;
    Summary& summary = run.summary;
    summary.cycle_time = 3.75;
    summary.programmed_time = 3;
    summary.mean_feed = 0.5;
    summary.max_contour_error = 0.08;
    summary.cutting_contour_error = 0.06;
    summary.max_corner_distance = 0.11;
    summary.worst_place = {0.08, -0.05, 0.5, 7, 4, 1, {1, 2, 3}, {1, 2, 2.92}};
    summary.peak_feed = 1;
    summary.axes[1] = {2, 3000, 4000};
    summary.time_by_cause.assign(all_causes().size(), 0);
    summary.time_by_cause[cause_index({CauseKind::axis_jerk, 1})] = 2.5;
    summary.time_by_cause[cause_index({CauseKind::ramp_down})] = 1.25;
    summary.time_by_slower_place.assign(all_causes().size(), 0);
    summary.time_by_slower_place[cause_index({CauseKind::exact_stop})] = 1.25;
  }
  LoadedProgram loaded() const {
    LoadedProgram loaded;
    loaded.program = std::make_shared<const Program>(program);
    loaded.toolpath = std::make_shared<const Toolpath>(toolpath);
    loaded.read_time = 0.5;
    return loaded;
  }
  Run whole() const {
    Run whole;
    whole.input = loaded();
    return whole;
  }
  std::string text() const { return simulation_json(whole(), run); }
};

TEST(SimulationJson, HoldsTheKeysOfTheDesignInTheirOrder) {
  Json expected = Json::parse(R"({
    "format": {"name": "feedscope-simulation", "version": 1},
    "program": {"file": "part \"1\".nc", "lines": 2, "dialect": "iso",
                "unit": {"name": "mm", "said_by": "nobody"}, "blocks": 2, "segments": 1, "arcs": 0,
                "dwells": 0, "path_mm": 3.0, "rapid_mm": 0.0, "dwell_s": 0.0,
                "feed_mm_min": {"min": 60.0, "max": 60.0}, "chord_error_mm": null, "chord_error_lines": 0, "tools": [], "cutters": [],
                "work_offsets": [], "calls": 0, "not_counted": [],
                "path_control": "?",
                "bounds": {"min": [0.0, 0.0, 0.0], "max": [3.0, 0.0, 0.0]},
                "cutting_bounds": {"min": [1.0, 0.0, 0.0], "max": [1.0, 0.0, 0.0]},
                "rapid_bounds": {"min": [2.0, 0.0, 0.0], "max": [2.0, 0.0, 0.0]}},
    "machine": {"id": "test", "name": "Test machine", "control": ""},
    "model": {"id": "cam", "title": "?", "reference": "?"},
    "settings": {"alpha": 0.1, "reading": "strict"},
    "limits": {"axes": {"X": {"velocity_mm_min": 6000.0, "acceleration_m_s2": 1.0, "jerk_m_s3": 20.0},
                        "Y": {"velocity_mm_min": 6000.0, "acceleration_m_s2": 1.0, "jerk_m_s3": 20.0},
                        "Z": {"velocity_mm_min": 6000.0, "acceleration_m_s2": 1.0, "jerk_m_s3": 20.0}}},
    "tolerance_in_force_mm": null, "tolerance_set_by": null, "notes": [], "lines_not_run": 0, "out_of_reach": false,
    "cycle_time_s": 3.75,
    "programmed_time_s": 3.0,
    "against_cam": 1.25,
    "mean_feed_mm_min": 30.0,
    "path_mm": 2.5,
    "blends": 7,
    "max_contour_error_mm": 0.08,
    "max_contour_error_cutting_mm": 0.06,
    "max_corner_distance_mm": 0.11,
    "max_contour_error_at": {"line": 4, "time_s": 0.5, "position_mm": [1.0, 2.0, 3.0], "side_mm": -0.05},
    "peaks": {"feed_mm_min": 60.0,
              "axes": {"X": {"velocity_mm_min": 0.0, "acceleration_m_s2": 0.0, "jerk_m_s3": 0.0},
                       "Y": {"velocity_mm_min": 120.0, "acceleration_m_s2": 3.0, "jerk_m_s3": 4.0},
                       "Z": {"velocity_mm_min": 0.0, "acceleration_m_s2": 0.0, "jerk_m_s3": 0.0}}},
    "time_by_cause_s": {"axis_jerk_y": 2.5, "ramp_down": 1.25},
    "ramp_down_by_slower_place_s": {"exact_stop": 1.25},
    "not_counted": [], "drives": null, "actual": null, "load": null,
    "diagnostics": [{"severity": "error", "line": 2, "column": 1, "code": "unread",
                     "message": "\"foo\" is not a word", "hint": "hint"}],
    "elapsed": {"read_s": 0.5, "simulate_s": 0.25}})");
  const Json written = Json::parse(Sample().text());
  expected["program"]["path_control"] = written["program"]["path_control"];
  expected["model"]["title"] = find_model("cam").info().title;
  expected["model"]["reference"] = find_model("cam").info().reference;
  EXPECT_EQ(Sample().text(), expected.dump(2) + "\n");
}

TEST(SimulationJson, KeepsEveryDigit) {
  Sample sample;
  sample.run.summary.cycle_time = 0.1 + 0.2;
  EXPECT_EQ(Json::parse(sample.text())["cycle_time_s"].get<double>(), 0.1 + 0.2);
}

TEST(SimulationJson, RoundsMeasuredDistances) {
  Sample sample;
  sample.run.summary.max_contour_error = 0.01000000000080466;
  EXPECT_EQ(Json::parse(sample.text())["max_contour_error_mm"].get<double>(), 0.01);
}

TEST(SimulationJson, GivesNullWhereThereIsNoNumber) {
  Sample sample;
  sample.program.bounds = Bounds();
  sample.run.summary.mean_feed = std::numeric_limits<double>::quiet_NaN();
  const Json json = Json::parse(sample.text());
  EXPECT_EQ(json["program"]["bounds"]["min"], Json::parse("[null, null, null]"));
  EXPECT_TRUE(json["mean_feed_mm_min"].is_null());
}

TEST(SimulationJson, SurvivesBytesThatAreNoUtf8) {
  Sample sample;
  sample.program.source = std::make_shared<const SourceText>("a\xff.nc", "");
  sample.program.diagnostics[0].message = Message::as_written("word '\xfc'");
  EXPECT_TRUE(Json::accept(sample.text()));
}

TEST(Json, GivesAProgramAndARunTheSameKeysInEveryCommand) {
  const Sample sample;
  const LoadedProgram loaded = sample.loaded();
  const Json simulation = Json::parse(simulation_json(sample.whole(), sample.run));
  const Json comparison = Json::parse(comparison_json(loaded, std::vector{sample.run}));
  const Json check = Json::parse(check_json(loaded, {loaded.toolpath, {}}));
  EXPECT_EQ(comparison["program"], simulation["program"]);
  EXPECT_EQ(check["program"], simulation["program"]);
  EXPECT_EQ(check["diagnostics"], simulation["diagnostics"]);
  for (const auto& [key, value] : comparison["runs"][0].items()) {
    EXPECT_EQ(simulation[key], value) << key;
  }
}

}  // namespace
}  // namespace feedscope
