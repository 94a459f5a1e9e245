#include "core/kinematics/series.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/core/kinematics/differences.h"

namespace feedscope {
namespace {

using Function = std::function<Series(const Series&)>;

void expect_derivatives(const Function& f, double at) {
  const test::Differences by_differences =
      test::differences([&](double x) { return f(Series(x)).value(); }, at, 1e-3);
  const Series found = f(Series(at, 1, 0, 0));
  EXPECT_NEAR(found.d1(), by_differences.d1, 1e-9);
  EXPECT_NEAR(found.d2(), by_differences.d2, 1e-7);
  EXPECT_NEAR(found.d3(), by_differences.d3, 1e-5);
}

TEST(Series, CarriesDerivativesThroughEveryOperation) {
  for (const double at : {-0.7, 0.2, 0.9}) {
    expect_derivatives([](const Series& x) { return x * x * x - Series(2) * x + Series(1); }, at);
    expect_derivatives([](const Series& x) { return Series(1) / (x * x + Series(1)); }, at);
    expect_derivatives([](const Series& x) { return sqrt(x * x + Series(2)); }, at);
    expect_derivatives([](const Series& x) { return sin(x * x) * cos(Series(3) * x); }, at);
    expect_derivatives([](const Series& x) { return atan2(x * x - Series(0.3), x + Series(2)); }, at);
    expect_derivatives([](const Series& x) { return atan2(sin(x), cos(x)) / (x + Series(3)); }, at);
  }
}

TEST(Series, AnglesOfItsOwnSineAndCosineAreTheParameter) {
  const Series x(0.4, 1, 0, 0);
  const Series angle = atan2(sin(x), cos(x));
  EXPECT_NEAR(angle.value(), 0.4, 1e-15);
  EXPECT_NEAR(angle.d1(), 1, 1e-15);
  EXPECT_NEAR(angle.d2(), 0, 1e-14);
  EXPECT_NEAR(angle.d3(), 0, 1e-14);
}

}  // namespace
}  // namespace feedscope
