#include "ui/program_text/find_bar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/ui/patience.h"
#include "tests/ui/program_fixture.h"
#include "ui/fields/whole_number_box.h"
#include "ui/program_text/go_to_bar.h"
#include "ui/program_text/program_panel.h"

namespace feedscope::ui {
namespace {

using test::program_of;
using testing::HasSubstr;

class ProgramPanelTest : public testing::Test {
 protected:
  ProgramPanelTest() {
    panel.resize(280, 400);
    panel.show();
    panel.activateWindow();
    panel.set_program(program_of("G1 X1 F100\nY2\n(X3)\nX4\nx5\n"));
  }

  void trigger(const QString& text) {
    for (QAction* action : panel.panel_actions()) {
      if (action->text() == text) {
        action->trigger();
        return;
      }
    }
    FAIL() << "no action " << text.toStdString();
  }
  void look_for(const QString& text) {
    trigger("Find …");
    QTest::keyClicks(&bar.input(), text);
    wait();
  }
  void wait() {
    const auto looked_for = [this] {
      const SearchQuery& query = bar.search().query();
      return query.text == bar.input().text() && query.match_case == bar.match_case().isChecked() &&
             query.whole_word == bar.whole_word().isChecked() &&
             query.regular_expression == bar.regular_expression().isChecked();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return looked_for() && !bar.search().busy(); }, patience));
  }

  ProgramPanel panel;
  ProgramView& view = panel.view();
  FindBar& bar = panel.find_bar();
  QSignalSpy chosen{&view, &ProgramView::line_chosen};
};

TEST_F(ProgramPanelTest, TypingShowsTheFirstHitAndEnterGoesOn) {
  look_for("x");
  EXPECT_TRUE(bar.isVisible());
  EXPECT_EQ(bar.status(), "1 of 4");
  EXPECT_EQ(view.selection().begin, (TextPlace{1, 3}));
  EXPECT_TRUE(chosen.isEmpty()) << "looking does not move the run's cursor";
  QTest::keyClick(&bar.input(), Qt::Key_Return);
  EXPECT_EQ(bar.status(), "2 of 4");
  EXPECT_EQ(view.selection().begin, (TextPlace{3, 1}));
  ASSERT_FALSE(chosen.isEmpty());
  EXPECT_EQ(chosen.last()[0].toUInt(), 3U);
  trigger("Find next");
  trigger("Find next");
  trigger("Find next");
  EXPECT_EQ(bar.status(), "1 of 4") << "it wraps";
  trigger("Find previous");
  EXPECT_EQ(bar.status(), "4 of 4");
  QTest::keyClick(&bar.input(), Qt::Key_Return, Qt::ShiftModifier);
  EXPECT_EQ(bar.status(), "3 of 4");
}

TEST_F(ProgramPanelTest, EnterDoesNotWaitForTheTypingToRest) {
  trigger("Find …");
  QTest::keyClicks(&bar.input(), "y2");
  QTest::keyClick(&bar.input(), Qt::Key_Return);
  wait();
  EXPECT_EQ(view.selected_text(), "Y2");
  ASSERT_FALSE(chosen.isEmpty());
  EXPECT_EQ(chosen.last()[0].toUInt(), 2U);
}

TEST_F(ProgramPanelTest, ButtonsNarrowTheSearch) {
  look_for("x");
  QTest::mouseClick(&bar.match_case(), Qt::LeftButton);
  wait();
  EXPECT_THAT(bar.status().toStdString(), HasSubstr("of 1"));
  EXPECT_EQ(view.selected_text(), "x");
  QTest::mouseClick(&bar.match_case(), Qt::LeftButton);
  QTest::mouseClick(&bar.whole_word(), Qt::LeftButton);
  wait();
  EXPECT_EQ(bar.status(), "not found");
}

TEST_F(ProgramPanelTest, AWrongExpressionIsSaidInPlace) {
  trigger("Find …");
  QTest::mouseClick(&bar.regular_expression(), Qt::LeftButton);
  look_for("X[");
  EXPECT_THAT(bar.status().toStdString(), HasSubstr("At character"));
  QTest::keyClicks(&bar.input(), "45]");
  wait();
  EXPECT_THAT(bar.status().toStdString(), HasSubstr("of 2"));
}

TEST_F(ProgramPanelTest, TheSelectionIsLookedForAtOnce) {
  view.select({{4, 0}, {4, 2}});
  trigger("Find …");
  wait();
  EXPECT_EQ(bar.input().text(), "X4");
  EXPECT_EQ(bar.status(), "1 of 1");
}

TEST_F(ProgramPanelTest, EscapeClosesTheBarAndNothingElse) {
  look_for("x");
  QKeyEvent escape(QEvent::ShortcutOverride, Qt::Key_Escape, {});
  escape.ignore();
  QCoreApplication::sendEvent(&bar.input(), &escape);
  EXPECT_TRUE(escape.isAccepted());
  QTest::keyClick(&bar.input(), Qt::Key_Escape);
  EXPECT_FALSE(bar.isVisible());
  EXPECT_EQ(bar.search().found(), nullptr);
}

TEST_F(ProgramPanelTest, AnotherProgramIsSearchedAnew) {
  look_for("x");
  panel.set_program(program_of("X1\nX2\n"));
  wait();
  EXPECT_THAT(bar.status().toStdString(), HasSubstr("2"));
  panel.set_program(nullptr);
  wait();
  trigger("Find next");
  EXPECT_EQ(bar.search().found(), nullptr);
}

TEST_F(ProgramPanelTest, GoesToALine) {
  trigger("Go to line …");
  GoToBar& go_to = panel.go_to_bar();
  EXPECT_TRUE(go_to.isVisible());
  EXPECT_EQ(go_to.input().maximum(), 5);
  go_to.input().selectAll();
  QTest::keyClicks(&go_to.input(), "4");
  QTest::keyClick(&go_to.input(), Qt::Key_Return);
  EXPECT_FALSE(go_to.isVisible());
  EXPECT_EQ(view.caret(), (TextPlace{4, 0}));
  ASSERT_FALSE(chosen.isEmpty());
  EXPECT_EQ(chosen.last()[0].toUInt(), 4U);
}

TEST_F(ProgramPanelTest, FitsTheNarrowDock) {
  look_for("x");
  EXPECT_LE(panel.minimumSizeHint().width(), 270);
}

TEST_F(ProgramPanelTest, EveryCommandHasATip) {
  ASSERT_GE(panel.panel_actions().size(), 6);
  for (const QAction* action : panel.panel_actions()) {
    EXPECT_FALSE(action->text().isEmpty());
    EXPECT_NE(action->toolTip(), action->text());
  }
}

}  // namespace
}  // namespace feedscope::ui
