#include "ui/decide/decision_chart.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <functional>
#include <random>

namespace feedscope::ui {
namespace {

class DecisionChartTest : public ::testing::Test {
 protected:
  DecisionChartTest() {
    chart.resize(280, 140);
    chart.set({{0, 118.1, 0.008, "0.01 mm", Qt::blue, false, false},
               {1, 108.5, 0.0113, "0.02 mm", Qt::red, true, true},
               {2, 108.4, 0.0283, "0.05 mm", Qt::darkGreen, false, false}},
              0.02);
    chart.show();
  }
  QPoint point(double x, double y) const { return QPointF(x, y).toPoint(); }

  DecisionChart chart;
};

TEST_F(DecisionChartTest, ErrorsRunToTheRightAndTimesUpwards) {
  const std::vector<DecisionDot>& dots = chart.dots();
  EXPECT_LT(chart.place_of(dots[0]).x(), chart.place_of(dots[1]).x());
  EXPECT_LT(chart.place_of(dots[0]).y(), chart.place_of(dots[1]).y()) << "slower is higher";
  ASSERT_TRUE(chart.bound_x());
  EXPECT_GT(*chart.bound_x(), chart.place_of(dots[1]).x());
  EXPECT_LT(*chart.bound_x(), chart.place_of(dots[2]).x());
}

TEST_F(DecisionChartTest, AClickOnADotAsksForItsRun) {
  QSignalSpy clicked(&chart, &DecisionChart::run_clicked);
  const QPointF at = chart.place_of(chart.dots()[2]);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, at.toPoint());
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].value<std::size_t>(), 2U);
}

TEST_F(DecisionChartTest, TheBoundIsDrawnAlongTheAxis) {
  QSignalSpy dragged(&chart, &DecisionChart::bound_dragged);
  const double middle = (chart.place_of(chart.dots()[0]).y() + chart.place_of(chart.dots()[1]).y()) / 2;
  const double to = chart.place_of(chart.dots()[2]).x();
  QTest::mousePress(&chart, Qt::LeftButton, {}, point(*chart.bound_x(), middle));
  QTest::mouseMove(&chart, point(to, middle));
  QTest::mouseRelease(&chart, Qt::LeftButton, {}, point(to, middle));
  ASSERT_GE(dragged.count(), 1);
  EXPECT_NEAR(dragged.last()[0].toDouble(), 0.0283, 0.0005);
}

std::vector<DecisionDot> four_dots(const std::function<QPointF()>& error_and_time, const QString& name) {
  std::vector<DecisionDot> dots;
  for (std::size_t row = 0; row < 4; ++row) {
    const QPointF at = error_and_time();
    dots.push_back({row, at.y(), at.x(), name, Qt::blue, row == 0, row == 0});
  }
  return dots;
}

TEST(DecisionChartLabels, LieWithinTheChartAndNotOnEachOtherOrTheBound) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> error(0.002, 0.1);
  std::uniform_real_distribution<double> time(50, 500);
  for (const QSize& size : {QSize(240, 136), QSize(280, 140), QSize(540, 200)}) {
    for (int round = 0; round < 50; ++round) {
      DecisionChart chart;
      chart.resize(size);
      chart.set(four_dots([&] { return QPointF(error(random), time(random)); }, "0.05 mm"), 0.02);
      const std::vector<DecisionLabel> labels = chart.labels();
      EXPECT_TRUE(QRectF(chart.rect()).contains(chart.bound_label())) << round;
      for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_TRUE(QRectF(chart.rect()).contains(labels[i].place)) << round << ' ' << i;
        EXPECT_FALSE(labels[i].place.intersects(chart.bound_label())) << size.width() << ' ' << round;
        for (std::size_t k = 0; k < i; ++k) {
          EXPECT_FALSE(labels[i].place.intersects(labels[k].place))
              << size.width() << ' ' << round << ' ' << i << ' ' << k;
        }
      }
    }
  }
}

/// Also where errors hardly differ and dots touch each other.
TEST(DecisionChartLabels, AreNearestToTheirOwnDots) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> error(0.001, 0.008);
  std::uniform_real_distribution<double> time(140, 160);
  int displaced = 0;
  for (int round = 0; round < 100; ++round) {
    DecisionChart chart;
    chart.resize(326, 176);
    std::vector<DecisionDot> dots = four_dots([&] { return QPointF(error(random), time(random)); }, "B");
    dots.push_back({4, 110, 0.094, "E", Qt::red, false, false});
    chart.set(dots, std::nullopt);
    for (const DecisionLabel& label : chart.labels()) {
      displaced += label.displaced ? 1 : 0;
      const auto distance = [&](std::size_t dot) {
        return QLineF(chart.place_of(dots[dot]), label.place.center()).length();
      };
      for (std::size_t other = 0; other < dots.size() && !label.displaced; ++other) {
        EXPECT_TRUE(std::ranges::count(label.dots, other) > 0 ||
                    distance(label.dots.front()) < distance(other))
            << round << ' ' << label.text.toStdString() << other;
      }
    }
  }
  EXPECT_LT(displaced, 200) << "of 500, four of each five in a heap of 17 x 50 pixels";
}

TEST(DecisionChartLabels, NameDotsInOnePlaceTogether) {
  DecisionChart chart;
  chart.resize(326, 176);
  chart.set({{0, 120, 0.008, "A", Qt::blue, true, true},
             {1, 110, 0.02, "B", Qt::red, false, false},
             {2, 120, 0.008, "C", Qt::green, false, false}},
            std::nullopt);
  const std::vector<DecisionLabel> labels = chart.labels();
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].text.toStdString(), "A, C");
  EXPECT_EQ(labels[1].text.toStdString(), "B");
}

}  // namespace
}  // namespace feedscope::ui
