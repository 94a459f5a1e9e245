#include "core/load/engagement.h"

#include <gmock/gmock.h>

#include "core/base/units.h"

namespace feedscope {
namespace {

Engagement mill(double radial_depth, Milling milling) {
  Engagement operation;
  operation.diameter = 12;
  operation.radial_depth = radial_depth;
  operation.axial_depth = 5;
  operation.milling = milling;
  return operation;
}

TEST(Immersion, OfASlotIsHalfATurn) {
  for (const Milling milling : {Milling::up, Milling::down}) {
    EXPECT_DOUBLE_EQ(immersion(mill(12, milling)).from, 0);
    EXPECT_DOUBLE_EQ(immersion(mill(12, milling)).to, units::pi);
  }
}

TEST(Immersion, OfHalfTheDiameterBeginsOrEndsInTheDirectionOfFeed) {
  EXPECT_DOUBLE_EQ(immersion(mill(6, Milling::up)).from, 0);
  EXPECT_DOUBLE_EQ(immersion(mill(6, Milling::up)).to, units::pi / 2);
  EXPECT_DOUBLE_EQ(immersion(mill(6, Milling::down)).from, units::pi / 2);
  EXPECT_DOUBLE_EQ(immersion(mill(6, Milling::down)).to, units::pi);
}

/// cos(60 degrees) = 1 - 2/4.
TEST(Immersion, OfAQuarterOfTheDiameterIsSixtyDegrees) {
  EXPECT_NEAR(immersion(mill(3, Milling::up)).to, units::pi / 3, 1e-12);
  EXPECT_NEAR(immersion(mill(3, Milling::down)).from, 2 * units::pi / 3, 1e-12);
}

TEST(Engagement, LinesAreReadAsTheyAreWritten) {
  const std::vector<ProgramLines> ranges{{10, 25}, {40, 40}};
  EXPECT_EQ(ranges_of(" 10 - 25,40"), ranges);
  EXPECT_EQ(ranges_of(ranges_text(ranges)), ranges);
  for (const char* wrong : {"", "a", "10-", "10-25,", "10;25", "-5"}) {
    EXPECT_EQ(ranges_of(wrong), std::nullopt) << wrong;
  }
}

TEST(Engagement, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(operation_problem(mill(12, Milling::up)), "");
  EXPECT_THAT(operation_problem(mill(12.5, Milling::up)).english(),
              testing::HasSubstr("ae_mm 12.5 is larger than diameter_mm 12"));
  Engagement ranged = mill(3, Milling::up);
  ranged.lines = {{20, 10}};
  EXPECT_THAT(operation_problem(ranged).english(), testing::HasSubstr("lines 20-10 is no range"));
  Engagement chips = mill(3, Milling::up);
  chips.least_chip = 0.02;
  chips.max_chip = 0.01;
  EXPECT_THAT(operation_problem(chips).english(),
              testing::HasSubstr("min_chip_um 20 is not below max_chip_um 10"));
}

TEST(Engagement, IsNamedByToolAndLines) {
  Engagement operation = mill(3, Milling::up);
  EXPECT_EQ(describe(operation), "all tools");
  operation.tool = "7";
  operation.lines = {{1, 2}, {5, 6}, {8, 9}, {11, 12}};
  EXPECT_EQ(describe(operation), "tool 7, lines 1-2, 5-6, 8-9 and 1 more");
}

}  // namespace
}  // namespace feedscope
