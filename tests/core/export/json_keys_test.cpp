#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "core/analysis/contour/contour_report.h"
#include "core/analysis/time/time_report.h"
#include "core/export/circular.h"
#include "core/export/export.h"
#include "core/export/merge.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

using Json = nlohmann::ordered_json;

/// Letters of the kinds of file that hold a key, as the table of core/export/README.md gives them.
using KeyTable = std::map<std::string, std::set<char>>;

KeyTable read_table() {
  std::ifstream file(FEEDSCOPE_SOURCE_DIR "/core/export/README.md");
  static const std::regex row(R"(\| `([^`]+)` \| ([sectkmr]+) \|.*)");
  KeyTable keys;
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, found, row)) {
      const std::string kinds = found[2];
      keys[found[1]] = {kinds.begin(), kinds.end()};
    }
  }
  return keys;
}

const KeyTable& documented() {
  static const KeyTable table = read_table();
  return table;
}

/// Objects whose keys are names of axes, settings or causes.
bool holds_names(const std::string& path) {
  for (const char* name : {"axes", "rotary_axes", "machine_axes", "settings", "swept", "time_by_cause_s",
                           "ramp_down_by_slower_place_s", "limiting_share", "max_following_error_um",
                           "time_without_load_s", "predicted", "programmed"}) {
    if (path == name || path.ends_with("." + std::string(name))) {
      return true;
    }
  }
  return false;
}

void add_keys(const Json& json, const std::string& path, char kind, KeyTable& keys) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      const std::string name = holds_names(path) ? "*" : key;
      add_keys(value, path.empty() ? name : path + "." + name, kind, keys);
    }
  } else if (json.is_array()) {
    for (const Json& value : json) {
      add_keys(value, path + "[]", kind, keys);
    }
  } else if (!json.is_null() || documented().contains(path)) {  // null may stand for an object
    keys[path].insert(kind);
  }
}

/// All that a drive may have.
const std::vector<std::string> drive_of_x{
    "X.kv=60",           "X.velocity_feedforward=0.5",  "X.velocity_lag=6",
    "X.backlash=2",      "X.backlash_compensation=0.5", "X.friction_spike=3",
    "X.friction_time=20"};

/// A bound that is passed.
constexpr const char* load_of_all =
    "feedscope_load = 1\n[[operation]]\nlines = \"1-7\"\ndiameter_mm = 10\nteeth = 2\nhelix_deg = 30\nae_mm "
    "= 2\n"
    "ap_mm = 5\nmilling = \"down\"\nmaterial = \"steel-c45\"\nspindle_1_min = 9000\nmin_chip_um = 50\n";

/// Programs and runs that have something of everything.
class Files {
 public:
  Files() {
    auto program = load_program(std::make_shared<const SourceText>(
        "all.mpf",
        "N1 G17 G90 G54 CYCLE832(0.02,1,1)\nT=\"MILL\"\nM6\nG0 X0 Y0 Z5\nG41 G1 X10 Y0 F3000\nG1 Z0\n"
        "N7 X40\nN8 G2 X50 Y10 I0 J10\nG1 Y40\nG4 F0.5\nG40 X0 Y60\nfoo\n"));
    auto corners = load_program(
        std::make_shared<const SourceText>("corners.nc",
                                           "G21\nT1 M6\nN1 G1 X20 F3000\nN2 Y20\nN3 X40\nN4 G2 X60 Y40 I20 "
                                           "J0\nN5 G0 A20\nG43.4 H1\nN6 G1 X70 A30\nM30\n"));
    Program called = *program.program;
    called.diagnostics.back().file = "called.spf";
    program.program = std::make_shared<const Program>(std::move(called));
    const auto session = [](const char* model, double tolerance) {
      Setup setup = make_setup({"spinner-mvc850", model, tolerance, drive_of_x});
      setup.load = parse_load(load_of_all, "load.toml");
      return setup;
    };
    const Run run = simulate_run(program, session("essid", 0.05));
    const Run second = simulate_run(corners, session("ward", 0.05));
    for (const Run* each : {&run, &second}) {
      const ContourReport contour = contour_report(*each, 50);
      add('s', simulation_json(*each, figures_of(*each), &contour));
      add('e', explanation_json(*each, figures_of(*each), time_report(*each, OperationSplit::tool)));
    }
    const std::vector<std::string> place{"tool_length_mm=100", "part_zero_x_mm=0", "part_zero_y_mm=0",
                                         "part_zero_z_mm=-300"};
    const Setup with_rotary_axes = make_setup({"five-axis-table-ac", "gassara", 0.05, place});
    std::vector<std::string> all_of_both = drive_of_x;
    all_of_both.insert(all_of_both.end(), place.begin(), place.end());
    const Run turned = simulate_run(corners, with_rotary_axes);
    add('s', simulation_json(turned, figures_of(turned), nullptr));
    for (const LoadedProgram* each : {&program, &corners}) {
      add('k', check_json(*each, {each->toolpath, {}}));
      // One right angle is passed slower with a blend than with a stop.
      std::vector<Setup> setups;
      for (const double tolerance : {0.0, 0.001, 0.1}) {
        setups.push_back(session("gassara", tolerance));
      }
      setups.push_back(with_rotary_axes);
      const std::string comparison = comparison_json(*each, compare_runs(*each, setups));
      add('c', comparison);
      const StudyRequest request{
          {"spinner-mvc850", "five-axis-table-ac"}, {"gassara"},          {}, all_of_both,
          {parse_sweep("tolerance=0 0.001 0.1")},   OperationSplit::tool, 5};
      const std::string study = study_json(*each, run_study(*each, request));
      add('t', study);
      merged_.push_back({"file" + std::to_string(merged_.size()), study});
    }
    add('m', merged_json(merge_comparisons(merged_)));
    CircularRequest circle;
    circle.radius = 10;
    circle.feed = 20;
    circle.sweep = 6;
    circle.entry_radius = 3;
    Setup setup = session("essid", 0.05);
    add('r', circular_json(setup, std::vector{run_circular_test(circle, setup)}));
    setup.load = {};
    const auto circles = load_program(
        std::make_shared<const SourceText>("circles.nc", "G21 F900\nG1 X20\nG3 I-20\nG2 I-20\nM30\n"));
    add('r', program_circles_json(setup, *circles.program, program_circles(simulate_run(circles, setup))));
  }

  const KeyTable& keys() const { return keys_; }
  const std::vector<Json>& all() const { return all_; }

 private:
  void add(char kind, const std::string& text) {
    all_.push_back(Json::parse(text));
    Json json = all_.back();
    if (kind == 's') {  // the keys of a run are at the top
      Json run = Json::object();
      for (const char* key : {"machine",
                              "model",
                              "settings",
                              "limits",
                              "drives",
                              "tolerance_in_force_mm",
                              "tolerance_set_by",
                              "notes",
                              "lines_not_run",
                              "out_of_reach",
                              "cycle_time_s",
                              "programmed_time_s",
                              "against_cam",
                              "mean_feed_mm_min",
                              "path_mm",
                              "blends",
                              "max_contour_error_mm",
                              "max_contour_error_cutting_mm",
                              "max_corner_distance_mm",
                              "max_contour_error_at",
                              "actual",
                              "load",
                              "peaks",
                              "time_by_cause_s",
                              "ramp_down_by_slower_place_s",
                              "not_counted"}) {
        run[key] = json[key];
        json.erase(key);
      }
      json["runs"] = Json::array({run});
    }
    if (kind == 'e') {  // besides its own keys it has those of a simulation
      for (const auto& [key, value] : all_[all_.size() - 2].items()) {
        if (key != "format" && !key.starts_with("contour_")) {
          EXPECT_EQ(json.count(key), 1U) << key;
          json.erase(key);
        }
      }
    }
    add_keys(json, "", kind, keys_);
  }

  std::vector<NamedText> merged_;
  std::vector<Json> all_;
  KeyTable keys_;
};

const Files& files() {
  static const Files all;
  return all;
}

TEST(JsonKeys, AreThoseOfTheTableWithNoneLeftOver) {
  const KeyTable& table = documented();
  ASSERT_GT(table.size(), 100U);
  for (const auto& [key, kinds] : files().keys()) {
    ASSERT_TRUE(table.contains(key)) << key << " is written and not in core/export/README.md";
    for (const char kind : kinds) {
      EXPECT_TRUE(table.at(key).contains(kind)) << key << " is written in files of kind " << kind;
    }
  }
  for (const auto& [key, kinds] : table) {
    for (const char kind : kinds) {
      const auto written = files().keys().find(key);
      EXPECT_TRUE(written != files().keys().end() && written->second.contains(kind))
          << key << " is in the table for files of kind " << kind << " and not written";
    }
  }
}

TEST(JsonKeys, FormatNamesTheKindAndComesFirst) {
  for (const Json& json : files().all()) {
    EXPECT_EQ(json.items().begin().key(), "format");
    EXPECT_EQ(json["format"]["version"], 1);
    EXPECT_THAT(json["format"]["name"].get<std::string>(), testing::StartsWith("feedscope-"));
  }
}

}  // namespace
}  // namespace feedscope
