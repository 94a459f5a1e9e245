#include "core/machine/machine.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(AxisLimit, ConvertsUnitsAtTheEdge) {
  Machine machine;
  set_axis_limit(machine, 'Y', "velocity", 20);
  set_axis_limit(machine, 'Y', "acceleration", 1);
  set_axis_limit(machine, 'Y', "jerk", 15);
  set_axis_limit(machine, 'Y', "blend_jerk", 10);
  EXPECT_DOUBLE_EQ(machine.axes[1].velocity, 20000.0 / 60);
  EXPECT_EQ(machine.axes[1].acceleration, 1000);
  EXPECT_EQ(machine.axes[1].jerk, 15000);
  EXPECT_EQ(machine.axes[1].blend_jerk, 10000);
}

TEST(AxisLimit, GivesBackTheDecimalThatWasSet) {
  Machine machine;
  for (int i = 1; i < 20000; ++i) {
    const double value = i / 1000.0;
    set_axis_limit(machine, 'X', "velocity", value);
    ASSERT_EQ(axis_limit(machine, 'X', "velocity"), value);
    set_axis_limit(machine, 'X', "jerk", value);
    ASSERT_EQ(axis_limit(machine, 'X', "jerk"), value);
  }
}

TEST(AxisLimit, NotesThatAChangedValueIsSetByHand) {
  Machine machine;
  set_axis_limit(machine, 'X', "jerk", 15);
  machine.provenance["X.jerk"] = {"paper", false};
  set_axis_limit(machine, 'X', "jerk", 15);
  EXPECT_EQ(machine.provenance["X.jerk"].source, "paper");
  set_axis_limit(machine, 'X', "jerk", 16);
  EXPECT_EQ(machine.provenance["X.jerk"], (Provenance{"set by hand", false}));
}

TEST(AxisLimit, NamesUnknownAxisAndLimit) {
  Machine machine;
  EXPECT_THAT([&] { axis_limit(machine, 'A', "jerk"); },
              ThrowsMessage<InputError>(HasSubstr("unknown axis 'A'; the axes are X, Y and Z")));
  EXPECT_THAT(
      [&] { axis_limit(machine, 'X', "velocty"); },
      ThrowsMessage<InputError>(HasSubstr("unknown limit 'velocty' of axis X; did you mean 'velocity'?")));
  EXPECT_THAT(
      [&] { axis_limit(machine, 'X', "colour"); },
      ThrowsMessage<InputError>(HasSubstr("the limits are velocity, acceleration, jerk, blend_jerk")));
}

TEST(AxisLimit, MustBeWithinItsBounds) {
  Machine machine;
  for (const double value :
       {0.0, -1.0, 5e-324, 9e-7, 1.1e9, 1e305, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THAT([&] { set_axis_limit(machine, 'Z', "jerk", value); },
                ThrowsMessage<InputError>(HasSubstr(
                    "is out of bounds; it must be at least 0.000001 m/s3 and at most 1000000000 m/s3")));
  }
  EXPECT_EQ(machine.axes[2].jerk, 0);
  for (const SettingSpec& spec : axis_limit_specs()) {
    for (const double value : {1e-6, 1e9}) {
      set_axis_limit(machine, 'Z', spec.key, value);
      EXPECT_EQ(axis_limit(machine, 'Z', spec.key), value) << spec.key;
    }
  }
}

}  // namespace
}  // namespace feedscope
