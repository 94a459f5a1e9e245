#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/machine/machine.h"

namespace feedscope {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

std::vector<SettingSpec> model_settings() {
  SettingSpec reading;
  reading.key = "reading";
  reading.choices = {"corrected", "published"};
  return {reading};
}

constexpr const char* good_file = R"(id = "test"
name = "Test machine"
control = "Control 1"
reference = "Nobody 2020"
model = "cam"

[axes.X]
velocity_m_min = { value = 20, source = "table 1" }
acceleration_m_s2 = { value = 1.5, source = "table 1" }
jerk_m_s3 = { value = 15, source = "table 1" }
blend_jerk_m_s3 = { value = 10, assumed = "guess" }
[axes.Y]
velocity_m_min = { value = 20, source = "table 1" }
acceleration_m_s2 = { value = 1.5, source = "table 1" }
jerk_m_s3 = { value = 15, source = "table 1" }
blend_jerk_m_s3 = { value = 10, assumed = "guess" }
[axes.Z]
velocity_m_min = { value = 20, source = "table 1" }
acceleration_m_s2 = { value = 1.5, source = "table 1" }
jerk_m_s3 = { value = 15, source = "table 1" }
blend_jerk_m_s3 = { value = 10, assumed = "guess" }

[settings]
lookahead_blocks = { value = 8, source = "table 2" }
reading = { value = "published", assumed = "as measured" }
)";

/// A file in a folder of its own that goes away with the test.
class MachineFile : public testing::Test {
 protected:
  MachineFile() {
    std::string name = (fs::temp_directory_path() / "feedscope-machine-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~MachineFile() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text, const std::string& name = "test.toml") const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  /// good_file with its first `from` replaced.
  fs::path changed(const std::string& from, const std::string& to) const {
    std::string text = good_file;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return write(text.replace(at, from.size(), to));
  }
  static Machine read(const fs::path& file) { return read_machine(file, model_settings()); }
  /// Reading `file` must fail at line:column with `message`.
  static void expect_error(const fs::path& file, const std::string& place, const std::string& message) {
    EXPECT_THAT([&] { read(file); },
                ThrowsMessage<InputError>(AllOf(StartsWith(file.string() + place), HasSubstr(message))));
  }

  fs::path folder_;
};

TEST_F(MachineFile, IsReadWithUnitsAndSources) {
  const Machine machine = read(write(good_file));
  EXPECT_EQ(machine.id, "test");
  EXPECT_EQ(machine.name, "Test machine");
  EXPECT_EQ(machine.control, "Control 1");
  EXPECT_EQ(machine.reference, "Nobody 2020");
  EXPECT_EQ(machine.model, "cam");
  EXPECT_EQ(machine.axes[2], (AxisLimits{20000.0 / 60, 1500, 15000, 10000}));
  EXPECT_EQ(machine.settings.number("lookahead_blocks"), 8);
  EXPECT_EQ(machine.settings.text("reading"), "published");
  EXPECT_EQ(machine.provenance.at("X.jerk"), (Provenance{"table 1", false}));
  EXPECT_EQ(machine.provenance.at("X.blend_jerk"), (Provenance{"guess", true}));
  EXPECT_EQ(machine.provenance.at("lookahead_blocks"), (Provenance{"table 2", false}));
}

TEST_F(MachineFile, NamesAMisspeltKey) {
  expect_error(changed("velocity_m_min", "velocty_m_min"),
               ":8:1: ", "unknown key 'velocty_m_min' in [axes.X]; did you mean 'velocity_m_min'?");
  expect_error(changed("control =", "controll ="), ":3:1: ", "did you mean 'control'?");
  expect_error(changed("lookahead_blocks", "look_ahead_blocks"),
               ":24:1: ", "did you mean 'lookahead_blocks'?");
  expect_error(changed("source = \"table 1\"", "sorce = \"table 1\""), ":8:", "did you mean 'source'?");
  expect_error(changed("[axes.Y]", "[axes.U]"), ":12:", "unknown key 'U' in [axes]; known: X, Y, Z");
}

TEST_F(MachineFile, NamesAWrongUnit) {
  expect_error(changed("velocity_m_min", "velocity_mm_min"), ":8:1: ", "did you mean 'velocity_m_min'?");
  expect_error(changed("jerk_m_s3", "jerk_mm_s3"), ":10:1: ", "did you mean 'jerk_m_s3'?");
}

TEST_F(MachineFile, NamesAMissingKey) {
  expect_error(changed("model = \"cam\"", ""), ":1:1: ", "key 'model' is missing in the file");
  expect_error(changed("jerk_m_s3 = { value = 15, source = \"table 1\" }\n", ""),
               ":7:1: ", "key 'jerk_m_s3' is missing in [axes.X]");
  expect_error(changed("value = 20, ", ""), ":8:", "key 'value' is missing in 'velocity_m_min' in [axes.X]");
}

TEST_F(MachineFile, NamesValueAndBoundOfABadNumber) {
  for (const std::string value : {"0", "-2", "nan", "inf", "-inf", "1e+308", "5e-324"}) {
    expect_error(changed("value = 20", "value = " + value), ":8:28: ",
                 "velocity_m_min = " + value + " is out of bounds; it must be at least 0.000001 m/min");
  }
  expect_error(changed("value = 8,", "value = 8.5,"), ":24:", "it must be a whole number at least 1");
}

TEST_F(MachineFile, NamesAWrongType) {
  expect_error(changed("value = 20", "value = \"fast\""), ":8:", "velocity_m_min = 'fast' is text");
  expect_error(changed("value = 20", "value = true"), ":8:", "must be a number");
  expect_error(changed("id = \"test\"", "id = 5"), ":1:6: ", "'id' in the file must be a text in quotes");
  expect_error(changed("\"published\"", "\"publishd\""),
               ":25:", "reading = 'publishd' is not a valid choice; it must be one of: corrected, published");
  expect_error(
      write("id = \"a\"\nname = \"b\"\ncontrol = \"c\"\nreference = \"d\"\nmodel = \"e\"\naxes = 3\n"),
      ":6:8: ", "'axes' in the file must be a table");
}

TEST_F(MachineFile, WantsASourceForEveryNumber) {
  expect_error(changed("{ value = 20, source = \"table 1\" }", "20"), ":8:18: ", "needs a source");
  expect_error(changed("{ value = 20, source = \"table 1\" }", "{ value = 20 }"),
               ":8:18: ", "must have one of source");
  expect_error(changed("source = \"table 1\"", "source = \"table 1\", assumed = \"guess\""),
               ":8:18: ", "must have one of source");
  expect_error(changed("source = \"table 1\"", "source = \"\""), ":8:", "must be a text in quotes");
}

TEST_F(MachineFile, NamesThePlaceOfASyntaxError) {
  expect_error(changed("name = \"Test machine\"", "name = \"Test machine"), ":2:", "not valid TOML: ");
  expect_error(changed("name =", "id ="), ":2:", "not valid TOML: ");
  expect_error(write(std::string("\0\1\2\xff", 4)), ":1:", "not valid TOML: ");
}

TEST_F(MachineFile, MustBeAReadableFile) {
  EXPECT_THAT([&] { read(folder_); },
              ThrowsMessage<InputError>(HasSubstr("is a folder; give a machine file")));
  EXPECT_THAT(
      [&] { read(folder_ / "none.toml"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("cannot read machine file"), HasSubstr("No such file"))));
  EXPECT_THAT([&] { read(write(std::string(2 << 20, '#'))); },
              ThrowsMessage<InputError>(HasSubstr("larger than")));
  expect_error(write(""), ":1:1: ", "key 'id' is missing");
}

TEST_F(MachineFile, RoundTripsBitForBit) {
  Machine machine = read(write(good_file));
  machine.name = "quote \" backslash \\ tab \t newline \n umlaut ü del \x7f";
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-3, 4);
  for (int round = 0; round < 100; ++round) {
    for (const char axis : coordinate_names) {
      for (const SettingSpec& limit : axis_limit_specs()) {
        set_axis_limit(machine, axis, limit.key, std::pow(10, exponent(random)));
      }
    }
    machine.settings.set("tangential_share", std::pow(10, exponent(random) - 5));
    machine.provenance["tangential_share"] = {"random", true};
    const std::string text = write_machine(machine);
    ASSERT_EQ(read(write(text)), machine) << text;
  }
}

TEST_F(MachineFile, GetsAReasonForNumbersWithoutProvenance) {
  Machine machine = read(write(good_file));
  machine.provenance.clear();
  EXPECT_EQ(read(write(write_machine(machine))).provenance.at("X.jerk"), (Provenance{"set by hand", false}));
}

TEST_F(MachineFile, IsFoundByIdAndByName) {
  write(good_file, "b-machine.toml");
  write(good_file, "a-machine.toml");
  write("no machine", "README.md");
  const MachineLibrary library(folder_, model_settings());
  EXPECT_EQ(library.ids(), (std::vector<std::string>{"a-machine", "b-machine"}));
  EXPECT_EQ(library.load("a-machine"), library.load((folder_ / "b-machine.toml").string()));
  EXPECT_THAT([&] { library.load("c-machine"); },
              ThrowsMessage<InputError>(
                  "unknown machine 'c-machine': neither a machine id nor a file; did you mean 'a-machine'?"));
  EXPECT_THAT([&] { library.load("zzz"); },
              ThrowsMessage<InputError>(HasSubstr("ids: a-machine, b-machine")));
  EXPECT_THAT([&] { MachineLibrary(folder_ / "none", {}); },
              ThrowsMessage<InputError>(HasSubstr("cannot read machine folder")));
}

TEST_F(MachineFile, GivesWorkOffsetsPositionsAndTimes) {
  const std::string text = std::string(good_file) +
                           "tool_change_time_s = { value = 4.5, source = \"measured\" }\n"
                           "home_z_mm = { value = 0, source = \"measured\" }\n"
                           "part_zero_z_mm = { value = -350.25, source = \"measured\" }\n"
                           "[work_offsets]\n"
                           "G55 = { x_mm = -300, y_mm = 20.5, z_mm = 0, source = \"set-up sheet\" }\n"
                           "\"g54.1p3\" = { x_mm = 1, y_mm = 2, z_mm = 3, assumed = \"as G55\" }\n";
  const Machine machine = read(write(text));
  EXPECT_EQ(machine.settings.number("tool_change_time_s"), 4.5);
  EXPECT_EQ(machine.settings.number("home_z_mm"), 0);
  EXPECT_EQ(machine.settings.number("part_zero_z_mm"), -350.25);
  EXPECT_FALSE(machine.settings.has("home_x_mm"));
  ASSERT_EQ(machine.work_offsets.all().size(), 2U);
  EXPECT_EQ(machine.work_offsets.all().at("G55"), Vec3(-300, 20.5, 0));
  EXPECT_EQ(machine.work_offsets.all().at("G54.1 P3"), Vec3(1, 2, 3));
  EXPECT_EQ(machine.provenance.at("G55"), (Provenance{"set-up sheet", false}));
  EXPECT_EQ(read(write(write_machine(machine), "again.toml")), machine);
}

TEST_F(MachineFile, RefusesWorkOffsetsThatAreNone) {
  const auto refuse = [this](const std::string& line, const std::string& message) {
    expect_error(write(std::string(good_file) + "[work_offsets]\n" + line + "\n"), ":27:", message);
  };
  refuse("X55 = { x_mm = 1, y_mm = 2, z_mm = 3, source = \"a\" }", "is not a work offset");
  refuse("G55 = { x_mm = 1, y_mm = 2, source = \"a\" }", "z_mm");
  refuse("G55 = { x_mm = 1, y_mm = 2, z_mm = \"3\", source = \"a\" }", "must be a number");
  refuse("G55 = { x_mm = 1, y_mm = 2e9, z_mm = 3, source = \"a\" }", "1000000");
  refuse("G55 = { x_mm = 1, y_mm = 2, z_mm = 3 }", "source");
  refuse("G55 = { x_mm = 1, y_mm = 2, z_mm = 3, x = 4, source = \"a\" }", "did you mean");
  refuse("G55 = 100", "table");
}

constexpr const char* rotary_tables_text = R"(
[axes.A]
velocity_rev_min = { value = 25, source = "t" }
acceleration_rev_s2 = { value = 2, source = "t" }
jerk_rev_s3 = { value = 20, source = "t" }
minimum_deg = { value = -100, source = "t" }
maximum_deg = { value = 50, source = "t" }
[axes.C]
velocity_rev_min = { value = 50, source = "t" }
acceleration_rev_s2 = { value = 4, source = "t" }
jerk_rev_s3 = { value = 40, source = "t" }
[kinematics]
chain = { value = "C A X Y frame Z", source = "t" }
[kinematics.A]
direction = { x = 1, y = 0, z = 0, source = "t" }
point = { x_mm = 0, y_mm = 20, z_mm = -310.1, assumed = "u" }
[kinematics.C]
direction = { x = 0, y = 0, z = 1, source = "t" }
point = { x_mm = 0, y_mm = 0, z_mm = -320, source = "t" }
)";

std::string five_axis_file(const std::string& from = "", const std::string& to = "") {
  std::string text = std::string(good_file) + rotary_tables_text;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(MachineFile, HoldsRotaryAxesWithUnitsAndSources) {
  const Machine machine = read(write(five_axis_file()));
  ASSERT_EQ(axis_names(machine), "XYZAC");
  const RotaryAxis& a = machine.kinematics.rotary[0];
  EXPECT_DOUBLE_EQ(a.velocity, 25 * 2 * std::acos(-1) / 60);
  EXPECT_DOUBLE_EQ(a.acceleration, 4 * std::acos(-1));
  EXPECT_DOUBLE_EQ(*a.maximum, 50 * std::acos(-1) / 180);
  EXPECT_EQ(a.point, Vec3(0, 20, -310.1));
  EXPECT_FALSE(machine.kinematics.rotary[1].minimum);
  EXPECT_EQ(machine.provenance.at("A.velocity").source, "t");
  EXPECT_TRUE(machine.provenance.at("kinematics.A.point").assumed);
  EXPECT_EQ(read(write(write_machine(machine), "again.toml")), machine);
}

TEST_F(MachineFile, RefusesRotaryAxesThatAreIncomplete) {
  const std::string text = five_axis_file();
  const auto refuses = [&](const std::string& from, const std::string& to, const std::string& why) {
    expect_error(write(five_axis_file(from, to)), ":", why);
  };
  refuses(text.substr(text.find("[kinematics]")), "", "does not say where it is; add [kinematics]");
  refuses("[kinematics.A]", "[kinematics.B]", "[kinematics.B] has no limits; add [axes.B]");
  refuses("jerk_rev_s3 = { value = 20, source = \"t\" }", "", "'jerk_rev_s3'");
  refuses("velocity_rev_min", "velocity_m_min", "velocity_rev_min");
  refuses(", source = \"t\" }\npoint", " }\npoint", "must have one of source");
  refuses("C A X Y frame Z", "C A X Y Z", "lacks the word frame");
  refuses("{ x = 1, y = 0, z = 0", "{ x = 0, y = 0, z = 1", "parallel");
  refuses("{ value = 50, source = \"t\" }\n[axes.C]", "{ value = -200, source = \"t\" }\n[axes.C]",
          "the travel of axis A is empty, from -100 to -200 degrees");
  refuses("point = { x_mm = 0, y_mm = 20, z_mm = -310.1,", "point = { x_mm = 0, y_mm = 20,", "z_mm");
}

}  // namespace
}  // namespace feedscope
