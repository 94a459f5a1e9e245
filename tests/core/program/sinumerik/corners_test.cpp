// RND, RNDM, CHF, CHR; DIAMON.
#include <gmock/gmock.h>

#include <cmath>

#include "core/toolpath/toolpath.h"
#include "tests/core/program/motion_text.h"
#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SinumerikCorners, RoundingAtTheEndOfItsBlockAtTheFeedOfTheNext) {
  const ReadProgram program = read_clean("G0 X0 Y0\nG1 X10 F600 RND=2\nY10 F300\n");
  EXPECT_THAT(text_of(program),
              ElementsAre("rapid 0 0 0 @1", "line 8 0 0 @2", "arc 10 2 0 @2", "line 10 10 0 @3"));
  expect_near(program.arcs.at(0).center, {8, 2, 0});
  EXPECT_NEAR(program.motions[2].feed, 5, 1e-12);
}

TEST(SinumerikCorners, ChamferByItsSideAndByItsLength) {
  EXPECT_THAT(text_of(read_clean("G0 X0 Y0\nG1 X10 F600 CHR=3\nY10\n")),
              ElementsAre("rapid 0 0 0 @1", "line 7 0 0 @2", "line 10 3 0 @2", "line 10 10 0 @3"));
  const ReadProgram program = read_clean(
      "G0 X0 Y0\nG1 X10 F600 CHF=1+1\nX20 Y10\n"
      "X30 CHF=1\nX20 Y20\n");
  EXPECT_NEAR((program.motions.at(2).target - program.motions.at(1).target).norm(), 2, 1e-9);
  EXPECT_NEAR((program.motions.at(5).target - program.motions.at(4).target).norm(), 1, 1e-9);
}

TEST(SinumerikCorners, ModalRoundingUntilItIsSwitchedOff) {
  EXPECT_THAT(
      text_of(read_clean("G0 X0 Y0 RNDM=2\nG1 X10 F600\nM8\nY10\nX0\nRNDM=0\nY0\nG0 X50\n")),
      ElementsAre("rapid 0 0 0 @1", "line 8 0 0 @2", "arc 10 2 0 @2", "line 10 8 0 @4", "arc 8 10 0 @4",
                  "line 2 10 0 @5", "arc 0 8 0 @5", "line 0 0 0 @7", "rapid 50 0 0 @8"));
}

TEST(SinumerikCorners, ARoundingTooLargeForDensePointsLeavesNoArcWithoutLength) {
  ReadProgram program =
      read_sinumerik("X1.624 Y7 RNDM=1399\nX12.968 Y8.03\nX12.225 Y8.999\nX11.399 Y9.899\n");
  EXPECT_TRUE(std::isfinite(build_toolpath(program).length()));
}

TEST(SinumerikCorners, ModalRoundingLeavesOutWhatIsNoCornerOfAContour) {
  EXPECT_THAT(text_of(read_clean("RNDM=2\nG0 X0 Y0\nG1 X10 F600\nX20\nZ-1\nY10\nG0 X0\nG4 F1\n")),
              ElementsAre("rapid 0 0 0 @2", "line 10 0 0 @3", "line 20 0 0 @4", "line 20 0 -1 @5",
                          "line 20 10 -1 @6", "rapid 0 10 -1 @7", "dwell 0 10 -1 @8"));
}

TEST(SinumerikCorners, OwnFeed) {
  const ReadProgram program =
      read_clean("G0 X0 Y0\nG1 X10 F600 RND=2 FRC=60\nY10 RND=1 FRCM=120\nX0 RND=1\nY0\n");
  EXPECT_NEAR(program.motions.at(2).feed, 1, 1e-12);
  EXPECT_NEAR(program.motions.at(4).feed, 2, 1e-12);
  EXPECT_NEAR(program.motions.at(6).feed, 2, 1e-12);
  EXPECT_NEAR(program.motions.at(5).feed, 10, 1e-12);
}

// The largest circle that fits touches the end of the shorter line.
TEST(SinumerikCorners, WhatDoesNotFitIsMadeSmaller) {
  const ReadProgram program = read_sinumerik("G0 X0 Y0\nG1 X10 F600 RND=50\nY4\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_THAT(format(program.diagnostics[0], "f"), HasSubstr("4.000 mm are used"));
  EXPECT_EQ(program.diagnostics[0].severity, Severity::warning);
  ASSERT_EQ(program.arcs.size(), 1U);
  expect_near(program.arcs[0].center, {6, 4, 0}, 1e-5);
}

TEST(SinumerikCorners, WhatCannotBeCutIsSaid) {
  const auto said = [](const std::string& text) {
    const ReadProgram program = read_sinumerik(text);
    return program.diagnostics.size() == 1 ? format(program.diagnostics[0], "f") : "";
  };
  EXPECT_THAT(said("G0 X0 Y0\nG1 X10 F600 RND=2\nZ4\n"), HasSubstr("working plane"));
  EXPECT_THAT(said("G0 X0 Y0\nM8 RND=2\nG1 X4 F600\n"), HasSubstr("without a line or arc"));
  EXPECT_THAT(said("G0 X0 Y0\nG1 X10 F600 RND=-2\nY4\n"), HasSubstr("negative"));
  EXPECT_THAT(said("G0 X0 Y0\nG1 X10 F600 RNDM=-2\nY4\n"), HasSubstr("negative"));
  EXPECT_THAT(said("G0 X0 Y0\nG1 X10 F600 CHR=2\nG2 X20 I5\n"), HasSubstr("adjacent to an arc"));
}

TEST(SinumerikDiameters, XIsADiameter) {
  EXPECT_EQ(xs_of("DIAMON\nG0 X20\nG91 X10\nDIAM90 X10\nG90 X30\nDIAMOF X5\n"),
            (std::vector<double>{10, 15, 25, 15, 5}));
}

}  // namespace
}  // namespace feedscope
