#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/core/program/iso/iso_text.h"

namespace feedscope {
namespace {

std::vector<Vec3> targets(const std::string& text) {
  std::vector<Vec3> all;
  for (const MotionBlock& block : read_clean_as(Dialect::linuxcnc, text).motions) {
    all.push_back(block.target);
  }
  return all;
}

void expect_near(const Vec3& point, const Vec3& expected) {
  EXPECT_LT((point - expected).norm(), 1e-9) << point.transpose() << " against " << expected.transpose();
}

TEST(IsoPolarWords, DistanceAndAngleAreAbsoluteFromTheOrigin) {
  const std::vector<Vec3> path = targets("G1 F100\n@10 ^90 Z3\n^180\n@5\nG20 @[1/2] ^-90");
  expect_near(path[0], {0, 10, 3});
  expect_near(path[1], {-10, 0, 3});
  expect_near(path[2], {-5, 0, 3});
  expect_near(path[3], {0, -12.7, 3});
}

TEST(IsoPolarWords, IncrementalOnesAddToWhereTheToolIs) {
  const std::vector<Vec3> path = targets("G0 X3 Y4\nG91 @5\n^90");
  expect_near(path[1], {6, 8, 0});
  expect_near(path[2], {-8, 6, 0});
}

TEST(IsoPolarWords, RepeatedHolesGoRound) {
  const ReadProgram program =
      read_clean_as(Dialect::linuxcnc, "G0 X8 Y0 Z5 F60\nG91 G99 G81 ^[360/6] R-4 Z-2 L6\n");
  int holes = 0;
  for (const MotionBlock& block : program.motions) {
    if (block.motion == Motion::line) {
      ++holes;
      const double angle = holes * std::numbers::pi / 3;
      expect_near(block.target, {8 * std::cos(angle), 8 * std::sin(angle), -1});
    }
  }
  EXPECT_EQ(holes, 6);
}

TEST(IsoPolarWords, WhatHasNoMeaningIsSaid) {
  EXPECT_EQ(
      said_of(Dialect::linuxcnc, "G0 X5\n@3 ^0 X7"),
      "f:2:1: error: @ in a block with X or Y [polar-words] (X and Y are ignored; write either of them)");
  EXPECT_EQ(said_of(Dialect::linuxcnc, "G0 Z5\n@3"),
            "f:2:1: error: the tool is at X0 Y0, where it has no angle [polar-words] (angle zero is used; "
            "write both @ and ^ with G90)");
  EXPECT_EQ(said_of(Dialect::fanuc, "G0 X5\n@3"),
            "f:2:1: error: \"@\" does not start a word [unknown-character] (the rest of the line is skipped "
            "and the block does not move; remove the character)");
}

}  // namespace
}  // namespace feedscope
