#include "core/analysis/run/tolerance_in_force.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/analysis/contour/contour_report.h"
#include "core/analysis/study/compare.h"
#include "core/analysis/study/sweep.h"
#include "core/blend/path_rules.h"
#include "core/lessons/lesson.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

LoadedProgram load(const std::string& text, Dialect dialect) {
  ReadOptions options;
  options.dialect = dialect;
  return load_program(std::make_shared<const SourceText>("test.nc", text), nullptr, options);
}

Setup setup_of(const std::string& model, std::optional<double> tolerance = std::nullopt,
               std::vector<std::string> assignments = {}) {
  return make_setup({"", model, tolerance, std::move(assignments)});
}

/// The tolerance that one number asks for, read off the text by hand.
ToleranceInForce of_program(double min, double max) {
  return {min, max, ToleranceInForce::Setter::program};
}

TEST(ToleranceInForce, IsTheProgramsWhateverTheMachineSays) {
  const struct {
    Dialect dialect;
    std::string text;
    ToleranceInForce expected;
  } cases[] = {
      {Dialect::sinumerik, "G71\nCYCLE832(0.02,1)\nG1 X10 F1000\nY10\n", of_program(0.02, 0.02)},
      {Dialect::sinumerik, "G71\nG642 CTOL=0.03\nG1 X10 F1000\nCTOL=0.05\nY10\n", of_program(0.03, 0.05)},
      {Dialect::sinumerik, "G71\nG641 ADIS=0.5\nG1 X10 F1000\nY10\n", of_program(0.5, 0.5)},
      {Dialect::linuxcnc, "G21 G64 P0.04\nG1 X10 F1000\nY10\n", of_program(0.04, 0.04)},
      {Dialect::heidenhain,
       "0 BEGIN PGM A MM\n1 CYCL DEF 32.0 TOLERANCE\n2 CYCL DEF 32.1 T0.015\n3 L X+10 F1000\n4 L Y+10\n5 END "
       "PGM A MM\n",
       of_program(0.015, 0.015)},
      {Dialect::sinumerik,
       "G71\nG1 X10 F1000\nG642 CTOL=0.03\nY10\n",
       {0.03, 0.1, ToleranceInForce::Setter::both}},
      // Only a rapid runs before it.
      {Dialect::sinumerik, "G71\nG0 X10\nG642 CTOL=0.03\nG1 Y10 F1000\n", of_program(0.03, 0.03)},
      {Dialect::iso, "G21 G1 X10 F1000\nY10\n", {0.1, 0.1, ToleranceInForce::Setter::setting}},
  };
  for (const auto& one : cases) {
    const LoadedProgram program = load(one.text, one.dialect);
    for (const ControlModel* model : all_models()) {
      const auto setup = make_setup({"spinner-mvc850", model->info().id, {}});
      const auto found = tolerance_in_force(program.feed_controls, setup);
      const std::string& id = model->info().id;
      const bool follows = id != "cam" && id != "tapie" && !model->info().jumps_in_corners &&
                           !(id == "optimal" && setup.settings.text("path") == "cam");
      ASSERT_EQ(found.has_value(), follows) << id;
      if (follows) {
        EXPECT_EQ(*found, one.expected) << one.text << id << ": " << describe(found);
        EXPECT_EQ(contour_report(simulate_run(program, setup), 1).tolerance,
                  (std::array{one.expected.min, one.expected.max}));
      }
    }
  }
}

/// Against every motion, one by one, as the models ask for it.
TEST(ToleranceInForce, IsTheLeastAndLargestOfAllFeedMotions) {
  std::mt19937 random(14);
  const auto pick = [&](const std::vector<std::string>& from) {
    return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random)];
  };
  for (int round = 0; round < 200; ++round) {
    std::string text = "G71 G90 G17\n";
    const int blocks = std::uniform_int_distribution<int>(0, 12)(random);
    for (int i = 0; i < blocks; ++i) {
      const std::string words =
          pick({"", "", "G642 CTOL=0.03", "G64", "G60", "G641 ADIS=0.2", "CYCLE832(0.02,1)", "CYCLE832(0,0)",
                "CTOL=-1", "COMPCAD", "BRISK", "SOFT"});
      text += (words.empty() ? "" : words + "\n") +
              fmt::format("{} X{} Y{}\n", pick({"G0", "G1 F900", "G1 F300", "G4 F1\nG1"}), random() % 50,
                          random() % 50);
    }
    const LoadedProgram program = load(text, Dialect::sinumerik);
    for (const char* own : {"program_tolerance=on", "program_tolerance=off"}) {
      const auto setup = setup_of("essid", std::nullopt, {"contour_tolerance_mm=0.07", own});
      const PathRules rules(*program.toolpath, setup.settings);
      std::vector<double> all;
      for (std::size_t i = 0; i < program.toolpath->segments.size(); ++i) {
        const Segment& segment = program.toolpath->segments[i];
        if (segment.kind != SegmentKind::dwell && !segment.rapid) {
          all.push_back(rules.tolerance(i));
        }
      }
      const auto found = tolerance_in_force(program.feed_controls, setup);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->min, all.empty() ? 0.07 : std::ranges::min(all)) << text;
      EXPECT_EQ(found->max, all.empty() ? 0.07 : std::ranges::max(all)) << text;
      const bool only_setting = std::ranges::all_of(all, [](double value) { return value == 0.07; });
      EXPECT_EQ(found->set_by == ToleranceInForce::Setter::setting, only_setting) << text;
    }
  }
}

TEST(ToleranceInForce, AToleranceOfZeroDoesNotHideThatOfTheProgram) {
  const LoadedProgram program = load("G71\nG642 CTOL=0.03\nG1 X10 F1000\nY10\n", Dialect::sinumerik);
  const auto setup = setup_of("essid", std::nullopt, {"contour_tolerance_mm=0"});
  EXPECT_EQ(tolerance_in_force(program.feed_controls, setup), of_program(0.03, 0.03));
  EXPECT_GT(simulate_run(program, setup).summary.max_contour_error, 0.001);
}

TEST(ToleranceInForce, IsDescribedWithItsSetter) {
  EXPECT_EQ(describe(std::nullopt), "none");
  EXPECT_EQ(describe(ToleranceInForce{0.1, 0.1, ToleranceInForce::Setter::setting}), "0.1 mm");
  EXPECT_EQ(describe(of_program(0.02, 0.02)), "0.02 mm (program)");
  EXPECT_EQ(describe(ToleranceInForce{0.01, 0.05, ToleranceInForce::Setter::both}),
            "0.01 ... 0.05 mm (program and setting)");
}

/// --tolerance, a sweep and a lesson.
TEST(SetTolerance, GivesTheSameSettingsFromWhereverItIsAskedFor) {
  for (const ControlModel* model : all_models()) {
    const std::string& id = model->info().id;
    const auto asked = setup_of(id, 0.042);
    EXPECT_EQ(setups_to_compare({""}, {id}, {0.042}).front(), asked) << id;
    auto swept = setup_of(id);
    if (contour_tolerance(swept)) {
      apply_swept("tolerance", 0.042, swept);
      EXPECT_EQ(swept, asked) << id;
      EXPECT_EQ(asked.settings.text(program_tolerance_key), "off") << id;
    }
    Lesson lesson;
    lesson.start = {"program=essid_table1.nc", "model=" + id, "tolerance=0.042"};
    EXPECT_EQ(set_up(lesson, {}).setup, asked) << id;
    EXPECT_EQ(set_up(lesson, {"tolerance=0.042"}).setup, asked) << id;
  }
}

}  // namespace
}  // namespace feedscope
