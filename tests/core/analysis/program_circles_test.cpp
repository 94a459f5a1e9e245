#include "core/analysis/circularity/program_circles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/analysis/circularity/test_program.h"
#include "core/base/units.h"
#include "core/export/circular.h"
#include "tests/support/english.h"

namespace feedscope {
namespace {

Run run_of(const std::string& text, const char* machine = "mikron-ucp710", const char* model = "",
           Dialect dialect = Dialect::iso) {
  ReadOptions options;
  options.dialect = dialect;
  return simulate_run(
      load_program(std::make_shared<const SourceText>(SourceText("circles", text)), nullptr, options),
      make_setup({machine, model, {}}));
}

CircularRequest thirty_at_six() {
  CircularRequest request;
  request.radius = 30;
  request.feed = units::from_m_min(6);
  request.sweep = 2 * std::numbers::pi;
  return request;
}

// The program of a circular test holds the circles of the test: the same places, whoever looks for them.
TEST(ProgramCircles, CirclesOfTheTestProgramAreThoseOfTheTest) {
  for (const double entry : {0.0, 20.0}) {
    CircularRequest request = thirty_at_six();
    request.entry_radius = entry;
    const CircularTest test = run_circular_test(request, make_setup({"mikron-ucp710", "", {}}));
    const ProgramCircles found = program_circles(run_of(simulated_circles(request).text));
    ASSERT_EQ(found.tests.size(), 1U);
    ASSERT_EQ(found.tests[0].passes.size(), 2U);
    EXPECT_TRUE(found.actual);
    for (std::size_t i = 0; i < 2; ++i) {
      const Circularity& a = found.tests[0].passes[i].circularity;
      const Circularity& b = test.passes[i].circularity;
      EXPECT_NEAR(a.zone, b.zone, 2e-7) << entry;
      EXPECT_NEAR(a.by_squares, b.by_squares, 2e-7);
      EXPECT_NEAR(a.largest, b.largest, 2e-7);
      EXPECT_NEAR(a.smallest, b.smallest, 2e-7);
      EXPECT_NEAR(found.tests[0].passes[i].reached_feed, request.feed, 1e-9);
      EXPECT_NEAR(units::to_deg(found.tests[0].passes[i].evaluated), 360, 1);
    }
    EXPECT_NEAR(*found.tests[0].g_b(), *test.g_b(), 2e-7);
    EXPECT_NEAR(*found.tests[0].d(), *test.d(), 2e-7);
  }
}

// Several turns at constant feed: in the middle the radius grows by 33.27 um, as the drives' closed form
// says.
TEST(ProgramCircles, SteadyGrowthIsThatOfTheDrives) {
  const ProgramCircles found = program_circles(
      run_of("G21 G90 G17 G94 F6000\nG0 X140 Y50\nG3 I-30 J0\nG3 I-30\nG3 I-30\nG1 X150\nM30\n"));
  ASSERT_EQ(found.tests.size(), 1U);
  EXPECT_NEAR(found.tests[0].center.x(), 110, 1e-9);
  const CirclePass& pass = found.tests[0].passes[0];
  EXPECT_NEAR(units::to_um(pass.circularity.largest), 33.27, 0.2);
  EXPECT_NEAR(units::to_deg(pass.evaluated), 1080, 1);
  EXPECT_FALSE(found.tests[0].g_b());
  EXPECT_FALSE(found.tests[0].d());
  EXPECT_EQ(pass.first_line, 3U);
  EXPECT_EQ(pass.last_line, 5U);
}

TEST(ProgramCircles, SetPathIsJudgedWithoutDrivesByEveryModel) {
  for (const char* model : {"essid", "msaddek", "cam", "tapie"}) {
    const ProgramCircles found = program_circles(
        run_of("G21 G90 G17 G94 F1200\nG1 X20 Y3\nG2 I-20 J0\nG1 X30 Y0\nM30\n", "spinner-mvc850", model));
    ASSERT_EQ(found.tests.size(), 1U) << model;
    EXPECT_FALSE(found.actual);
    EXPECT_LT(found.tests[0].passes[0].circularity.zone, 1e-8) << model;
    EXPECT_FALSE(found.tests[0].passes[0].counter_clockwise);
  }
}

// No model has curves of its own where a line meets an arc, so that the whole turn is there; filters smooth
// the motion and draw the circle of 20 mm smaller by v2/R times a constant of the filters, a corner or none.
TEST(ProgramCircles, FilteredCirclesAreSmallerInAllOfTheirTurn) {
  const auto mean = [](const char* feed) {
    const ProgramCircles found = program_circles(
        run_of(std::string("G21 G90 G17 G94 F") + feed + "\nG1 X20 Y-30\nY0\nG3 I-20 J0\nG1 Y30\nM30\n",
               "dmg-mori-evo40", "ward"));
    EXPECT_EQ(found.tests.size(), 1U);
    EXPECT_NEAR(units::to_deg(found.tests[0].passes[0].evaluated), 360, 1);
    EXPECT_LE(found.tests[0].passes[0].circularity.largest, 1e-9);
    return -found.tests[0].passes[0].circularity.smallest;
  };
  const double slow = mean("1500");
  EXPECT_GT(slow, 0.001);
  EXPECT_NEAR(mean("3000") / slow, 4, 0.1);  // the feed reached is 0.5 % lower
}

TEST(ProgramCircles, PausesBeforeACircleAreNoPartOfIt) {
  const std::string head = "G21 G90 G17 G94 F3000\nG1 X20 Y0\n";
  const ProgramCircles with = program_circles(run_of(head + "G4 P2\nG3 I-20 J0\nG4 P2\nM30\n"));
  ASSERT_EQ(with.tests.size(), 1U);
  EXPECT_LT(with.tests[0].passes[0].time, 2 * std::numbers::pi * 20 / 50 + 0.5);
}

TEST(ProgramCircles, WhatIsNotEvaluatedIsSaid) {
  const ProgramCircles none = program_circles(run_of("G21 G90 G94 F600\nG1 X10\nM30\n"));
  EXPECT_THAT(in_english(program_circle_notes(none)),
              ::testing::ElementsAre(::testing::HasSubstr("The program has no full circle")));
  EXPECT_TRUE(none.tests.empty());
  std::string many = "G21 G90 G17 G94 F6000\nG0 X1 Y0 Z0\n";
  for (int i = 1; i <= 203; ++i) {
    many += "G3 I-1 J0\nG1 Z-" + std::to_string(i) + "\n";
  }
  const ProgramCircles capped = program_circles(run_of(many + "G3 I-1 Z0\nM30\n"));
  EXPECT_EQ(capped.found, 203U);
  EXPECT_EQ(capped.tests.size(), max_program_circles);
  EXPECT_THAT(in_english(program_circle_notes(capped)),
              ::testing::ElementsAre("The program has 203 full circles; the first 200 are evaluated.",
                                     "Not evaluated: 1 helix with full turns."));
}

TEST(ProgramCircles, CsvHasItsColumnsBehindThoseOfTheTest) {
  const ProgramCircles found = program_circles(run_of("G21 G90 G17 G94 F6000\nG0 X30 Y0\nG3 I-30 J0\nM30\n"));
  const std::string csv = program_circles_csv(found);
  EXPECT_TRUE(csv.starts_with(
      "radius_mm,feed_mm_min,plane,direction,reached_feed_mm_min,time_s,G_um,G_ls_um,Gb_um,Fmax_um,Fmin_um,"
      "D_um,Fmean_um,first_line,last_line,centre_x_mm,"))
      << csv;
  EXPECT_THAT(csv, ::testing::HasSubstr("\n30,6000,XY,ccw,"));
  const auto count = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  const std::size_t end = csv.find('\n');
  EXPECT_EQ(count(csv.substr(0, end)), count(csv.substr(end)));
}

}  // namespace
}  // namespace feedscope
