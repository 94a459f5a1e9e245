#include "core/analysis/notes/unreachable_feed.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run.h"
#include "core/base/units.h"
#include "tests/support/english.h"

namespace feedscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

LoadedProgram line_at(const std::string& feed) {
  return load_program(std::make_shared<const SourceText>(
      "line.nc", "G21 G90 G94\nG0 X5\nG1 X10 F1000\nX20 F" + feed + "\nX30\n"));
}

/// An axis each of 10, 20 and 20 m/min: 30 m/min along their diagonal.
SetupRequest on_three_axes() {
  SetupRequest request;
  request.assignments = {"X.velocity=10", "Y.velocity=20", "Z.velocity=20"};
  return request;
}

TEST(UnreachableFeed, IsOneAboveAllAxesTogether) {
  const auto setup = make_setup(on_three_axes());
  const auto found = [&](const std::string& feed) {
    const LoadedProgram program = line_at(feed);
    return unreachable_feed(program.largest_feed, *program.toolpath, setup.machine);
  };
  EXPECT_FALSE(found("29999"));
  const auto beyond = found("30001");
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->programmed.line, 4U);
  EXPECT_NEAR(units::to_mm_min(beyond->programmed.feed), 30001, 1e-6);
  EXPECT_NEAR(units::to_mm_min(beyond->reachable), 30000, 1e-6);
}

TEST(UnreachableFeed, IsNamedAmongTheRemarksOnARun) {
  const std::string said =
      "Line 4 asks for a feed of 9991300 mm/min; all axes of this machine together reach 30000 mm/min";
  const auto remarked = [](const std::string& feed, UnitSystem units) {
    return in_english(texts_about(remarks(simulate_run(line_at(feed), make_setup(on_three_axes())), units),
                                  {Remark::About::programmed}));
  };
  EXPECT_THAT(remarked("9991300", UnitSystem::metric), ElementsAre(HasSubstr(said)));
  EXPECT_THAT(remarked("9991300", UnitSystem::inch), ElementsAre(HasSubstr("together reach 1181 in/min")));
  EXPECT_THAT(remarked("20000", UnitSystem::metric), ::testing::IsEmpty());
}

/// "Programmed" is with the override: half of 40 m/min is reached, twice 20 m/min is not.
TEST(UnreachableFeed, IsWithTheOverrideOfTheSetup) {
  const auto found = [](const std::string& feed, const std::string& percent) {
    SetupRequest request = on_three_axes();
    request.assignments.push_back("feed_override_percent=" + percent);
    const LoadedProgram program = line_at(feed);
    return feed_beyond_machine(program, *program.toolpath, make_setup(request));
  };
  EXPECT_FALSE(found("40000", "50"));
  const auto twice = found("20000", "200");
  ASSERT_TRUE(twice);
  EXPECT_NEAR(units::to_mm_min(twice->programmed.feed), 40000, 1e-6);
}

TEST(UnreachableFeed, IsNoneOfRapidsAlone) {
  const LoadedProgram rapids = load_program(std::make_shared<const SourceText>("rapid.nc", "G0 X100\n"));
  EXPECT_FALSE(rapids.largest_feed);
}

}  // namespace
}  // namespace feedscope
