#include "ui/charts/column_cache.h"

#include <gtest/gtest.h>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

constexpr int count = 200;

class ColumnCacheTest : public testing::Test {
 protected:
  /// Counts how many positions are asked for.
  void update(double lower, double upper) {
    asked = 0;
    cache.update(envelope, trajectory->duration(), {lower, upper}, count, [this](double position) {
      ++asked;
      return position;
    });
  }

  /// As if nothing had been kept.
  void expect_right(double lower, double upper) {
    std::vector<double> times;
    for (int i = 0; i <= count; ++i) {
      times.push_back(lower + (upper - lower) * i / count);
    }
    const std::vector<Band> expected = envelope.columns(times);
    ASSERT_EQ(cache.bands().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(cache.times()[i], times[i], 1e-9) << i;
      for (const QuantityId channel : {QuantityId::feed, QuantityId::acceleration_x}) {
        const Extent& found = cache.bands()[i][channel];
        EXPECT_NEAR(found.min, expected[i][channel].min, 0.01F + 1e-3F * std::abs(found.min)) << i;
        EXPECT_NEAR(found.max, expected[i][channel].max, 0.01F + 1e-3F * std::abs(found.max)) << i;
      }
    }
  }

  std::shared_ptr<const Trajectory> trajectory = test::simulate_text(test::small_program).trajectory;
  Envelope envelope{trajectory};
  ColumnCache cache;
  int asked = 0;
};

TEST_F(ColumnCacheTest, AsksOnlyForWhatComesIntoSight) {
  update(0.5, 1.5);
  EXPECT_EQ(asked, count + 1);
  expect_right(0.5, 1.5);
  const double column = 1.0 / count;
  for (const int shift : {3, -7, 40, -1}) {
    const double lower = 0.5 + shift * column;
    update(0.5, 1.5);
    update(lower, lower + 1);
    EXPECT_EQ(asked, std::abs(shift) + 1) << shift;
    expect_right(lower, lower + 1);
  }
}

TEST_F(ColumnCacheTest, ManySmallStepsDoNotDrift) {
  update(0.2, 1.2);
  double lower = 0.2;
  for (int i = 0; i < 150; ++i) {
    lower += 1.0 / count;
    update(lower, lower + 1);
    EXPECT_EQ(asked, 2);
  }
  expect_right(lower, lower + 1);
}

TEST_F(ColumnCacheTest, AnotherScaleOrAFarPlaceOrAFractionIsMadeAnew) {
  update(0.5, 1.5);
  update(0.5, 1.4);
  EXPECT_EQ(asked, count + 1);
  update(3.5, 4.4);
  EXPECT_EQ(asked, count + 1);
  update(3.5 + 0.4 * 0.9 / count, 4.4 + 0.4 * 0.9 / count);
  EXPECT_EQ(asked, count + 1);
  update(3.5 + 0.4 * 0.9 / count, 4.4 + 0.4 * 0.9 / count);
  EXPECT_EQ(asked, 0);
  cache.clear();
  EXPECT_TRUE(cache.bands().empty());
  update(3.5 + 0.4 * 0.9 / count, 4.4 + 0.4 * 0.9 / count);
  EXPECT_EQ(asked, count + 1);
}

TEST_F(ColumnCacheTest, IsEmptyBeyondTheEndOfTheRun) {
  const double end = trajectory->duration();
  update(0, 2 * end);
  EXPECT_FALSE(cache.bands()[count / 2 - 1][QuantityId::feed].empty());
  for (int i = count / 2 + 1; i < count; ++i) {
    EXPECT_TRUE(cache.bands()[static_cast<std::size_t>(i)][QuantityId::feed].empty()) << i;
  }
}

}  // namespace
}  // namespace feedscope::ui
