#include "ui/messages/diagnostics_view.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include "tests/ui/program_fixture.h"

namespace feedscope::ui {
namespace {

class DiagnosticsViewTest : public testing::Test {
 protected:
  DiagnosticsViewTest() {
    view.resize(600, 200);
    view.show();
    view.set_program(test::program_of("G21 G1 X5 F100\nX1..2\nG77.7\nM2\nG1 X8\n"));
  }
  std::pair<uint, uint> last_place() const { return {chosen.last()[0].toUInt(), chosen.last()[1].toUInt()}; }

  DiagnosticsView view;
  QSignalSpy chosen{&view, &DiagnosticsView::place_chosen};
};

TEST_F(DiagnosticsViewTest, AClickGoesToThePlace) {
  ASSERT_GE(view.model().rowCount(), 3);
  const QRect row = view.list().visualRect(view.list().model()->index(0, DiagnosticsModel::message));
  QTest::mouseClick(view.list().viewport(), Qt::LeftButton, {}, row.center());
  ASSERT_FALSE(chosen.isEmpty());
  EXPECT_EQ(last_place(), std::pair(2U, 1U));
}

TEST_F(DiagnosticsViewTest, ActionsStepThroughTheProgram) {
  QAction& next = *view.panel_actions()[0];
  QAction& previous = *view.panel_actions()[1];
  EXPECT_EQ(next.shortcut(), QKeySequence(Qt::Key_F8));
  next.trigger();
  EXPECT_EQ(last_place().first, 2U);
  view.set_place({2, 0});
  next.trigger();
  EXPECT_EQ(last_place().first, 3U);
  view.set_place({3, 0});
  previous.trigger();
  EXPECT_EQ(last_place().first, 2U);
  view.set_place({4, 0});
  previous.trigger();
  EXPECT_EQ(last_place().first, 3U);
}

TEST_F(DiagnosticsViewTest, TheFilterHoldsForTheActionsToo) {
  const int all = view.list().model()->rowCount();
  view.filter().setCurrentIndex(2);
  EXPECT_LT(view.list().model()->rowCount(), all);
  view.set_place({4, 0});
  view.panel_actions()[0]->trigger();
  EXPECT_EQ(last_place().first, 2U) << "the info on what follows the end is passed by";
}

TEST_F(DiagnosticsViewTest, AMessageOfTheApplicationHasNoPlace) {
  view.set_program(nullptr);
  view.add_message(Severity::error, "no such file");
  EXPECT_EQ(view.list().model()->rowCount(), 1);
  view.panel_actions()[0]->trigger();
  view.list().setCurrentIndex(view.list().model()->index(0, 0));
  QTest::keyClick(&view.list(), Qt::Key_Return);
  EXPECT_TRUE(chosen.isEmpty());
}

}  // namespace
}  // namespace feedscope::ui
