#include "core/drives/reversal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feedscope {
namespace {

AxisDrive with_backlash(double backlash, double compensation) {
  AxisDrive drive;
  drive.gain = 60;
  drive.backlash = backlash;
  drive.backlash_compensation = compensation;
  return drive;
}

AxisDrive with_spike(double height, double time) {
  AxisDrive drive;
  drive.gain = 60;
  drive.friction_spike = height;
  drive.friction_time = time;
  return drive;
}

TEST(Reversal, SlideStandsWhileTheMotorTurnsBackThroughTheBacklash) {
  Reversal slide(with_backlash(0.02, 0));
  slide.move(1, 1);
  EXPECT_DOUBLE_EQ(slide.lead(), -0.01);
  slide.move(-0.005, 1);  // motor back by 5 um: the slide stands
  EXPECT_DOUBLE_EQ(slide.lead(), -0.005);
  slide.move(-0.015, 1);
  EXPECT_DOUBLE_EQ(slide.lead(), 0.01);
  slide.move(-3, 1);
  EXPECT_DOUBLE_EQ(slide.lead(), 0.01);
}

TEST(Reversal, CompensationTakesItsShareOfTheBacklash) {
  Reversal slide(with_backlash(0.02, 0.75));
  slide.move(1, 1);
  EXPECT_NEAR(slide.lead(), -0.0025, 1e-15);
  EXPECT_TRUE(Reversal(with_backlash(0.02, 1)).is_rigid());
}

TEST(Reversal, SpikeHoldsTheSlideBackAgainstTheNewDirectionAndDecays) {
  Reversal slide(with_spike(0.006, 0.02));
  slide.move(1, 0.1);
  EXPECT_EQ(slide.lead(), 0);  // the first motion is no reversal
  slide.move(-0.99 * Reversal::least_reversal, 0.001);
  EXPECT_EQ(slide.lead(), 0);  // not noticed yet
  slide.move(-0.02 * Reversal::least_reversal, 1e-9);
  EXPECT_NEAR(slide.lead(), 0.006, 1e-8);
  slide.move(-1, 0.02);
  EXPECT_NEAR(slide.lead(), 0.006 * std::exp(-1), 1e-8);
  slide.move(1, 1e-9);
  EXPECT_NEAR(slide.lead(), 0.006 * std::exp(-1) - 0.006, 1e-8);
}

TEST(Reversal, TremblingBelowTheLeastReversalIsNone) {
  Reversal slide(with_spike(0.006, 0.02));
  slide.move(1, 0.1);
  for (int i = 0; i < 1000; ++i) {
    slide.move(-0.9 * Reversal::least_reversal, 1e-3);
    slide.move(0.9 * Reversal::least_reversal, 1e-3);
  }
  EXPECT_EQ(slide.lead(), 0);
}

/// A motor that goes to and fro once, as a drive without lag and all feed-forward follows its set course.
TEST(Reversal, TurningPlacesWithinACourseAreFound) {
  AxisDrive drive = with_backlash(0.02, 0);
  drive.feedforward = 1;
  const DriveLaw law(drive, 'X');
  SetCourse set;  // 1 mm forward, then back: x = 4 t - 8 t^2/2, turns at 0.5 s
  set.derivative = {0, 4, -8, 0, 0, 0};
  set.duration = 1;
  const DriveCourse course(law, set, {});
  Reversal slide(drive);
  slide.follow(course, law, 0, 0.49);
  EXPECT_NEAR(slide.lead(), -0.01, 1e-9);
  slide.follow(course, law, 0.49, 0.5 + 0.05);  // back by 4 * 0.05^2 = 0.01 mm
  EXPECT_NEAR(slide.lead(), 0, 1e-9);
  slide.follow(course, law, 0.55, 1);
  EXPECT_NEAR(slide.lead(), 0.01, 1e-9);
}

}  // namespace
}  // namespace feedscope
