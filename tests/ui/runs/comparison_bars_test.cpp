#include "ui/runs/comparison_bars.h"

#include <gtest/gtest.h>

#include "tests/ui/comparison_fixture.h"

namespace feedscope::ui {
namespace {

using feedscope::test::compared_run;

const Cause feed{CauseKind::programmed_feed, -1};
const Cause jerk_x{CauseKind::axis_jerk, 0};
const Cause jerk_y{CauseKind::axis_jerk, 1};
const Cause ramp{CauseKind::ramp_down, -1};
const Cause dwell{CauseKind::dwell, -1};
const Cause stop{CauseKind::exact_stop, -1};

TEST(ComparisonBars, CutABarByCauseInTheOrderOfTheLegend) {
  const auto bars =
      comparison_bars(std::vector{compared_run("m", "essid", 0.05, {{ramp, 1}, {jerk_y, 2}, {jerk_x, 3}})});
  EXPECT_EQ(bars.kinds, (std::vector{CauseKind::axis_jerk, CauseKind::ramp_down}));
  EXPECT_FALSE(bars.rest);
  const ComparisonBar& bar = bars.machines.at(0).bars.at(0);
  ASSERT_EQ(bar.parts.size(), 3u);
  EXPECT_EQ(bar.parts[0].cause, jerk_x);
  EXPECT_EQ(bar.parts[0].time, 3);
  EXPECT_EQ(bar.parts[1].cause, jerk_y);
  EXPECT_EQ(bar.parts[2].cause, ramp);
  EXPECT_EQ(bar.model, "essid");
  EXPECT_EQ(bar.tolerance, (ToleranceInForce{0.05, 0.05}));
  EXPECT_EQ(bar.cycle_time, 6);
  EXPECT_EQ(bar.against_cam, 3);
  EXPECT_EQ(bar.contour_error, 0.008);
}

TEST(ComparisonBars, StandByMachineInTheOrderOfTheRuns) {
  const auto bars = comparison_bars(
      std::vector{compared_run("b", "cam", {}, {{feed, 2}}), compared_run("b", "essid", 0.01, {{feed, 4}}),
                  compared_run("a", "cam", {}, {{feed, 2}}), compared_run("b", "ward", 0.01, {{feed, 1}})});
  ASSERT_EQ(bars.machines.size(), 3u);
  EXPECT_EQ(bars.machines[0].machine, "b");
  EXPECT_EQ(bars.machines[0].bars.size(), 2u);
  EXPECT_EQ(bars.machines[0].programmed_time, 2);
  EXPECT_EQ(bars.machines[1].machine, "a");
  EXPECT_EQ(bars.machines[2].bars[0].model, "ward");
  EXPECT_EQ(bars.count(), 4u);
  EXPECT_EQ(bars.longest, 4);
}

TEST(ComparisonBars, KnowHowManyLinesEachControlRefuses) {
  std::vector runs{compared_run("m", "cam", {}, {{feed, 2}}), compared_run("m", "klipper", {}, {{feed, 1}})};
  EXPECT_FALSE(comparison_bars(runs).lines_refused);
  runs[1].lines_not_run = 46;
  const auto bars = comparison_bars(runs);
  EXPECT_TRUE(bars.lines_refused);
  EXPECT_EQ(bars.machines[0].bars[0].lines_not_run, 0u);
  EXPECT_EQ(bars.machines[0].bars[1].lines_not_run, 46u);
}

TEST(ComparisonBars, LeaveRoomForTheProgrammedTime) {
  EXPECT_EQ(comparison_bars(std::vector{compared_run("m", "cam", {}, {{feed, 0.5}})}).longest, 2);
}

TEST(ComparisonBars, PutWhatIsSmallInEveryRunTogether) {
  const auto bars =
      comparison_bars(std::vector{compared_run("m", "essid", 0.01, {{feed, 99}, {stop, 0.5}, {dwell, 0.5}}),
                                  compared_run("m", "ward", 0.01, {{feed, 50}, {ramp, 50}, {dwell, 0.25}})});
  EXPECT_EQ(bars.kinds, (std::vector{CauseKind::programmed_feed, CauseKind::ramp_down}));
  EXPECT_TRUE(bars.rest);
  const auto& first = bars.machines[0].bars[0].parts;
  ASSERT_EQ(first.size(), 2u);
  EXPECT_FALSE(first[1].cause);
  EXPECT_EQ(first[1].time, 1);
  EXPECT_EQ(bars.machines[0].bars[1].parts.back().time, 0.25);
}

TEST(ComparisonBars, KeepTheNameOfASmallCauseThatIsAlone) {
  const auto bars =
      comparison_bars(std::vector{compared_run("m", "essid", 0.01, {{feed, 99.5}, {dwell, 0.5}})});
  EXPECT_EQ(bars.kinds.size(), 2u);
  EXPECT_FALSE(bars.rest);
}

TEST(ComparisonBars, NameNothingThatIsNarrowerThanAPixel) {
  const auto alone =
      comparison_bars(std::vector{compared_run("m", "essid", 0.01, {{feed, 99.9}, {dwell, 0.1}})});
  EXPECT_EQ(alone.kinds, (std::vector{CauseKind::programmed_feed}));
  EXPECT_FALSE(alone.rest);
  EXPECT_EQ(alone.machines[0].bars[0].parts.back().time, 0.1) << "no time is lost";
  EXPECT_FALSE(comparison_bars(
                   std::vector{compared_run("m", "essid", 0.01, {{feed, 99.9}, {stop, 0.05}, {dwell, 0.05}})})
                   .rest);
}

TEST(ComparisonBars, KeepAtMostAsManyKindsAsTheLegendHoldsAndNoTimeIsLost) {
  const auto runs = feedscope::test::many_compared_runs(40);
  const auto bars = comparison_bars(runs);
  EXPECT_EQ(bars.kinds.size(), max_cause_kinds);
  EXPECT_TRUE(bars.rest);
  std::size_t i = 0;
  for (const MachineBars& machine : bars.machines) {
    for (const ComparisonBar& bar : machine.bars) {
      double sum = 0;
      for (const BarPart& part : bar.parts) {
        EXPECT_GT(part.time, 0);
        sum += part.time;
      }
      EXPECT_NEAR(sum, runs[i++].summary.cycle_time, 1e-9);
    }
  }
  EXPECT_EQ(i, runs.size());
}

TEST(ComparisonBars, KnowWhatAControlRefuses) {
  std::vector<ComparedRun> runs{compared_run("mill", "grbl", {}, {}), compared_run("mill", "cam", {}, {})};
  runs.front().refused = true;
  runs.front().summary.programmed_time = 0;
  const ComparisonBars bars = comparison_bars(runs);
  EXPECT_TRUE(bars.machines.front().bars.front().refused);
  EXPECT_TRUE(bars.machines.front().bars.front().parts.empty()) << "rapids and dwells make no bar";
  EXPECT_FALSE(bars.machines.front().bars.back().refused);
  EXPECT_EQ(bars.machines.front().programmed_time, 2) << "that of the run that there is";
}

TEST(ComparisonBars, OfNothingAreNone) {
  const auto none = comparison_bars({});
  EXPECT_TRUE(none.machines.empty());
  EXPECT_TRUE(none.kinds.empty());
  const auto still = comparison_bars(std::vector{compared_run("m", "cam", {}, {})});
  EXPECT_TRUE(still.machines[0].bars[0].parts.empty());
}

}  // namespace
}  // namespace feedscope::ui
