#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command_line.h"
#include "tests/support/folders.h"

namespace feedscope::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Programs that go to positions of the machine, and machines that do or do not say where those are.
class MachinePositions : public CommandLine {
 protected:
  MachinePositions() {
    write("iso.nc",
          "G21 G90 G54 G17\nT1 M6\nG0 X100. Y50. S1000 M3\nG43 Z5. H1\nG1 Z-20. F200\nX150. F500\n"
          "G28 G91 Z0\nG90\nT2 M6\nG0 X0 Y0\nM3\nG43 Z5. H2\nG1 Z-5. F200\nG0 Z50.\nM30\n");
    write("heidenhain.h",
          "0 BEGIN PGM O MM\n1 TOOL CALL 1 Z S3000 F500\n2 L Z+0 R0 FMAX M91\n3 L X+100 Y+50 R0 FMAX M3\n"
          "4 L Z+5 FMAX\n5 L Z-20 F200\n6 L X+150 F500\n7 L Z-380 R0 FMAX M91\n8 TOOL CALL 2 Z S3000 F500\n"
          "9 L X+0 Y+0 R0 FMAX M3\n10 L Z+5 FMAX\n11 L Z-5 F200\n12 M30\n13 END PGM O MM\n");
    const std::string bare = contents(fs::path(FEEDSCOPE_SOURCE_DIR) / "machines" / "spinner-mvc850.toml");
    write("bare.toml", bare);
    std::string full = bare;
    const auto give = [&](const std::string& key, double value) {
      full += key + " = { value = " + std::to_string(value) + ", source = \"test\" }\n";
    };
    give("tool_change_time_s", 4.5);
    give("spindle_start_time_s", 1.25);
    for (const char axis : std::string("xyz")) {
      give(std::string("part_zero_") + axis + "_mm", axis == 'z' ? -400 : -300);
      give(std::string("home_") + axis + "_mm", 0);
      give(std::string("tool_change_") + axis + "_mm", -10);
    }
    write("full.toml", full);
    write("offsets.toml",
          bare + "[work_offsets]\nG55 = { x_mm = 100, y_mm = 0, z_mm = 0, source = \"test\" }\n");
  }

  json simulate(const std::string& arguments) const {
    const Result result = run("simulate " + arguments + " --json -");
    EXPECT_EQ(result.code, 0) << arguments << "\n" << result.err;
    return result.code == 0 ? json::parse(result.out) : json();
  }

  static std::map<std::string, int> not_counted(const json& report) {
    std::map<std::string, int> counts;
    for (const json& item : report["not_counted"]) {
      counts[item["what"]] = item["count"];
    }
    return counts;
  }
};

/// The time that the machine adds is the time of its changes and starts and of the moves, which are rapids:
/// more than their length at the speed of the fastest axis.
TEST_F(MachinePositions, EveryModelRunsThemKnownAndUnknown) {
  for (const char* model : {"cam", "essid", "gassara", "tapie", "msaddek", "ward", "optimal"}) {
    for (const char* program : {"iso.nc", "heidenhain.h"}) {
      const std::string call = std::string(program) + " --model " + model + " --machine ";
      const json unknown = simulate(call + "bare.toml");
      const json known = simulate(call + "full.toml");
      if (unknown.is_null() || known.is_null()) {
        continue;
      }
      const bool iso = std::string(program) == "iso.nc";
      const std::map<std::string, int> expected{
          {"tool_change", 2}, {"spindle_start", 2}, {"machine_move", iso ? 3 : 6}};
      EXPECT_EQ(not_counted(unknown), expected) << call;
      EXPECT_TRUE(not_counted(known).empty()) << call;
      EXPECT_NEAR(known["time_by_cause_s"]["tool_change"], 9, 1e-9) << call;
      EXPECT_NEAR(known["time_by_cause_s"]["spindle_start"], 2.5, 1e-9) << call;
      EXPECT_GT(known["cycle_time_s"], unknown["cycle_time_s"].get<double>() + 11.5 + 2) << call;
      EXPECT_LT(known["cycle_time_s"], unknown["cycle_time_s"].get<double>() + 11.5 + 20) << call;
      EXPECT_EQ(known["max_contour_error_mm"], unknown["max_contour_error_mm"]) << call;
    }
  }
}

TEST_F(MachinePositions, TheSummarySaysWhatIsMissing) {
  EXPECT_THAT(run("simulate iso.nc --machine bare.toml").out,
              HasSubstr("2 tool changes, 2 spindle starts, 3 moves to or from machine positions"));
  EXPECT_THAT(run("simulate iso.nc --machine full.toml").out, Not(HasSubstr("not in the cycle time")));
  EXPECT_THAT(run("compare iso.nc --machine bare.toml --model cam --model essid").out,
              HasSubstr("Not in the cycle time: 2 tool changes"));
}

TEST_F(MachinePositions, AMachineGivesWorkOffsets) {
  write("two.nc", "G21 G90 G54 G1 X10 Y0 Z0 F600\nG55 G1 X10 Y0 Z0\n");
  const auto right = [&](const std::string& options) {
    return simulate("two.nc --dialect fanuc --model cam" + options)["program"]["bounds"]["max"][0];
  };
  EXPECT_EQ(right(" --machine bare.toml"), 10);
  EXPECT_EQ(right(" --machine offsets.toml"), 110);
  EXPECT_EQ(right(" --machine offsets.toml --offset G55=5,0,0"), 15);
  const std::string note = "read with work offsets other than those of the machine";
  const std::string compare = "compare two.nc --dialect fanuc --model cam ";
  EXPECT_THAT(run(compare + "--machine bare.toml --machine offsets.toml").err, HasSubstr(note));
  EXPECT_THAT(run(compare + "--machine offsets.toml").err, Not(HasSubstr(note)));
}

}  // namespace
}  // namespace feedscope::test
