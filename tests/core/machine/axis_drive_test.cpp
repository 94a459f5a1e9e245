#include "core/machine/axis_drive.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/machine/machine.h"

namespace feedscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* limits = R"(velocity_m_min = { value = 20, source = "table 1" }
acceleration_m_s2 = { value = 1.5, source = "table 1" }
jerk_m_s3 = { value = 15, source = "table 1" }
blend_jerk_m_s3 = { value = 10, assumed = "guess" }
)";

Machine machine_with(const std::string& drive_of_x) {
  const std::string text =
      std::string("id = \"test\"\nname = \"T\"\ncontrol = \"C\"\nreference = \"R\"\nmodel = \"cam\"\n") +
      "[axes.X]\n" + limits + drive_of_x + "[axes.Y]\n" + limits + "[axes.Z]\n" + limits + "[settings]\n";
  return parse_machine(text, "test.toml", {});
}

constexpr const char* whole_drive = R"(kv_1_s = { value = 60, source = "machine data 32200" }
velocity_feedforward = { value = 0.99, source = "machine data 32610" }
velocity_lag_ms = { value = 6.3, assumed = "fitted" }
backlash_um = { value = 4, source = "circular test" }
backlash_compensation = { value = 0.5, source = "machine data 32450" }
friction_spike_um = { value = 3.7, source = "circular test" }
friction_time_ms = { value = 20, source = "circular test" }
)";

TEST(AxisDrive, IsReadInInsideUnitsWithItsSources) {
  const Machine machine = machine_with(whole_drive);
  const AxisDrive& drive = machine.drives[0];
  EXPECT_EQ(drive.gain, 60);
  EXPECT_EQ(drive.feedforward, 0.99);
  EXPECT_EQ(drive.lag, 6.3 / 1000);
  EXPECT_EQ(drive.backlash, 0.004);
  EXPECT_EQ(drive.backlash_compensation, 0.5);
  EXPECT_EQ(drive.friction_spike, 3.7 / 1000);
  EXPECT_EQ(drive.friction_time, 0.02);
  EXPECT_TRUE(machine.drives[1].follows_exactly());
  EXPECT_EQ(machine.provenance.at("X.kv").source, "machine data 32200");
  EXPECT_TRUE(machine.provenance.at("X.velocity_lag").assumed);
}

TEST(AxisDrive, IsWrittenAndReadBackTheSame) {
  const Machine machine = machine_with(whole_drive);
  EXPECT_EQ(parse_machine(write_machine(machine), "copy", {}), machine);
  const Machine without = machine_with("");
  EXPECT_EQ(write_machine(without).find("kv"), std::string::npos);
  EXPECT_EQ(parse_machine(write_machine(without), "copy", {}), without);
}

TEST(AxisDrive, ValuesAreInTheUnitOfTheirKeyAndCanBeTakenBack) {
  Machine machine = machine_with("");
  EXPECT_EQ(axis_value(machine, 'Y', "velocity_lag"), SettingValue(std::string()));
  for (const double value : {6.0, 0.1, 7.3, 1000.0}) {
    set_axis_value(machine, 'Y', "velocity_lag", value);
    EXPECT_EQ(axis_value(machine, 'Y', "velocity_lag"), SettingValue(value));
  }
  EXPECT_EQ(machine.provenance.at("Y.velocity_lag").source, "set by hand");
  set_axis_value(machine, 'Y', "velocity_lag", std::string());
  EXPECT_EQ(machine, machine_with(""));
  set_axis_value(machine, 'Y', "jerk", 33.0);
  EXPECT_EQ(axis_limit(machine, 'Y', "jerk"), 33);
}

TEST(AxisDrive, ValuesOutOfBoundsAreRefusedWithTheBound) {
  Machine machine = machine_with("");
  struct Case {
    const char* key;
    double value;
    const char* says;
  };
  for (const Case& c :
       {Case{"kv", 0, "at least 0.1 1/s"}, Case{"kv", -60, "at least 0.1 1/s"},
        Case{"velocity_lag", -1, "at least 0 ms and at most 1000 ms"},
        Case{"velocity_feedforward", 1.01, "at least 0 and at most 1"}, Case{"backlash", -2, "at least 0 um"},
        Case{"friction_time", 0, "at least 0.01 ms"}}) {
    EXPECT_THAT([&] { set_axis_value(machine, 'X', c.key, c.value); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(std::string("X.") + c.key), HasSubstr(c.says))));
  }
  EXPECT_THAT([&] { set_axis_value(machine, 'X', "kvv", 60.0); },
              ThrowsMessage<InputError>(HasSubstr("did you mean 'kv'?")));
  EXPECT_EQ(machine, machine_with(""));
}

TEST(AxisDrive, ThatLacksWhatItNeedsIsRefusedWithItsPlace) {
  EXPECT_THAT(
      [] { machine_with("velocity_lag_ms = { value = 6, source = \"s\" }\n"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("test.toml"), HasSubstr("axis X"), HasSubstr("give X.kv"))));
  EXPECT_THAT([] { machine_with("kv_1_s = { value = 60 }\n"); },
              ThrowsMessage<InputError>(HasSubstr("source")));
  EXPECT_THAT([] { machine_with("kv = { value = 60, source = \"s\" }\n"); },
              ThrowsMessage<InputError>(HasSubstr("kv_1_s")));
  Machine machine = machine_with("");
  set_axis_value(machine, 'Z', "backlash", 5.0);
  EXPECT_THAT([&] { check_drives(machine); }, ThrowsMessage<InputError>(HasSubstr("give Z.kv in 1/s")));
}

}  // namespace
}  // namespace feedscope
