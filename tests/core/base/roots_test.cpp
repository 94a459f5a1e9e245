#include "core/base/roots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace feedscope {
namespace {

TEST(Halve, FindsWhereAConditionEnds) {
  const Bracket found = halve({0, 2}, 50, [](double x) { return x * x < 2; });
  EXPECT_LT(found.low, std::numbers::sqrt2);
  EXPECT_GE(found.high, std::numbers::sqrt2);
  EXPECT_NEAR(found.middle(), std::numbers::sqrt2, 1e-14);
}

TEST(RisingRoot, OfAParabolaIsASquareRoot) {
  int calls = 0;
  const double root = rising_root({0, 10}, 1, {.relative = 1e-15}, [&calls](double x) {
    ++calls;
    return ValueAndSlope{x * x - 2, 2 * x};
  });
  EXPECT_NEAR(root, std::numbers::sqrt2, 1e-15);
  EXPECT_LE(calls, 8) << "Newton's steps double the digits";
}

TEST(RisingRoot, StaysInTheBracketWhereTheSlopeVanishes) {
  // x^3 has no slope at its root, and none at all where this begins.
  const double root = rising_root({-1, 2}, 0, {.width = 1e-12}, [](double x) {
    return ValueAndSlope{x * x * x - 1e-3, 3 * x * x};
  });
  EXPECT_NEAR(root, 0.1, 1e-10);
  const double wild = rising_root({-5, 5}, 4, {.step = 1e-15}, [](double x) {
    return ValueAndSlope{std::atan(x), 1 / (1 + x * x)};  // plain Newton runs away from here
  });
  EXPECT_NEAR(wild, 0, 1e-12);
}

TEST(RisingRoot, EndsAtTheValueThatIsGoodEnough) {
  const double root = rising_root({0, 4}, 1, {.value = 0.5}, [](double x) {
    return ValueAndSlope{x * x - 4, 2 * x};
  });
  EXPECT_LE(std::abs(root * root - 4), 0.5);
  EXPECT_GT(std::abs(root * root - 4), 1e-3) << "it goes on although that is good enough";
}

TEST(LeastPlace, OfAParabolaIsItsVertexWithOneCallAStep) {
  int calls = 0;
  const Least found = least_place({-3, 7}, 1e-6, 200, [&calls](double x) {
    ++calls;
    return (x - 1.25) * (x - 1.25);
  });
  EXPECT_LE(found.place.high - found.place.low, 1e-6);
  EXPECT_NEAR(found.place.middle(), 1.25, 1e-6);
  EXPECT_NEAR(found.value, 0, 1e-12);
  EXPECT_LE(calls, 2 + 34);
  EXPECT_EQ(least_place({0, 1}, 0, 3, [](double x) { return x; }).place.low, 0)
      << "the end where it is least";
}

}  // namespace
}  // namespace feedscope
