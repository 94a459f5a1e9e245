#include "core/base/ticks.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Ticks, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_up_125(1), 1);
  EXPECT_DOUBLE_EQ(round_up_125(1.01), 2);
  EXPECT_DOUBLE_EQ(round_up_125(3), 5);
  EXPECT_DOUBLE_EQ(round_up_125(6), 10);
  EXPECT_DOUBLE_EQ(round_up_125(0.00021), 0.0005);
  EXPECT_DOUBLE_EQ(round_up_125(0.3 / 3), 0.1) << "the last digit of a quotient must not double the step";
}

TEST(Ticks, AreMultiplesOfTheStepInsideTheRange) {
  const Ticks ticks = round_ticks(-3.2, 12, 5);
  EXPECT_THAT(ticks.values, ElementsAre(0, 5, 10));
  EXPECT_THAT(ticks.labels, ElementsAre("0", "5", "10"));
}

TEST(Ticks, IncludeBothEndsOfARoundRange) {
  EXPECT_THAT(round_ticks(0, 1, 6).values.size(), 6);
}

TEST(Ticks, HaveAsManyDecimalsAsTheStepNeeds) {
  EXPECT_THAT(round_ticks(0, 0.001, 3).labels, ElementsAre("0.0000", "0.0005", "0.0010"));
  EXPECT_THAT(round_ticks(0, 1e6, 3).labels, ElementsAre("0", "500000", "1000000"));
}

TEST(Ticks, OfAPartAreThoseOfTheWholeInThere) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const double from = 1000 * (unit(random) - 0.5);
    const double to = from + std::pow(10, 6 * unit(random) - 3);
    const int most = 2 + static_cast<int>(400 * unit(random));
    const double low = from + (to - from) * (1.4 * unit(random) - 0.2);
    const double high = low + (to - from) * unit(random);
    const Ticks whole = round_ticks(from, to, most);
    const Ticks part = round_ticks_between(from, to, most, low, high);
    EXPECT_EQ(part.step, whole.step);
    EXPECT_EQ(part.count, static_cast<double>(whole.values.size()));
    std::vector<double> expected;
    for (const double value : whole.values) {
      if (value >= low - 1e-9 * (to - from) && value <= high + 1e-9 * (to - from)) {
        expected.push_back(value);
      }
    }
    EXPECT_EQ(part.values, expected);
    EXPECT_EQ(part.labels.size(), part.values.size());
  }
}

TEST(Ticks, OfAScaleWithoutEndAreFewWhereFewAreShown) {
  const Ticks part = round_ticks_between(0, 1e8, 1.5e8, 5e7, 5e7 + 10);
  EXPECT_EQ(part.step, 1);
  EXPECT_EQ(part.values.size(), 11U);
  EXPECT_LE(round_ticks_between(0, 1e9, 1e9, 0, 1e9).values.size(), 1000U);
  EXPECT_LE(multiples(1e-3, -1e6, 1e6).size(), 1000U);
}

TEST(Ticks, OfNoStepAreNone) {
  EXPECT_TRUE(multiples(0, 1, 2).empty());
  EXPECT_TRUE(multiples(-1, 1, 2).empty());
}

TEST(Ticks, NeverShowMinusZero) {
  for (const std::string& label : round_ticks(-1, 1, 3).labels) {
    EXPECT_NE(label, "-0");
  }
}

TEST(Ticks, AreNoneForARangeThatIsEmptyOrNotFinite) {
  EXPECT_THAT(round_ticks(1, 1, 5).values, IsEmpty());
  EXPECT_THAT(round_ticks(2, 1, 5).values, IsEmpty());
  EXPECT_THAT(round_ticks(0, std::numeric_limits<double>::infinity(), 5).values, IsEmpty());
  EXPECT_THAT(round_ticks(std::nan(""), 1, 5).values, IsEmpty());
}

/// On a low chart: there is room for two labels, and an axis of one says nothing.
TEST(Ticks, AreTwoAndFarApartWhereThereIsRoomForTwo) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-4, 5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 10'000; ++i) {
    const double range = std::pow(10, exponent(random));
    const double low = -range * share(random);
    const double high = low + range;
    const double step = step_of_two(low, high);
    SCOPED_TRACE(testing::Message() << low << " to " << high << ": " << step);
    EXPECT_GE(std::floor(high / step) - std::ceil(low / step), 1);
    EXPECT_GE(step, 0.37 * range);
    const double scaled = step * std::pow(10, step_decimals(step));
    EXPECT_NEAR(scaled, std::round(scaled), 1e-6);
  }
  EXPECT_EQ(step_of_two(-4000, 3300), 4000);
  EXPECT_EQ(step_of_two(0, 3000), 3000);
  EXPECT_EQ(step_decimals(0.15), 2);
  EXPECT_EQ(step_decimals(0.25), 2);
  EXPECT_EQ(step_decimals(2.5), 1);
  EXPECT_EQ(step_decimals(20), 0);
}

TEST(Ticks, OfTimesAreRoundOnAClock) {
  EXPECT_THAT(clock_ticks(16'550, 16'820, 3).values, ElementsAre(16'560, 16'680, 16'800)) << "every 2 min";
  EXPECT_THAT(clock_ticks(0, 100, 6).values, ElementsAre(0, 20, 40, 60, 80, 100));
  EXPECT_THAT(clock_ticks(0, 200, 5).values, ElementsAre(0, 60, 120, 180)) << "50 s is not round";
  EXPECT_THAT(clock_ticks(0, 20'000, 4).values, ElementsAre(0, 7200, 14'400));
  EXPECT_THAT(clock_ticks(0, 50, 6).values, ElementsAre(0, 10, 20, 30, 40, 50));
  EXPECT_THAT(clock_ticks(61, 61.05, 6).values, round_ticks(61, 61.05, 6).values);
}

TEST(Ticks, AreNeverOneAlone) {
  EXPECT_THAT(round_ticks(1, 9, 2).values, ElementsAre(2, 4, 6, 8)) << "5 alone is no scale";
  EXPECT_THAT(round_ticks(3, 12, 1).values, ElementsAre(5, 10));
  EXPECT_EQ(round_ticks(0, 1, 0).values.size(), 2U);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-6, 6);
  std::uniform_real_distribution<double> place(-10, 10);
  for (int i = 0; i < 10'000; ++i) {
    const double range = std::pow(10, exponent(random));
    const double from = place(random) * range;
    const int most = 2 + i % 6;
    for (const Ticks& ticks :
         {round_ticks(from, from + range, most), clock_ticks(from, from + range, most)}) {
      const auto count = static_cast<int>(ticks.values.size());
      EXPECT_GE(count, 2) << from << " + " << range << ", " << most;
      EXPECT_LE(count, std::max(most, 5)) << from << " + " << range << ", " << most;
    }
  }
}

TEST(Ticks, AreHardlyMoreThanAskedForAndAtLeastAThird) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-6, 6);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const double range = std::pow(10, exponent(random));
    const double from = place(random) * range * 10;
    const int most = 3 + i % 15;
    const Ticks ticks = round_ticks(from, from + range, most);
    const auto count = static_cast<int>(ticks.values.size());
    EXPECT_LE(count, std::max(most, 5)) << from << " + " << range;
    EXPECT_GE(count, most / 3) << from << " + " << range;
    EXPECT_EQ(ticks.values.size(), ticks.labels.size());
  }
}

}  // namespace
}  // namespace feedscope
