#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

using testing::ElementsAre;

/// "R5" rapid to Z5, "F-3" feed to Z-3, "D2" dwell of 2 s.
std::vector<std::string> steps_of(const std::string& call) {
  std::vector<std::string> steps;
  const ReadProgram program = read_clean("G0 Z50\nS600 F120\n" + call);
  for (std::size_t i = 1; i < program.motions.size(); ++i) {
    const MotionBlock& block = program.motions[i];
    const bool dwell = block.motion == Motion::dwell;
    const char kind = dwell ? 'D' : block.motion == Motion::rapid ? 'R' : 'F';
    std::string number = std::to_string(dwell ? block.dwell : block.target.z());
    number.erase(number.find_last_not_of('0') + 1);
    steps.push_back(kind + (number.back() == '.' ? number.substr(0, number.size() - 1) : number));
  }
  return steps;
}

TEST(SinumerikCycles, Drilling) {
  EXPECT_THAT(steps_of("CYCLE81(10,0,2,-15)"), ElementsAre("R2", "F-15", "R10"));
  EXPECT_THAT(steps_of("CYCLE81(10,5,2,,15)"), ElementsAre("R7", "F-10", "R10"));
  EXPECT_THAT(steps_of("CYCLE81(10,0,2,-15,,0.5,0,1,12)"), ElementsAre("R2", "F-15", "D0.5", "R10"));
  EXPECT_THAT(steps_of("CYCLE82(10,0,2,-15,,0.5)"), ElementsAre("R2", "F-15", "D0.5", "R10"));
  EXPECT_THAT(steps_of("CYCLE86(10,0,2,-15,0,1,3,0,0,0,0)"), ElementsAre("R2", "F-15", "D1", "R10"));
  EXPECT_THAT(steps_of("CYCLE87(10,0,2,-15,0,3)"), ElementsAre("R2", "F-15", "R10"));
  EXPECT_THAT(steps_of("CYCLE88(10,0,2,-15,0,1,3)"), ElementsAre("R2", "F-15", "D1", "R10"));
  EXPECT_THAT(steps_of("CYCLE89(10,0,2,-15,0,1)"), ElementsAre("R2", "F-15", "D1", "F2", "R10"));
}

TEST(SinumerikCycles, DeepHolesByStrokes) {
  // 20 deep: 8, then 2 less: 6; the remaining 6 is one more stroke and a half of the next, 4: two of 3.
  EXPECT_THAT(steps_of("CYCLE83(10,0,2,-20,,-8,,2,0,0,1,0)"),
              ElementsAre("R2", "F-8", "F-7", "F-14", "F-13", "F-17", "F-16", "F-20", "R10"));
  EXPECT_THAT(steps_of("CYCLE83(10,0,2,-20,,,10,0,0,1.5,1,1)"),
              ElementsAre("R2", "F-10", "R2", "D1.5", "R-9.4", "F-20", "R10"));
}

TEST(SinumerikCycles, FirstStrokeOfADeepHoleHasItsShareOfTheFeed) {
  const ReadProgram program = read_clean("G0 Z50\nF100\nCYCLE83(10,0,2,-20,,-10,,0,0,0,0.5,0)");
  EXPECT_DOUBLE_EQ(program.motions[2].feed, 50.0 / 60);
  EXPECT_DOUBLE_EQ(program.motions[4].feed, 100.0 / 60);
}

TEST(SinumerikCycles, TappingRunsAtLeadTimesSpeed) {
  const ReadProgram program = read_clean("G0 Z50\nF100\nCYCLE84(10,0,2,-15,,0,3,6,,0,300,600)\nG1 X1");
  ASSERT_EQ(program.motions.size(), 6U);
  EXPECT_DOUBLE_EQ(program.motions[2].feed, 5);
  EXPECT_DOUBLE_EQ(program.motions[3].feed, 10);
  EXPECT_DOUBLE_EQ(program.motions[5].feed, 100.0 / 60);
  const ReadProgram floating = read_clean("G0 Z50\nS600\nCYCLE840(10,0,2,-15,,0,4,3,0,,1.5)");
  EXPECT_DOUBLE_EQ(floating.motions[2].feed, 15);
}

TEST(SinumerikCycles, TappingBreaksAndClearsChips) {
  const std::string call = "CYCLE84(10,0,2,-10,,0,3,,1.5,0,600,600,,,,";
  EXPECT_THAT(steps_of(call + "0,4,1)"), ElementsAre("R2", "F-10", "F2", "R10"));
  EXPECT_THAT(steps_of(call + "1,4,1)"), ElementsAre("R2", "F-4", "F-3", "F-8", "F-7", "F-10", "F2", "R10"));
  EXPECT_THAT(steps_of(call + "2,5,1)"), ElementsAre("R2", "F-5", "F2", "F-10", "F2", "R10"));
}

class SinumerikLeads : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(SinumerikLeads, AreInTheUnitThatTheCallSays) {
  const ReadProgram program = read_clean("G0 Z50\nS60\n" + std::string(GetParam().first));
  EXPECT_NEAR(program.motions[2].feed, GetParam().second, 1e-12) << GetParam().first;
}

INSTANTIATE_TEST_SUITE_P(Units, SinumerikLeads,
                         testing::Values(std::pair("CYCLE84(10,0,2,-15,,0,3,,2,0,60,60)", 2.0),
                                         std::pair("G70 CYCLE84(1,0,2,-15,,0,3,,2,0,60,60)", 50.8),
                                         std::pair("G70 CYCLE84(1,0,2,-15,,0,3,,2,0,60,60,,1)", 2.0),
                                         std::pair("CYCLE84(10,0,2,-15,,0,3,,20,0,60,60,,2)", 1.27),
                                         std::pair("CYCLE84(10,0,2,-15,,0,3,,0.1,0,60,60,,3)", 2.54),
                                         std::pair("G70 CYCLE84(1,0,2,-15,,0,3,8,,0,60,60)", 1.25),
                                         std::pair("CYCLE840(10,0,2,-15,,0,4,3,0,,20,,2)", 1.27)));

TEST(SinumerikCycles, FineBoringLiftsTheEdgeOffTheWall) {
  const ReadProgram program = read_clean("G0 X5 Y6 Z50\nF100\nCYCLE86(10,0,2,-15,,0,3,-1,0.5,0.2,45)");
  ASSERT_EQ(program.motions.size(), 6U);
  expect_near(program.motions[3].target, {4, 6.5, -14.8});
  expect_near(program.motions[4].target, {4, 6.5, 2});
  expect_near(program.motions[5].target, {5, 6, 10});
}

TEST(SinumerikCycles, AnotherAxisThanThatAcrossThePlaneMayBeNamed) {
  const ReadProgram program = read_clean("G0 X50 Y7 Z8\nF100\nCYCLE83(40,30,2,10,,,20,0,0,0,1,0,1)");
  ASSERT_EQ(program.motions.size(), 4U);
  expect_near(program.motions[2].target, {10, 7, 8});
}

TEST(SinumerikCycles, ReamingHasFeedsOfItsOwn) {
  const ReadProgram program = read_clean("G0 Z50\nF100\nCYCLE85(10,0,2,-15,,0,60,120)");
  ASSERT_EQ(program.motions.size(), 5U);
  EXPECT_DOUBLE_EQ(program.motions[2].feed, 1);
  EXPECT_DOUBLE_EQ(program.motions[3].feed, 2);
  EXPECT_DOUBLE_EQ(program.motions[3].target.z(), 2);
}

TEST(SinumerikCycles, ToolAxisIsThatOfThePlane) {
  const ReadProgram program = read_clean("G18 G0 Y50\nF100\nCYCLE81(10,0,2,-15)");
  EXPECT_DOUBLE_EQ(program.motions[2].target.y(), -15);
}

TEST(SinumerikCycles, ModalCallDrillsAtEveryPositionRowAndCircle) {
  const auto holes = [](const std::string& positions) {
    std::vector<std::pair<double, double>> found;
    const ReadProgram program =
        read_clean("G0 Z50 F100\nMCALL CYCLE81(10,0,2,-15)\n" + positions + "\nMCALL\nG0 X99");
    for (const MotionBlock& block : program.motions) {
      if (block.motion == Motion::line) {
        found.emplace_back(std::round(block.target.x() * 1e6) / 1e6,
                           std::round(block.target.y() * 1e6) / 1e6);
      }
    }
    return found;
  };
  using Pair = std::pair<double, double>;
  EXPECT_THAT(holes("X1 Y2\nX5\nM8\nY9"), ElementsAre(Pair{1, 2}, Pair{5, 2}, Pair{5, 9}));
  EXPECT_THAT(holes("HOLES1(10,20,90,5,10,3)"), ElementsAre(Pair{10, 25}, Pair{10, 35}, Pair{10, 45}));
  EXPECT_THAT(holes("HOLES2(0,0,10,0,0,4)"),
              ElementsAre(Pair{10, 0}, Pair{0, 10}, Pair{-10, 0}, Pair{0, -10}));
  EXPECT_THAT(holes("HOLES2(1,0,10,0,90,2)"), ElementsAre(Pair{11, 0}, Pair{1, 10}));
}

}  // namespace
}  // namespace feedscope
