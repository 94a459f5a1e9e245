#include "ui/shared/view_range.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class ViewRangeTest : public testing::Test {
 protected:
  void SetUp() override { range.set_trajectory(trajectory, false); }

  std::shared_ptr<const Trajectory> trajectory = test::simulate_text(test::small_program).trajectory;
  ViewRange range;
};

TEST_F(ViewRangeTest, ShowsTheWholeRunAtFirst) {
  EXPECT_EQ(range.lower(), 0);
  EXPECT_DOUBLE_EQ(range.upper(), trajectory->duration());
}

TEST_F(ViewRangeTest, ZoomKeepsThePivotAtItsPlace) {
  const double pivot = 0.3 * range.length();
  range.zoom(0.5, pivot);
  EXPECT_NEAR((pivot - range.lower()) / (range.upper() - range.lower()), 0.3, 1e-12);
  EXPECT_NEAR(range.upper() - range.lower(), 0.5 * range.length(), 1e-12);
}

TEST_F(ViewRangeTest, NeverLeavesTheRun) {
  range.zoom(100, 0.1);
  EXPECT_EQ(range.lower(), 0);
  EXPECT_DOUBLE_EQ(range.upper(), range.length());
  range.zoom(0.1, range.length());
  range.pan(10 * range.length());
  EXPECT_DOUBLE_EQ(range.upper(), range.length());
  range.pan(-10 * range.length());
  EXPECT_EQ(range.lower(), 0);
  range.zoom(1e-30, 0.1);
  EXPECT_GT(range.upper(), range.lower());
}

TEST_F(ViewRangeTest, PanKeepsTheWidth) {
  range.zoom(0.25, 0.5 * range.length());
  const double width = range.upper() - range.lower();
  range.pan(0.05 * range.length());
  EXPECT_NEAR(range.upper() - range.lower(), width, 1e-12);
}

TEST_F(ViewRangeTest, AnotherAbscissaShowsTheSameStretch) {
  range.zoom(0.5, 0.5 * range.length());
  const double from = range.time_at(range.lower());
  const double to = range.time_at(range.upper());
  range.set_abscissa(Abscissa::path_length);
  EXPECT_NEAR(range.time_at(range.lower()), from, 1e-9);
  EXPECT_NEAR(range.time_at(range.upper()), to, 1e-9);
  EXPECT_NEAR(range.position_of(trajectory->state(to)), range.upper(), 1e-9);
}

TEST_F(ViewRangeTest, ColumnTimesRunFromEndToEnd) {
  for (const Abscissa abscissa : {Abscissa::time, Abscissa::path_length}) {
    range.set_abscissa(abscissa);
    range.fit();
    const std::vector<double> times = range.column_times(50);
    ASSERT_EQ(times.size(), 51U);
    EXPECT_NEAR(times.front(), 0, 1e-9);
    EXPECT_NEAR(times.back(), trajectory->duration(), 1e-6);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  }
}

TEST_F(ViewRangeTest, KeepsTheStretchForTheNextRunOnlyIfAsked) {
  range.zoom(0.5, 0);
  const double upper = range.upper();
  range.set_trajectory(trajectory, true);
  EXPECT_DOUBLE_EQ(range.upper(), upper);
  range.set_trajectory(trajectory, false);
  EXPECT_DOUBLE_EQ(range.upper(), trajectory->duration());
}

TEST_F(ViewRangeTest, GoesOnWhereWhatIsBesideTheRunTakesLonger) {
  const double end = trajectory->duration();
  range.set_end_beside(1.5 * end);
  EXPECT_DOUBLE_EQ(range.upper(), 1.5 * end);
  EXPECT_TRUE(range.shows_all());
  EXPECT_DOUBLE_EQ(range.upper_time(), end) << "the run itself is no longer";
  range.show_times(0.5 * end, 1.25 * end);
  EXPECT_DOUBLE_EQ(range.upper(), 1.25 * end);
  range.set_end_beside(0);
  EXPECT_DOUBLE_EQ(range.upper(), end);
  EXPECT_DOUBLE_EQ(range.lower(), 0.25 * end) << "as wide as before";
  range.fit();
  range.set_end_beside(0.5 * end);
  EXPECT_DOUBLE_EQ(range.upper(), end);
  range.set_end_beside(2 * end);
  range.set_abscissa(Abscissa::path_length);
  EXPECT_DOUBLE_EQ(range.upper(), trajectory->path_length()) << "both go the same way";
}

TEST_F(ViewRangeTest, SaysWhenItChanges) {
  QSignalSpy spy(&range, &ViewRange::changed);
  range.zoom(0.5, 0.1);
  range.fit();
  EXPECT_EQ(spy.count(), 2);
}

}  // namespace
}  // namespace feedscope::ui
