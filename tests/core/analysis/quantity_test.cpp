#include "core/analysis/run/quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

#include "core/base/units.h"

namespace feedscope {
namespace {

/// On a circle of radius `r` at constant speed the acceleration is v squared over r, all of it across.
State on_circle(double v, double r) {
  State state;
  state.speed = v;
  state.velocity = Vec3(0, v, 0);
  state.acceleration = Vec3(-v * v / r, 0, 0);
  return state;
}

TEST(Quantities, HaveKeysAndColumnsOfTheirOwn) {
  std::set<std::string_view> keys;
  std::set<std::string_view> columns;
  for (const QuantityInfo& quantity : all_quantities()) {
    EXPECT_TRUE(keys.insert(quantity.key).second) << quantity.key;
    EXPECT_TRUE(quantity.column.empty() || columns.insert(quantity.column).second) << quantity.column;
    EXPECT_EQ(&info_of(quantity.id), &quantity);
    ASSERT_NE(quantity.of, nullptr);
  }
}

TEST(Quantities, AccelerationAcrossIsSpeedSquaredOverRadius) {
  const auto across = info_of(QuantityId::acceleration_across).of;
  EXPECT_DOUBLE_EQ(across(on_circle(100, 5)), 2000);
  State faster = on_circle(100, 5);
  faster.acceleration += Vec3(0, 1500, 0);
  faster.tangential_acceleration = 1500;
  EXPECT_NEAR(across(faster), 2000, 1e-9);
  EXPECT_EQ(across(on_circle(0, 5)), 0);
}

TEST(Quantities, OfTheLoadAreNoNumbersWhereNothingIsCut) {
  const State state = on_circle(100, 5);
  LoadSample sample;
  sample.state = LoadState::cutting;
  sample.predicted.peak_force = 480;
  sample.programmed.peak_force = 640;
  EXPECT_EQ(info_of(QuantityId::peak_force).of(Instant(state, nullptr, &sample)), 480);
  EXPECT_EQ(info_of(QuantityId::peak_force_programmed).of(Instant(state, nullptr, &sample)), 640);
  sample.state = LoadState::plunge;
  EXPECT_TRUE(std::isnan(info_of(QuantityId::peak_force).of(Instant(state, nullptr, &sample))));
  EXPECT_TRUE(std::isnan(info_of(QuantityId::peak_force).of(Instant(state))));
}

TEST(Quantities, AreShownInTheUnitsOfBothSystems) {
  EXPECT_DOUBLE_EQ(shown_unit(Dimension::feed).factor * units::from_mm_min(3000), 3000);
  EXPECT_DOUBLE_EQ(shown_unit(Dimension::feed, UnitSystem::inch).factor * units::from_mm_min(2540), 100);
  EXPECT_EQ(shown_unit(Dimension::feed, UnitSystem::inch).text, "in/min");
  EXPECT_DOUBLE_EQ(shown_unit(Dimension::error, UnitSystem::inch).factor * 0.0254, 1);
  EXPECT_NEAR(shown_unit(Dimension::force, UnitSystem::inch).factor * 1000, 224.809, 1e-3);   // N in lbf
  EXPECT_NEAR(shown_unit(Dimension::torque, UnitSystem::inch).factor * 1e6, 737.562, 1e-3);   // N m in lbf ft
  EXPECT_NEAR(shown_unit(Dimension::power, UnitSystem::inch).factor * 745.69987e3, 1, 1e-7);  // W in hp
  for (const QuantityInfo& quantity : all_quantities()) {
    for (const UnitSystem system : {UnitSystem::metric, UnitSystem::inch}) {
      EXPECT_GT(shown_unit(quantity.dimension, system).factor, 0);
    }
  }
}

}  // namespace
}  // namespace feedscope
