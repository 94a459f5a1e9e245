#include "ui/charts/chart_header.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>

namespace feedscope::ui {
namespace {

class ChartHeaderTest : public testing::Test {
 protected:
  void give_width(int width) { header.resize(width, header.heightForWidth(width)); }
  /// Of those that every run has; the machine's axes of five-axis runs stand behind them.
  std::size_t count() const {
    return static_cast<std::size_t>(std::ranges::count_if(spec.curves, [](const CurveSpec& curve) {
      return info_of(curve.quantity).source == QuantitySource::motion;
    }));
  }

  const ChartSpec spec = kinematic_chart_specs()[0];
  ChartHeader header{spec};
};

TEST_F(ChartHeaderTest, EveryCurveStandsWithinItWhateverItsWidth) {
  int before = 0;
  for (int width = 1200; width >= header.minimumSizeHint().width(); width -= 20) {
    give_width(width);
    EXPECT_GE(header.height(), before) << "narrower is not lower";
    before = header.height();
    for (std::size_t i = 0; i < count(); ++i) {
      EXPECT_TRUE(header.rect().contains(header.item(i))) << width << ' ' << i;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(header.item(i).intersects(header.item(k))) << width << ' ' << i << ' ' << k;
      }
    }
  }
}

TEST_F(ChartHeaderTest, WideEnoughItIsOneLine) {
  give_width(1200);
  for (std::size_t i = 0; i < count(); ++i) {
    EXPECT_EQ(header.item(i).top(), 0);
  }
  give_width(400);
  EXPECT_GT(header.item(count() - 1).top(), header.item(0).top());
}

TEST_F(ChartHeaderTest, ACurveOfALaterLineCanBeClicked) {
  give_width(400);
  QSignalSpy clicked(&header, &ChartHeader::curve_clicked);
  QTest::mouseClick(&header, Qt::LeftButton, {}, header.item(count() - 1).center());
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].value<std::size_t>(), count() - 1);
}

TEST_F(ChartHeaderTest, CurvesOfTheMachineAreListedWhereARunHasThem) {
  give_width(1200);
  ASSERT_EQ(spec.curves.size(), count() + 3);
  EXPECT_TRUE(header.item(count()).isEmpty());
  header.set_available(std::vector<bool>(spec.curves.size(), true));
  give_width(1200);
  for (std::size_t i = 0; i < spec.curves.size(); ++i) {
    EXPECT_FALSE(header.item(i).isEmpty()) << i;
  }
}

TEST_F(ChartHeaderTest, OtherRunsTakeTwoLinesAtMostAndTheTipNamesAll) {
  give_width(600);
  const int alone = header.height();
  std::vector<LegendEntry> runs;
  for (int i = 0; i < 20; ++i) {
    runs.push_back({QStringLiteral("run %1").arg(i), Qt::red, false, 1.0});
  }
  header.set_runs({runs[0], runs[1]});
  give_width(600);
  const int line = header.height() - alone;
  EXPECT_GT(line, 0);
  header.set_runs(runs);
  give_width(600);
  EXPECT_EQ(header.height(), alone + 2 * line);
  EXPECT_EQ(header.tip_at({70, alone + 2}), "run 0");
  EXPECT_TRUE(header.tip_at({2, alone + 2}).endsWith("run 19"));
}

TEST_F(ChartHeaderTest, OneOtherRunStandsBehindTheCurvesWhereThereIsRoom) {
  const LegendEntry run{QStringLiteral("slower"), Qt::red, false, 1.0};
  for (int width = 1400; width >= header.minimumSizeHint().width(); width -= 50) {
    header.set_runs({});
    header.set_notes({}, {});
    give_width(width);
    const int alone = header.height();
    const QRect last = header.item(count() - 1);
    header.set_runs({run});
    give_width(width);
    if (header.height() == alone) {
      EXPECT_EQ(header.tip_at({last.right() + 30, last.center().y()}), "slower") << width;
    } else {
      EXPECT_EQ(header.tip_at({70, alone + 2}), "slower") << width;
    }
  }
  give_width(1400);
  EXPECT_EQ(header.height(), header.heightForWidth(4000)) << "one line";
}

/// As ALineThatNotesNeededStays.
TEST_F(ChartHeaderTest, ARunThatANotePushedDownStaysThere) {
  header.set_runs({{QStringLiteral("slower"), Qt::red, false, 1.0}});
  give_width(1000);
  header.set_notes({}, QStringList(3, "bands: 5 to 95 % of the time, pale: extremes"));
  const int with_notes = header.heightForWidth(1000);
  header.set_notes({}, {});
  EXPECT_EQ(header.heightForWidth(1000), with_notes);
}

TEST_F(ChartHeaderTest, NotesStandBehindTheCurvesAndInALineOfTheirOwnWhereThereIsNoRoom) {
  const std::vector<LimitLine> limits{{5, "limit of X Y", {}}, {7, "limit of Z", 2}};
  const QStringList notes{"bands: 5 to 95 % of the time, pale: extremes"};
  for (int width = 1400; width >= header.minimumSizeHint().width(); width -= 50) {
    header.set_notes({}, {});
    give_width(width);
    header.set_notes(limits, notes);
    give_width(width);
    const std::vector<QRect> places = header.note_places();
    ASSERT_EQ(places.size(), 3U);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_TRUE(header.rect().contains(places[i])) << width << ' ' << i;
      for (std::size_t k = 0; k < count(); ++k) {
        EXPECT_FALSE(places[i].intersects(header.item(k))) << width << ' ' << i << ' ' << k;
      }
    }
    EXPECT_EQ(header.tip_at(places[1].center()), "limit of Z");
    EXPECT_EQ(header.tip_at(places[2].center()), notes[0]);
  }
}

/// A note that comes and goes with the height of the plot would else make the plot jump without end.
TEST_F(ChartHeaderTest, ALineThatNotesNeededStays) {
  give_width(600);
  const int before = header.height();
  header.set_notes({}, QStringList(5, "bands: 5 to 95 % of the time, pale: extremes"));
  const int with_note = header.heightForWidth(600);
  EXPECT_GT(with_note, before);
  header.set_notes({}, {});
  EXPECT_EQ(header.heightForWidth(600), with_note);
  EXPECT_LT(header.heightForWidth(1400), with_note);
}

}  // namespace
}  // namespace feedscope::ui
