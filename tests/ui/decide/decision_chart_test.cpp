#include "ui/decide/decision_chart.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
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

TEST(DecisionChartLabels, LieWithinTheChartAndNotOnEachOther) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> error(0.002, 0.1);
  std::uniform_real_distribution<double> time(50, 500);
  for (const QSize& size : {QSize(240, 136), QSize(280, 140), QSize(540, 200)}) {
    for (int round = 0; round < 50; ++round) {
      DecisionChart chart;
      chart.resize(size);
      std::vector<DecisionDot> dots;
      for (std::size_t row = 0; row < 4; ++row) {
        dots.push_back({row, time(random), error(random), "0.05 mm", Qt::blue, row == 0, row == 0});
      }
      chart.set(dots, 0.02);
      const std::vector<QRectF> labels = chart.labels();
      for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_TRUE(QRectF(chart.rect()).contains(labels[i])) << round << ' ' << i;
        for (std::size_t k = 0; k < i; ++k) {
          EXPECT_FALSE(labels[i].intersects(labels[k]))
              << size.width() << ' ' << round << ' ' << i << ' ' << k;
        }
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
