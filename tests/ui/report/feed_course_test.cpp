#include "ui/report/blocks/feed_course.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

/// A line of 100 mm from rest to rest: its parts take together the cycle time, and the last one has lost what
/// the whole program loses.
TEST(FeedCourse, PartsOfALineMakeUpItsTime) {
  const feedscope::Run run = test::simulate_text("G21 G90 G94 F3000\nG1 X100\nM30\n");
  for (const std::size_t parts : {1U, 7U, 300U}) {
    const FeedCourse course = feed_course(run, parts);
    EXPECT_DOUBLE_EQ(course.length, 100);
    ASSERT_EQ(course.feed.size(), parts);
    double time = 0;
    for (const double feed : course.feed) {
      time += 100.0 / static_cast<double>(parts) / feed;
    }
    EXPECT_NEAR(time, run.summary.cycle_time, 1e-9);
    EXPECT_NEAR(course.lost.back(), run.summary.cycle_time - 2, 1e-9) << "100 mm at 50 mm/s are programmed";
    EXPECT_NEAR(course.programmed.front(), 50, 1e-9);
  }
}

TEST(FeedCourse, RapidsAndPausesAreLeftOut) {
  const feedscope::Run plain = test::simulate_text("G21 G90 G94 F3000\nG1 X100\nM30\n");
  const feedscope::Run more = test::simulate_text("G21 G90 G94 F3000\nG0 Y50\nG4 X2\nG1 X100\nG0 Y0\nM30\n");
  const FeedCourse one = feed_course(plain, 10);
  const FeedCourse other = feed_course(more, 10);
  EXPECT_DOUBLE_EQ(other.length, 100);
  EXPECT_NEAR(other.lost.back(), one.lost.back(), 0.05) << "but for the corners";
}

TEST(FeedCourse, IsEmptyWithoutFeedMotions) {
  EXPECT_EQ(feed_course(test::simulate_text("G21 G0 X10\nM30\n"), 10).length, 0);
}

}  // namespace
}  // namespace feedscope::ui
