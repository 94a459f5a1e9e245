#include "ui/charts/value_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace feedscope::ui {
namespace {

TEST(ValueFit, HoldsAllCurvesAndZero) {
  const Interval fit = fit_values(std::array{CurveReach{{2, 5}}, CurveReach{{-1, 3}}}, {});
  EXPECT_LT(fit.lower, -1);
  EXPECT_GT(fit.upper, 5);
  EXPECT_LT(fit.upper, 6);
  EXPECT_EQ(fit_values(std::array{CurveReach{{2, 5}}}, {}).lower, 0);
}

TEST(ValueFit, GrowsForACurveThatMayBeCutOnlySoFar) {
  const std::array curves{CurveReach{{-4, 4}}, CurveReach{{-300, 300}, true}};
  EXPECT_LT(fit_values(curves, {}).upper, 8);
  const std::array close{CurveReach{{-4, 4}}, CurveReach{{-6, 6}, true}};
  EXPECT_GE(fit_values(close, {}).upper, 6);
}

TEST(ValueFit, ShowsInFullWhatMayBeCutIfItIsAlone) {
  EXPECT_GE(fit_values(std::array{CurveReach{{-300, 300}, true}, CurveReach{}}, {}).upper, 300);
}

TEST(ValueFit, ShowsALimitThatIsNear) {
  const std::array limits{6.0, 60.0};
  const Interval fit = fit_values(std::array{CurveReach{{0, 5}}}, limits);
  EXPECT_GE(fit.upper, 6);
  EXPECT_LT(fit.upper, 60);
  EXPECT_EQ(fit.lower, 0);
}

TEST(ValueFit, AFeedThatRoundsBelowZeroHasNoNegativeHalf) {
  for (const bool may_be_cut : {false, true}) {
    const Interval fit = fit_values(std::array{CurveReach{{-1e-13F, 5}, may_be_cut}}, std::array{6.0});
    EXPECT_EQ(fit.lower, 0);
    EXPECT_GE(fit.upper, 6);
  }
}

TEST(ValueFit, RapidsDoNotSetTheScale) {
  const Interval whole{-9000, 21000};
  const auto slower = without_rapids(whole, 20000, {300, 300});
  ASSERT_TRUE(slower);
  EXPECT_GT(slower->upper, 300 * 1.2);
  EXPECT_LT(slower->upper, 300 * 1.5);
  EXPECT_EQ(slower->lower, -slower->upper);
  EXPECT_GE(without_rapids(whole, 20000, {300, 450})->upper, 450)
      << "a programmed feed that is not reached is in sight";
  EXPECT_LT(without_rapids(whole, 20000, {300, 6000})->upper, 600) << "unless it is far away";
  EXPECT_FALSE(without_rapids(whole, 9900, {8000, 8000})) << "near enough";
  EXPECT_FALSE(without_rapids(whole, 20000, {0, 0}));
  EXPECT_EQ(without_rapids({0, 21000}, 20000, {300, 300})->lower, 0);
}

TEST(ValueFit, ThinPeaksDoNotLast) {
  std::vector<double> columns(50, 300);
  columns[20] = columns[21] = columns[22] = 4000;
  EXPECT_EQ(largest_that_lasts(columns), 300);
  columns[23] = 3500;
  EXPECT_EQ(largest_that_lasts(columns), 3500) << "that is an operation of its own";
  EXPECT_EQ(largest_that_lasts(std::vector<double>{300, 300}), 0);
  EXPECT_TRUE(is_far_beyond(3500, 300));
  EXPECT_FALSE(is_far_beyond(3500, 2000));
  EXPECT_FALSE(is_far_beyond(3500, 0)) << "of columns without anything";
}

TEST(ValueFit, OfNothingHasAWidth) {
  EXPECT_GT(fit_values({}, {}).width(), 0);
  EXPECT_GT(fit_values(std::array{CurveReach{{0, 0}}}, {}).width(), 0);
}

}  // namespace
}  // namespace feedscope::ui
