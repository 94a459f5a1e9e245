#include "ui/identification/residual_plot.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "tests/ui/identification_fixture.h"

namespace feedscope::ui {
namespace {

const QRectF area(0, 0, 400, 200);

ResidualPlot plot_of(const ResidualCurves& curves) {
  return {curves, area, QFont(), theme_colours(QPalette(Qt::white))};
}

/// Four cells of 1 s, in each of which the model is a quarter of 2 ms slower.
TEST(ResidualCurvesTest, ATraceIsFollowedByHowFarTheModelIsBehind) {
  const std::vector<ResidualCurves> curves = residual_curves(*test::some_outcome(), 0);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].recording, "scope.csv");
  EXPECT_FALSE(curves[0].of_sections);
  ASSERT_EQ(curves[0].models.size(), 2U);
  const std::vector<QPointF>& points = curves[0].models[0].points;
  ASSERT_EQ(points.size(), 5U);
  EXPECT_EQ(points[0], QPointF(0, 0));
  EXPECT_NEAR(points[2].x(), 2, 1e-12);
  EXPECT_NEAR(points[2].y(), 0.001, 1e-12);
  EXPECT_NEAR(points[4].y(), 0.002, 1e-12);
}

TEST(ResidualCurvesTest, ATableHasTheDifferenceOfEachSection) {
  const std::vector<ResidualCurves> curves = residual_curves(*test::some_outcome(), 0);
  EXPECT_TRUE(curves[1].of_sections);
  const std::vector<QPointF>& points = curves[1].models[0].points;
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0], QPointF(1, 0));
  EXPECT_EQ(points[3].x(), 4);
  EXPECT_NEAR(points[3].y(), 0.006, 1e-12);
}

TEST(ResidualCurvesTest, TheChosenModelIsFirstAndKeepsItsColour) {
  const auto best = residual_curves(*test::some_outcome(), 0)[0].models;
  const auto other = residual_curves(*test::some_outcome(), 1)[0].models;
  EXPECT_EQ(other[0].name, best[1].name);
  EXPECT_EQ(other[0].colour, best[1].colour);
  EXPECT_NE(other[0].colour, other[1].colour);
}

/// The other one is 25 times farther off and would make a level line of the chosen one.
TEST(ResidualPlotTest, ItsScaleIsThatOfTheChosenModel) {
  const ResidualCurves curves = residual_curves(*test::some_outcome(), 0)[0];
  const ResidualPlot plot = plot_of(curves);
  EXPECT_GE(plot.highest(), 0.002);
  EXPECT_LT(plot.highest(), 0.004);
  EXPECT_LT(plot.lowest(), -0.004);
  EXPECT_GT(plot.lowest(), -0.012);
  const ResidualPlot other = plot_of(residual_curves(*test::some_outcome(), 1)[0]);
  EXPECT_LT(other.lowest(), -0.05);
}

TEST(ResidualPlotTest, DrawsACurveFromLeftToRight) {
  ResidualCurves curves = residual_curves(*test::some_outcome(), 0)[0];
  curves.models.resize(1);
  curves.models[0].colour = Qt::red;
  QImage image(area.size().toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  const ResidualPlot plot = plot_of(curves);
  plot.draw(painter);
  painter.end();
  std::vector<int> height;  // of the curve in the first and in the last columns of the plot
  for (const double x : {plot.plot().left() + 3, plot.plot().right() - 3}) {
    for (int y = static_cast<int>(plot.plot().top()); y < plot.plot().bottom(); ++y) {
      const QColor pixel = image.pixelColor(static_cast<int>(x), y);
      if (pixel.red() > 200 && pixel.green() < 120 && pixel.blue() < 120) {
        height.push_back(y);
        break;
      }
    }
  }
  ASSERT_EQ(height.size(), 2U);
  EXPECT_LT(height[1], height[0] - 20) << "it falls behind";
}

/// As a file may hold them that someone has written.
TEST(ResidualPlotTest, TakesWhateverNumbers) {
  for (const double wild : {1e300, -1e300, 1e308, 0.0}) {
    const auto outcome = test::some_outcome();
    for (Identification& found : outcome->models) {
      found.agreements[0].cells[1].simulated_time = wild;
      found.agreements[0].cells[2].measured_time = wild;
      found.sections[1][2].simulated_time = wild;
    }
    for (const ResidualCurves& curves : residual_curves(*outcome, 0)) {
      QImage image(area.size().toSize(), QImage::Format_RGB32);
      QPainter painter(&image);
      const ResidualPlot plot = plot_of(curves);
      plot.draw(painter);
      EXPECT_LT(plot.lowest(), plot.highest());
      EXPECT_LE(plot.highest() - plot.lowest(), 1e10);
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
