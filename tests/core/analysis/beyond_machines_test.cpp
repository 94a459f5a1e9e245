#include "core/analysis/run/beyond_machines.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/analysis/run/run.h"
#include "core/base/error.h"

namespace feedscope {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

LoadedProgram read_part(const std::string& text) {
  return load_program(std::make_shared<const SourceText>(SourceText("part.nc", text)));
}

/// "line: message" of the error; empty: there is none.
std::string fault_of(const std::string& text) {
  const std::optional<Diagnostic> found = beyond_machines(*read_part(text).toolpath);
  return found ? fmt::format("{}: {}", found->line, found->message.english()) : "";
}

TEST(BeyondMachines, APathMaySpanAKilometreAlongEachAxis) {
  EXPECT_EQ(fault_of("G21\nG0 X-400000 Y0\nG1 X599000 F60000\n"), "");
  EXPECT_EQ(fault_of("G21\nG0 X-400000 Y0\nG1 X601000 F60000\n"),
            "3: X goes to 0.601 km, beyond the travel of any machine");
}

TEST(BeyondMachines, ASmallPartMayLieFarFromTheZeroPoint) {
  EXPECT_EQ(fault_of("G21\nG0 X500000 Y4200000 Z0\nG1 X500010 F1000\n"), "");
  EXPECT_EQ(fault_of("G21\nG0 X0 Y500000000\n"), "2: Y goes to 500 km, beyond the travel of any machine");
}

TEST(BeyondMachines, AnArcOfALargeRadiusMayBeShort) {
  EXPECT_EQ(fault_of("G21 G17\nG0 X0 Y0\nG3 X10 Y0 R7000000 F600\n"), "");
  EXPECT_EQ(fault_of("G21 G17\nG0 X0 Y0\nG3 X-10 Y0 R-7000000 F600\n"),
            "3: a motion of 43.98 km is longer than any machine makes");
}

TEST(BeyondMachines, AYearMayPassAtTheProgrammedFeeds) {
  constexpr double minutes = 365 * 24 * 60;
  EXPECT_EQ(fault_of(fmt::format("G21\nG0 X0\nG1 X100 F{:.9f}\n", 100 / minutes * 1.001)), "");
  EXPECT_THAT(fault_of(fmt::format("G21\nG0 X0\nG1 X60 F{:.9f}\nX100.2\n", 100 / minutes)),
              AllOf(HasSubstr("4: 365.7 days pass"), HasSubstr("more than a year")));
  EXPECT_THAT(fault_of("G21\nG0 X0\nG1 X10 F100\nG4 P86400000\nG4 P31536000.\n"),
              HasSubstr("5: 366 days pass up to this line, which waits for 365"));
}

TEST(BeyondMachines, SuchAProgramIsReadAndNotSimulated) {
  const LoadedProgram program = read_part("G21\nG1 X10 F100\nG0 X999999999\n");
  EXPECT_TRUE(has_errors(program.program->diagnostics));
  EXPECT_THAT([&] { simulate_run(program, make_setup({})); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("part.nc, line 3: X goes to 1000 km"), HasSubstr("decimal point"))));
}

}  // namespace
}  // namespace feedscope
