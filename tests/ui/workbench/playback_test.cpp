#include "ui/workbench/playback.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class PlaybackTest : public testing::Test {
 protected:
  void SetUp() override { cursor.set_trajectory(trajectory); }

  std::shared_ptr<const Trajectory> trajectory = test::simulate_text(test::small_program).trajectory;
  Cursor cursor;
};

TEST_F(PlaybackTest, FollowsTheClockTimesSpeedAndStopsAtTheEnd) {
  Playback playback(cursor);
  playback.set_duration(trajectory->duration());
  playback.play();
  EXPECT_TRUE(playback.playing());
  playback.advance(0.1);
  EXPECT_NEAR(cursor.state().time, 0.1, 1e-9);
  playback.set_speed(10);
  playback.advance(0.02);
  EXPECT_NEAR(cursor.state().time, 0.3, 1e-9);
  playback.advance(100);
  EXPECT_DOUBLE_EQ(cursor.state().time, trajectory->duration());
  EXPECT_FALSE(playback.playing());
  playback.play();
  EXPECT_EQ(cursor.state().time, 0);
}

TEST_F(PlaybackTest, GoesRoundALoop) {
  Playback playback(cursor);
  playback.set_duration(trajectory->duration());
  playback.set_loop(Playback::Loop{0.2, 0.5});
  playback.play();
  EXPECT_DOUBLE_EQ(cursor.state().time, 0.2);
  playback.advance(0.2);
  EXPECT_DOUBLE_EQ(cursor.state().time, 0.4);
  playback.advance(0.2);
  EXPECT_DOUBLE_EQ(cursor.state().time, 0.2);
  EXPECT_TRUE(playback.playing());
}

TEST_F(PlaybackTest, SpeedIsClamped) {
  Playback playback(cursor);
  playback.set_speed(0);
  EXPECT_EQ(playback.speed(), Playback::slowest);
  playback.set_speed(1e9);
  EXPECT_EQ(playback.speed(), Playback::fastest);
}

TEST_F(PlaybackTest, OfNothingDoesNotPlay) {
  Playback playback(cursor);
  playback.play();
  EXPECT_FALSE(playback.playing());
}

}  // namespace
}  // namespace feedscope::ui
