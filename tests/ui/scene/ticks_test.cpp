#include "ui/scene/ticks.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace feedscope::ui {
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
  EXPECT_THAT(round_ticks(0, 1, 0).values, IsEmpty());
}

TEST(Ticks, AreNeverMoreThanAskedForAndAtLeastAThird) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-6, 6);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const double range = std::pow(10, exponent(random));
    const double from = place(random) * range * 10;
    const int most = 3 + i % 15;
    const Ticks ticks = round_ticks(from, from + range, most);
    const auto count = static_cast<int>(ticks.values.size());
    EXPECT_LE(count, most) << from << " + " << range;
    EXPECT_GE(count, most / 3) << from << " + " << range;
    EXPECT_EQ(ticks.values.size(), ticks.labels.size());
  }
}

}  // namespace
}  // namespace feedscope::ui
