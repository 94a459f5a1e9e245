#include "ui/shared/cursor.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class CursorTest : public testing::Test {
 protected:
  void SetUp() override { cursor.set_trajectory(trajectory); }

  std::shared_ptr<const Trajectory> trajectory = test::simulate_text(test::small_program).trajectory;
  Cursor cursor;
};

TEST_F(CursorTest, StartsAtTheBeginning) {
  EXPECT_TRUE(cursor.valid());
  EXPECT_EQ(cursor.state().time, 0);
  EXPECT_EQ(cursor.state().line, 2U);
}

TEST_F(CursorTest, TimePathAndLineAgree) {
  cursor.set_time(0.6 * trajectory->duration());
  const State state = cursor.state();
  cursor.set_time(0);
  cursor.set_path_length(state.path_length);
  EXPECT_NEAR(cursor.state().time, state.time, 1e-6);
  cursor.set_line(4);
  EXPECT_EQ(cursor.state().line, 4U);
}

TEST_F(CursorTest, LineThatDoesNotMoveStandsForTheNextThatDoes) {
  cursor.set_line(3);
  cursor.set_line(1);
  EXPECT_EQ(cursor.state().line, 2U);
}

TEST_F(CursorTest, LinesAreFoundWithTheirTimesAsWithoutThem) {
  Cursor quick;
  quick.set_trajectory(trajectory, std::make_shared<const LineTimes>(*trajectory));
  for (const std::uint32_t line : {4U, 0U, 1U, 2U, 3U, 5U, 6U, 99U, 4U}) {
    cursor.set_line(line);
    quick.set_line(line);
    EXPECT_NEAR(quick.state().time, cursor.state().time, 1e-9) << line;
    EXPECT_EQ(quick.state().line, cursor.state().line) << line;
  }
}

TEST_F(CursorTest, IsClampedToTheRun) {
  cursor.set_time(1e9);
  EXPECT_DOUBLE_EQ(cursor.state().time, trajectory->duration());
  cursor.set_path_length(-5);
  EXPECT_EQ(cursor.state().time, 0);
}

TEST_F(CursorTest, SaysOnceThatItMovedAndNothingWhenItDidNot) {
  QSignalSpy spy(&cursor, &Cursor::changed);
  cursor.set_time(0.1);
  cursor.set_time(0.1);
  EXPECT_EQ(spy.count(), 1);
}

TEST_F(CursorTest, AListenerThatPointsBackMakesNoLoop) {
  int calls = 0;
  QObject::connect(&cursor, &Cursor::changed, [&] {
    ++calls;
    cursor.set_time(cursor.state().time);
  });
  cursor.set_line(4);
  EXPECT_EQ(calls, 1);
}

TEST_F(CursorTest, StaysAtItsPlaceForAnotherRunOfTheProgram) {
  cursor.set_path_length(50);
  cursor.set_trajectory(test::simulate_text(test::small_program, "cam").trajectory);
  EXPECT_NEAR(cursor.state().path_length, 50, 1e-9);
}

TEST_F(CursorTest, PointsNowhereWithoutARunAndThenStartsAtTheBeginning) {
  cursor.set_time(0.3);
  cursor.set_trajectory(nullptr);
  EXPECT_FALSE(cursor.valid());
  cursor.set_time(1);
  EXPECT_EQ(cursor.state().time, 0);
  cursor.set_trajectory(trajectory);
  EXPECT_EQ(cursor.state().time, 0);
}

TEST_F(CursorTest, StepsGoThroughAllBlocksAndBack) {
  std::vector<std::uint32_t> lines{cursor.state().line};
  for (int i = 0; i < 3; ++i) {
    cursor.step_block(1);
    lines.push_back(cursor.state().line);
  }
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{2, 3, 4, 5}));
  cursor.step_block(1);
  EXPECT_DOUBLE_EQ(cursor.state().time, trajectory->duration());
  for (const std::uint32_t line : {5, 4, 3, 2}) {
    cursor.step_block(-1);
    EXPECT_EQ(cursor.state().line, line);
  }
  cursor.step_block(-1);
  EXPECT_EQ(cursor.state().time, 0);
}

TEST_F(CursorTest, AStepBackWithinABlockGoesToItsStart) {
  cursor.set_line(4);
  const double start = cursor.state().time;
  cursor.set_time(start + 0.05);
  ASSERT_EQ(cursor.state().line, 4U);
  cursor.step_block(-1);
  EXPECT_NEAR(cursor.state().time, start, 1e-8);
}

}  // namespace
}  // namespace feedscope::ui
