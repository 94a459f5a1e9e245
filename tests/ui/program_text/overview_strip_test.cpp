#include "ui/program_text/overview_strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QHelpEvent>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "tests/ui/run_fixture.h"
#include "ui/program_text/line_time_text.h"
#include "ui/program_text/program_margin.h"
#include "ui/program_text/program_view.h"
#include "ui/theme/program_colours.h"

namespace feedscope::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Short moves, one long one in line `slow`.
std::string program_with_slow_line(int lines, int slow) {
  std::string text = "G1 F1000\n";
  for (int i = 2; i <= lines; ++i) {
    text += i == slow ? "G91 X500\n" : "G91 X0.1\n";
  }
  return text;
}

class OverviewStripTest : public testing::Test {
 protected:
  OverviewStripTest() {
    view.resize(300, 400);
    view.show();
  }

  void show_text(const std::string& text) {
    const feedscope::Run run = test::simulate_text(text, "cam");
    view.set_program(run.input.program);
    view.set_times(std::make_shared<const LineTimes>(*run.trajectory));
  }

  QString tip_of(QWidget& widget, const QPoint& point) {
    QHelpEvent help(QEvent::ToolTip, point, widget.mapToGlobal(point));
    QCoreApplication::sendEvent(&widget, &help);
    return QToolTip::text();
  }

  ProgramView view;
  OverviewStrip& strip = *view.findChild<OverviewStrip*>();
  ProgramMargin& margin = *view.findChild<ProgramMargin*>();
};

TEST_F(OverviewStripTest, RowsCoverEveryLineOnce) {
  for (const int lines : {1, 3, 24, 25, 399, 400, 401, 5000}) {
    show_text(program_with_slow_line(lines, 2));
    std::uint32_t next = 1;
    for (int y = 0; y < strip.height(); ++y) {
      const OverviewStrip::Lines row = strip.lines_of(y);
      if (row.first == 0) {
        break;  // a short program ends above
      }
      ASSERT_LE(row.first, next) << lines;
      ASSERT_GE(row.last, row.first);
      next = std::max(next, row.last + 1);
    }
    EXPECT_EQ(next, static_cast<std::uint32_t>(lines) + 1) << lines;
  }
}

TEST_F(OverviewStripTest, ShowsWhereTheTimeGoes) {
  show_text(program_with_slow_line(1000, 700));
  const QImage image = strip.grab().toImage();
  const QColor slow = program_colours(view.palette()).slow;
  const int row = 699 * strip.height() / 1000;
  EXPECT_EQ(image.pixelColor(strip.width() - 2, row), slow);
  EXPECT_NE(image.pixelColor(strip.width() - 2, row - 30), slow);
}

TEST_F(OverviewStripTest, APressGoesToTheLine) {
  show_text(program_with_slow_line(1000, 700));
  QSignalSpy chosen(&view, &ProgramView::line_chosen);
  QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(5, strip.height() / 2));
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_NEAR(chosen[0][0].toUInt(), 500, 3);
  EXPECT_LE(view.first_visible_line(), 500U);
  EXPECT_GE(view.last_visible_line(), 500U);
}

TEST_F(OverviewStripTest, TipsTellTimeShareAndFeed) {
  show_text(program_with_slow_line(20, 7));
  const QPoint at_slow(2, view.top_of(7) + 3);
  EXPECT_THAT(tip_of(margin, at_slow).toStdString(),
              AllOf(HasSubstr("Line 7"), HasSubstr("30.0\u00a0s"), HasSubstr("% of the cycle time"),
                    HasSubstr("1000 mm/min")));
  EXPECT_THAT(tip_of(margin, {2, view.top_of(1) + 3}).toStdString(), HasSubstr("takes no time"));
  EXPECT_THAT(tip_of(strip, {2, view.top_of(7) + 3}).toStdString(), HasSubstr("30.0\u00a0s"));
}

TEST_F(OverviewStripTest, TheMarginShowsTheSlowLineHot) {
  show_text(program_with_slow_line(20, 7));
  const QImage image = margin.grab().toImage();
  const QColor slow = program_colours(view.palette()).slow;
  EXPECT_EQ(image.pixelColor(margin.width() - 2, view.top_of(7) + 4), slow);
  EXPECT_NE(image.pixelColor(margin.width() - 2, view.top_of(8) + 4), slow);
  QSignalSpy chosen(&view, &ProgramView::line_chosen);
  QTest::mouseClick(&margin, Qt::LeftButton, {}, QPoint(5, view.top_of(8) + 4));
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].toUInt(), 8U);
}

TEST(LineTimeText, SaysHowOftenALineRan) {
  const feedscope::Run run =
      test::simulate_text("G91 G1 F600\n#1=0\nWHILE [#1 LT 5] DO1\nX1\nY1\n#1=#1+1\nEND1\n", "cam");
  const LineTimes times(*run.trajectory);
  EXPECT_THAT(
      line_time_text(times, 4, 4).toStdString(),
      AllOf(HasSubstr("executed 5 times"), HasSubstr("0.500\u00a0s, 50.00 %"), HasSubstr("600 mm/min")));
  EXPECT_EQ(line_time_text(times, 1, 3), "");
  EXPECT_THAT(line_time_text(times, 4, 5).toStdString(), HasSubstr("Lines 4 to 5"));
}

TEST(LineTimeText, HeatGrowsWithTheTime) {
  EXPECT_EQ(heat_of(0, 1), 0);
  EXPECT_EQ(heat_of(0, 0), 0);
  EXPECT_EQ(heat_of(2, 2), 1);
  EXPECT_DOUBLE_EQ(heat_of(1, 8), 0.5);
}

}  // namespace
}  // namespace feedscope::ui
