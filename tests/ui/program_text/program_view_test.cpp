#include "ui/program_text/program_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include "core/analysis/time/line_times.h"
#include "tests/ui/program_fixture.h"
#include "tests/ui/run_fixture.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

using test::program_of;
using testing::HasSubstr;

std::string many_lines(int count) {
  std::string text;
  for (int i = 1; i <= count; ++i) {
    text += "G1 X" + std::to_string(i) + " Y20\n";
  }
  return text;
}

class ProgramViewTest : public testing::Test {
 protected:
  ProgramViewTest() {
    view.resize(400, 300);
    view.show();
  }

  void show_text(const std::string& text, Dialect dialect = Dialect::iso) {
    view.set_program(program_of(text, dialect));
    chosen.clear();
  }

  QPoint point_of(TextPlace place) { return view.place_rect(place).center() - QPoint(2, 0); }
  void click(TextPlace place, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(view.viewport(), Qt::LeftButton, modifiers, point_of(place));
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&view, key, modifiers); }
  void drag(TextPlace from, TextPlace to) {
    QTest::mousePress(view.viewport(), Qt::LeftButton, {}, point_of(from));
    QMouseEvent move(QEvent::MouseMove, point_of(to), view.viewport()->mapToGlobal(point_of(to)),
                     Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(view.viewport(), &move);
    QTest::mouseRelease(view.viewport(), Qt::LeftButton, {}, point_of(to));
  }
  std::uint32_t chosen_line() const { return chosen.isEmpty() ? 0 : chosen.last().first().toUInt(); }

  ProgramView view;
  QSignalSpy chosen{&view, &ProgramView::line_chosen};
};

TEST_F(ProgramViewTest, AClickGoesToTheLine) {
  show_text(many_lines(100));
  click({4, 3});
  EXPECT_EQ(chosen_line(), 4U);
  EXPECT_EQ(view.caret(), (TextPlace{4, 3}));
  EXPECT_TRUE(view.selection().empty());
}

TEST_F(ProgramViewTest, ShowLineBringsItIntoSightInSilence) {
  show_text(many_lines(1000));
  view.show_line(500);
  EXPECT_EQ(view.current_line(), 500U);
  EXPECT_EQ(view.caret().line, 500U);
  EXPECT_LE(view.first_visible_line(), 500U);
  EXPECT_GE(view.last_visible_line(), 500U);
  EXPECT_TRUE(chosen.isEmpty());
  const std::uint32_t first = view.first_visible_line();
  view.show_line(501);
  EXPECT_EQ(view.first_visible_line(), first) << "the text rests while the line is in sight";
  view.show_line(0);
  EXPECT_EQ(view.current_line(), 0U);
}

TEST_F(ProgramViewTest, ArrowKeysGoOnFromTheCurrentLine) {
  show_text(many_lines(100));
  view.show_line(7);
  press(Qt::Key_Down);
  EXPECT_EQ(chosen_line(), 8U);
  press(Qt::Key_Up);
  press(Qt::Key_Up);
  EXPECT_EQ(chosen_line(), 6U);
}

TEST_F(ProgramViewTest, TheCaretPassesLinesThatDoNotMove) {
  // The run's cursor answers a line that does not move with the next one that does.
  show_text("G1 X1 F100\n(one)\n(two)\nX2\n");
  QObject::connect(&view, &ProgramView::line_chosen, &view,
                   [this](std::uint32_t line) { view.show_line(line == 1 ? 1 : 4); });
  view.show_line(4);
  press(Qt::Key_Up);
  EXPECT_EQ(view.caret().line, 3U);
  EXPECT_EQ(view.current_line(), 4U);
  press(Qt::Key_Up);
  press(Qt::Key_Up);
  EXPECT_EQ(view.caret().line, 1U);
  EXPECT_EQ(view.current_line(), 1U);
}

TEST_F(ProgramViewTest, KeysMoveByCharacterWordPageAndToTheEnds) {
  show_text(many_lines(1000));
  press(Qt::Key_Right);
  EXPECT_EQ(view.caret(), (TextPlace{1, 1}));
  press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(view.caret(), (TextPlace{1, 3}));
  press(Qt::Key_End);
  EXPECT_EQ(view.caret(), (TextPlace{1, 9}));
  press(Qt::Key_Home);
  EXPECT_EQ(view.caret(), (TextPlace{1, 0}));
  press(Qt::Key_PageDown);
  const std::uint32_t page = view.caret().line;
  EXPECT_GT(page, 10U);
  press(Qt::Key_PageUp);
  EXPECT_EQ(view.caret().line, 1U);
  press(Qt::Key_End, Qt::ControlModifier);
  EXPECT_EQ(view.caret(), (TextPlace{1000, 12}));
  EXPECT_EQ(view.last_visible_line(), 1000U);
  press(Qt::Key_Home, Qt::ControlModifier);
  EXPECT_EQ(view.caret(), (TextPlace{1, 0}));
  EXPECT_EQ(view.first_visible_line(), 1U);
}

TEST_F(ProgramViewTest, UpAndDownKeepTheColumn) {
  show_text("G1 X100 Y100\nM3\nG1 X200 Y200\n");
  click({1, 9});
  press(Qt::Key_Down);
  EXPECT_EQ(view.caret(), (TextPlace{2, 2}));
  press(Qt::Key_Down);
  EXPECT_EQ(view.caret(), (TextPlace{3, 9}));
}

TEST_F(ProgramViewTest, CtrlHomeIsTheTextsAndNotTheWindows) {
  show_text(many_lines(10));
  QKeyEvent home(QEvent::ShortcutOverride, Qt::Key_Home, Qt::ControlModifier);
  home.ignore();
  QCoreApplication::sendEvent(&view, &home);
  EXPECT_TRUE(home.isAccepted());
  QKeyEvent space(QEvent::ShortcutOverride, Qt::Key_Space, {});
  space.ignore();
  QCoreApplication::sendEvent(&view, &space);
  EXPECT_FALSE(space.isAccepted()) << "it plays and pauses";
}

TEST_F(ProgramViewTest, DraggingSelectsAndCopies) {
  show_text("G1 X100 Y100\nG1 X200 Y200\n");
  drag({1, 3}, {2, 7});
  EXPECT_EQ(view.selected_text(), "X100 Y100\nG1 X200");
  press(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), "X100 Y100\nG1 X200");
}

TEST_F(ProgramViewTest, ShiftSelectsAndADoubleClickTakesTheWord) {
  show_text("G1 X100 Y100\nG1 X200 Y200\n");
  click({1, 3});
  press(Qt::Key_End, Qt::ShiftModifier);
  EXPECT_EQ(view.selected_text(), "X100 Y100");
  click({2, 2}, Qt::ShiftModifier);
  EXPECT_EQ(view.selected_text(), "X100 Y100\nG1");
  QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, point_of({2, 5}));
  EXPECT_EQ(view.selected_text(), "X200");
  press(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(view.selected_text(), "G1 X100 Y100\nG1 X200 Y200");
}

TEST_F(ProgramViewTest, ASelectionOutlastsPlayback) {
  show_text(many_lines(50));
  drag({2, 0}, {2, 2});
  view.show_line(9);
  EXPECT_EQ(view.selected_text(), "G1");
  press(Qt::Key_Down);
  EXPECT_EQ(chosen_line(), 10U) << "the keyboard goes on from the current line";
}

TEST_F(ProgramViewTest, LongLinesScrollSideways) {
  show_text("G1 (" + std::string(300, 'A') + ") X7\n");
  EXPECT_GT(view.horizontalScrollBar()->maximum(), 0);
  press(Qt::Key_End);
  EXPECT_GT(view.horizontalScrollBar()->value(), 0);
  EXPECT_TRUE(view.viewport()->rect().intersects(view.place_rect({1, 306})));
  press(Qt::Key_Home);
  EXPECT_EQ(view.place_rect({1, 0}).left() >= 0, true);
}

/// Where a program just fits, one scroll bar takes the room that makes the other one needed: of that, the
/// view went on laying itself out until the stack was full.
TEST_F(ProgramViewTest, AProgramThatJustFitsIsLaidOutOnce) {
  show_text(many_lines(16) + "L X+100.000 Y+100.000 Z+100.000\n", Dialect::heidenhain);
  int width = 100;  // in which the longest line just fits
  for (view.resize(width, 600); view.horizontalScrollBar()->maximum() > 0; view.resize(width, 600)) {
    ++width;
  }
  const int height = 17 * view.line_height();
  for (const QSize before : {QSize(0, 0), QSize(300, 0), QSize(0, 300), QSize(300, 300)}) {
    for (int wider = -4; wider <= 20; ++wider) {
      for (int higher = -4; higher <= 30; ++higher) {
        view.resize(QSize(width - 50, height - 50) + before);
        view.resize(width + wider, height + higher);
        QCoreApplication::processEvents();
      }
    }
  }
  EXPECT_FALSE(view.horizontalScrollBar()->isVisible());
  EXPECT_FALSE(view.verticalScrollBar()->isVisible());
}

TEST_F(ProgramViewTest, CtrlWheelZoomsTheFontWithinBounds) {
  show_text(many_lines(10));
  const auto wheel = [&](int steps) {
    QWheelEvent event(QPointF(50, 50), view.viewport()->mapToGlobal(QPointF(50, 50)), {}, {0, 120 * steps},
                      Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view.viewport(), &event);
  };
  const int height = view.line_height();
  wheel(3);
  EXPECT_EQ(view.font_size(), ProgramView::default_font_size + 3);
  EXPECT_GT(view.line_height(), height);
  wheel(1000);
  EXPECT_EQ(view.font_size(), ProgramView::largest_font_size);
  wheel(-1000);
  EXPECT_EQ(view.font_size(), ProgramView::min_font_size);
}

/// Pixels of a colour, give or take what anti-aliasing makes of it.
int count_pixels(const QImage& image, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor here = image.pixelColor(x, y);
      count += std::abs(here.red() - colour.red()) + std::abs(here.green() - colour.green()) +
                           std::abs(here.blue() - colour.blue()) <
                       60
                   ? 1
                   : 0;
    }
  }
  return count;
}

TEST_F(ProgramViewTest, UnderlinesAndExplainsDiagnostics) {
  show_text("G1 X5 F100\nG1 X1..2 Y5\nM2\n");
  ASSERT_FALSE(view.marks().of(2).empty());
  const QColor error = theme_colours(view.palette()).error;
  const auto row = [&](std::uint32_t line) {
    return view.viewport()
        ->grab(QRect(0, view.top_of(line), view.viewport()->width(), view.line_height()))
        .toImage();
  };
  EXPECT_EQ(count_pixels(row(1), error), 0);
  EXPECT_GT(count_pixels(row(2), error), 5);
  QHelpEvent help(QEvent::ToolTip, point_of({2, 4}), view.viewport()->mapToGlobal(point_of({2, 4})));
  QCoreApplication::sendEvent(view.viewport(), &help);
  EXPECT_THAT(QToolTip::text().toStdString(), HasSubstr("X1..2"));
}

TEST_F(ProgramViewTest, DrawsTabsUmlautsAndEveryDialect) {
  for (const DialectInfo& dialect : all_dialects()) {
    show_text("\tG1 X5 ; \u00fc\u4e2d\n10 L X+5\n\n/N10 R1=5 \"A\"\n#1=2 (\n", dialect.dialect);
    view.select_all();
    EXPECT_FALSE(view.grab().isNull());
  }
}

TEST_F(ProgramViewTest, FollowsTheTheme) {
  show_text(many_lines(5));
  const QImage light = view.grab().toImage();
  apply_theme(ThemeKind::dark);
  QCoreApplication::processEvents();
  const QImage dark = view.grab().toImage();
  apply_theme(ThemeKind::light);
  const QPoint corner(light.width() / 2, light.height() - 5);
  EXPECT_GT(light.pixelColor(corner).lightness(), 200);
  EXPECT_LT(dark.pixelColor(corner).lightness(), 60);
}

TEST_F(ProgramViewTest, WithoutAProgramTakesKeysAndClicks) {
  view.set_program(nullptr);
  press(Qt::Key_Down);
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_C, Qt::ControlModifier);
  QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, QPoint(20, 20));
  view.show_line(3);
  view.go_to({5, 5});
  EXPECT_TRUE(chosen.isEmpty());
  EXPECT_FALSE(view.grab().isNull());
}

TEST_F(ProgramViewTest, AMillionLinesAreGoneThrough) {
  show_text(many_lines(1'000'000));
  press(Qt::Key_End, Qt::ControlModifier);
  EXPECT_EQ(view.last_visible_line(), 1'000'000U);
  view.show_line(500'000);
  EXPECT_LE(view.first_visible_line(), 500'000U);
  EXPECT_GE(view.last_visible_line(), 500'000U);
  EXPECT_FALSE(view.grab().isNull());
}

TEST_F(ProgramViewTest, ALineOfTenMegabytesIsShown) {
  show_text("G1 X1\n(" + std::string(9'900'000, 'A') + ")\nM2\n");
  EXPECT_FALSE(view.grab().isNull());
  click({2, 5});
  press(Qt::Key_End);
  EXPECT_EQ(view.caret(), (TextPlace{2, 9'900'002}));
  EXPECT_FALSE(view.grab().isNull());
}

}  // namespace
}  // namespace feedscope::ui
