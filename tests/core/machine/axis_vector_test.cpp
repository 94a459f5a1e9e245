#include "core/machine/axis_vector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/base/error.h"
#include "core/limits/axis_share.h"
#include "core/machine/machine.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr AxisList two_axes{{'X'}, {'Z'}};
constexpr AxisList with_rotary{{'X'}, {'Y'}, {'Z'}, {'A', AxisKind::rotary}};

TEST(AxisVector, HasOneValueForEachAxisWithItsName) {
  AxisVector<double> values(two_axes);
  values[0] = 1;
  values[1] = 2;
  EXPECT_THAT(std::vector<double>(values.begin(), values.end()), ElementsAre(1, 2));
  EXPECT_EQ(values.name(1), 'Z');
  EXPECT_EQ(*values.find('Z'), 2);
  EXPECT_EQ(values.find('Y'), nullptr);
  EXPECT_EQ(AxisVector<int>().size(), known_axes.size());
}

TEST(AxisVector, IsEqualByAxesAndValues) {
  AxisVector<int> values(with_rotary);
  EXPECT_EQ(values, AxisVector<int>(with_rotary));
  EXPECT_NE(values, AxisVector<int>());
  values[3] = 1;
  EXPECT_NE(values, AxisVector<int>(with_rotary));
}

TEST(Machine, NamesItsOwnAxes) {
  Machine machine;
  machine.axes = AxisVector<AxisLimits>(with_rotary);
  set_axis_limit(machine, 'A', "jerk", 20);
  EXPECT_EQ(axis_limit(machine, 'A', "jerk"), 20);
  EXPECT_EQ(machine.axes[3].jerk, 20000);
  EXPECT_TRUE(machine.provenance.contains("A.jerk"));
  EXPECT_THAT([&] { set_axis_limit(machine, 'C', "jerk", 20); },
              ThrowsMessage<InputError>(HasSubstr("the axes are X, Y, Z and A")));
  EXPECT_THAT(write_machine(machine), HasSubstr("[axes.A]"));
}

TEST(Machine, WithoutAnAxisHasNoLimitOfThatCoordinate) {
  Machine machine;
  machine.axes = AxisVector<AxisLimits>(two_axes);
  machine.axes[0].jerk = 3;
  machine.axes[1].jerk = 5;
  EXPECT_EQ(axis_limit_vector(machine, &AxisLimits::jerk), Vec3(3, 0, 5));
}

}  // namespace
}  // namespace feedscope
