#include "core/analysis/study/recommendation.h"

#include <gtest/gtest.h>

#include <random>

namespace feedscope {
namespace {

std::optional<Recommendation> recommended(const std::vector<RunTime>& runs,
                                          std::optional<double> within = std::nullopt) {
  return recommend(std::span<const RunTime>(runs), within);
}

TEST(Recommendation, IsTheSmallestErrorThatTakesAsLongAsTheFastest) {
  const auto taken = recommended({{118.1, 0.008}, {108.5, 0.0113}, {108.4, 0.0283}, {108.4, 0.0566}});
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->run, 1u);
  EXPECT_EQ(taken->reason, Recommendation::Reason::smallest_error);
  EXPECT_EQ(taken->against, 0u);
  EXPECT_NEAR(taken->gain, 9.6, 1e-9);
  EXPECT_NEAR(taken->gain_share, 9.6 / 118.1, 1e-12);
  EXPECT_EQ(taken->contour_error, 0.0113);
}

TEST(Recommendation, IsTheFastestWhereItIsFasterByMoreThanOnePercent) {
  const auto taken = recommended({{100, 0.01}, {90, 0.02}, {80, 0.05}});
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->run, 2u);
  EXPECT_EQ(taken->reason, Recommendation::Reason::fastest);
}

TEST(Recommendation, KeepsTheBoundThatTheFastestDoesNot) {
  const std::vector<RunTime> runs{{100, 0.01}, {90, 0.02}, {80, 0.05}};
  EXPECT_EQ(recommended(runs, 0.02)->run, 1u);
  EXPECT_EQ(recommended(runs, 0.01)->reason, Recommendation::Reason::only);
  EXPECT_FALSE(recommended(runs, 0.005));
}

TEST(Recommendation, SaysThatNothingIsGained) {
  const auto taken = recommended({{100, 0.02}, {100.9, 0.01}, {100.2, 0.05}});
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->run, 1u);
  EXPECT_EQ(taken->reason, Recommendation::Reason::no_difference);
}

TEST(Recommendation, NeverTakesWhatTheControlRefuses) {
  EXPECT_EQ(recommended({{1, 0, 3}, {5, 0, 0}, {0, 0, 0, false}})->run, 1u);
  EXPECT_FALSE(recommended({{0, 0, 0, false}}));
  EXPECT_FALSE(recommended({}));
}

ComparedRun run_of(const std::string& model, double contour_error) {
  ComparedRun run;
  run.setup.machine.model = "essid";
  run.setup.model = &find_model(model);
  run.summary.cycle_time = 1;
  run.summary.cutting_contour_error = contour_error;
  return run;
}

TEST(Recommendation, OfARunAloneSaysWhyNoOtherCanBeChosen) {
  const ComparedRun exact = run_of("essid", 0.01);
  const ComparedRun coarse = run_of("essid", 0.05);
  const ComparedRun other = run_of("ward", 0.001);
  ComparedRun refused = coarse;
  refused.refused = true;
  const auto why = [](const std::vector<ComparedRun>& runs, std::optional<double> within) {
    EXPECT_EQ(recommend(std::span<const ComparedRun>(runs), within)->reason, Recommendation::Reason::only);
    return why_only(runs, within);
  };
  EXPECT_EQ(why({exact, coarse}, 0.02), OnlyChoice::within_bound);
  EXPECT_EQ(why({exact, coarse, other}, 0.02), OnlyChoice::within_bound_of_machine)
      << "a run of another model is within the bound";
  EXPECT_EQ(why({exact, other}, 0.02), OnlyChoice::of_machine);
  EXPECT_EQ(why({exact, refused}, std::nullopt), OnlyChoice::possible);
  ComparedRun cut = exact;
  cut.lines_not_run = 4;
  EXPECT_EQ(why({exact, cut, other}, std::nullopt), OnlyChoice::possible)
      << "a run of the machine's own model";
}

TEST(Recommendation, KnowsThatAnotherModelIsFaster) {
  std::vector<ComparedRun> runs{run_of("essid", 0.01), run_of("essid", 0.02), run_of("ward", 0.001)};
  runs[0].summary.cycle_time = 1.2;
  const auto is_faster = [&](double time) {
    runs[2].summary.cycle_time = time;
    const auto taken = recommend(std::span<const ComparedRun>(runs), std::nullopt);
    EXPECT_EQ(taken->run, 1u);
    return another_model_is_faster(runs, *taken);
  };
  EXPECT_TRUE(is_faster(0.9));
  EXPECT_FALSE(is_faster(1.1));
  runs[2].lines_not_run = 1;
  EXPECT_FALSE(is_faster(0.9));
}

TEST(LeadingRun, IsTheRecommendedOneElseTheMostExactOfTheWholeProgram) {
  std::vector<ComparedRun> runs{run_of("essid", 0.03), run_of("essid", 0.02), run_of("ward", 0.001),
                                run_of("essid", 0.001)};
  runs[0].summary.cycle_time = 0.9;
  runs[3].lines_not_run = 1;
  EXPECT_EQ(leading_run(runs, std::nullopt),
            recommend(std::span<const ComparedRun>(runs), std::nullopt)->run);
  ASSERT_FALSE(recommend(std::span<const ComparedRun>(runs), 0.01));
  EXPECT_EQ(leading_run(runs, 0.01), 1u) << "C is of another model, D does not run a line";
  runs = {run_of("ward", 0.01), run_of("cam", 0.01)};
  EXPECT_FALSE(leading_run(runs, std::nullopt));
  EXPECT_FALSE(leading_run({}, std::nullopt));
}

TEST(Recommendation, HoldsItsRuleOnRandomRuns) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> any(0, 1);
  for (int n = 0; n < 2000; ++n) {
    std::vector<RunTime> runs(1 + random() % 8);
    for (RunTime& run : runs) {
      run = {10 + 0.3 * any(random), 0.01 * any(random), random() % 2, random() % 8 != 0};
    }
    const double within = 0.01 * any(random);
    const std::vector<std::size_t> places = runs_to_choose_from(runs, within);
    const auto taken = recommended(runs, within);
    ASSERT_EQ(taken.has_value(), !places.empty());
    if (!taken) {
      continue;
    }
    const RunTime& best = runs[taken->run];
    ASSERT_LE(best.contour_error, within + 1e-9);
    for (const std::size_t place : places) {
      ASSERT_LE(best.cycle_time, (1 + worthwhile_share) * runs[place].cycle_time);
      ASSERT_LE(runs[place].cycle_time, runs[taken->against].cycle_time);
      const bool more_exact = runs[place].contour_error < best.contour_error;
      const double fastest = runs[fastest_runs(runs, within).front()].cycle_time;
      ASSERT_FALSE(more_exact && runs[place].cycle_time <= (1 + worthwhile_share) * fastest) << n;
    }
  }
}

}  // namespace
}  // namespace feedscope
