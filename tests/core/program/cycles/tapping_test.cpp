#include "core/program/cycles/tapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

using testing::ElementsAre;

std::vector<double> levels_of(const Tapping& tapping) {
  DrillPlan plan(2, tapping.safe);
  tap(tapping, plan);
  std::vector<double> levels;
  for (const DrillStep& step : plan.steps()) {
    if (step.kind == DrillStep::Kind::feed) {
      levels.push_back(step.level);
    }
  }
  return levels;
}

TEST(Tapping, GoesDownAndBackInOneGo) {
  EXPECT_THAT(levels_of({.safe = 2, .surface = 0, .bottom = -5}), ElementsAre(-5, 2));
}

TEST(Tapping, LiftsAfterEachStrokeToBreakChips) {
  EXPECT_THAT(levels_of({.safe = 2, .surface = 0, .bottom = -5, .stroke = 2, .lift = 0.5}),
              ElementsAre(-2, -1.5, -4, -3.5, -5, 2));
}

TEST(Tapping, LeavesTheHoleAfterEachStrokeToClearChips) {
  EXPECT_THAT(levels_of({.safe = 2, .surface = 0, .bottom = -5, .stroke = 2}),
              ElementsAre(-2, 2, -4, 2, -5, 2));
}

TEST(Tapping, HasNoStrokeOfNoDepthWhereStrokesDivideTheDepth) {
  EXPECT_THAT(levels_of({.safe = 2, .surface = 0, .bottom = -0.3, .stroke = 0.1, .lift = 0.05}).size(), 6U);
}

TEST(Tapping, GoesUpwardsWhereTheHoleDoes) {
  EXPECT_THAT(levels_of({.safe = -2, .surface = 0, .bottom = 3, .stroke = 2, .lift = 0.5}),
              ElementsAre(2, 1.5, 3, -2));
}

TEST(Tapping, IsDoneInOneGoBeyondTheLargestNumberOfStrokes) {
  EXPECT_EQ(levels_of({.safe = 2, .surface = 0, .bottom = -5, .stroke = 1e-9, .lift = 1}).size(), 2U);
}

TEST(Tapping, DwellsAtTheBottomOnly) {
  DrillPlan plan(2, 2);
  tap({.safe = 2, .surface = 0, .bottom = -5, .stroke = 2, .lift = 1, .dwell = 0.3}, plan);
  std::vector<double> dwells;
  for (const DrillStep& step : plan.steps()) {
    if (step.kind == DrillStep::Kind::dwell) {
      dwells.push_back(step.level);
    }
  }
  EXPECT_THAT(dwells, ElementsAre(-5));
}

struct Thread {
  Dialect dialect;
  std::string program;  ///< a thread from Z0 to Z-5 in strokes of 2 mm
};

class ThreadInStrokes : public testing::TestWithParam<Thread> {};

TEST_P(ThreadInStrokes, IsTappedDeeperStrokeByStroke) {
  const ReadProgram program = read_text(GetParam().program, ReadOptions{.dialect = GetParam().dialect});
  std::vector<double> turning_points;
  double before = 0;
  double level = 0;
  for (const MotionBlock& block : program.motions) {
    const double next = block.target.z();
    if (level < before && next > level) {
      turning_points.push_back(level);
    }
    before = level;
    level = next;
  }
  EXPECT_THAT(turning_points, ElementsAre(-2, -4, -5));
}

INSTANTIATE_TEST_SUITE_P(
    Dialects, ThreadInStrokes,
    testing::Values(Thread{Dialect::fanuc,
                           "G21 G90 G0 X0 Y0 Z9\nS600 M3\nG98 G84 Z-5 R0 Q2 F600\nG80\nM30\n"},
                    Thread{Dialect::sinumerik,
                           "G71 G90 G0 X0 Y0 Z9\nS600 M3\n"
                           "CYCLE84(9,0,0,-5,,0,5,,1,,600,600,,,,1,2,0.5)\nM30\n"},
                    Thread{Dialect::heidenhain,
                           "BEGIN PGM A MM\nTOOL CALL 1 Z S600\nL X0 Y0 Z9 FMAX M3\nCYCL DEF 209 TAPPING "
                           "Q200=0 Q201=-5 Q239=1 Q203=0 Q204=9 Q257=2 Q256=0.5\nCYCL CALL\n"
                           "END PGM A MM\n"}),
    [](const auto& thread) { return std::string(info_of(thread.param.dialect).id); });

TEST(Tapping, OfFanucTakesNoStrokesFromADrillingCycleBefore) {
  const auto count = [](const std::string& between) {
    return read_text("G21 G90 G0 X0 Y0 Z9\nG83 Z-5 R0 Q1 F600\n" + between + "G84 X9 Z-5 R0 F600\nG80\nM30\n",
                     ReadOptions{.dialect = Dialect::fanuc})
        .motions.size();
  };
  EXPECT_EQ(count(""), count("G80\n"));
}

}  // namespace
}  // namespace feedscope
