#include "ui/circular/polar_plot.h"

#include <gmock/gmock.h>

#include <QImage>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// A circle of 10 mm whose places lie `deviation` outside of it.
CircularTest round_test(double deviation) {
  CircularTest test;
  test.request.radius = 10;
  test.request.feed = 50;
  test.request.sweep = full_turn;
  test.actual = true;
  for (std::size_t i = 0; i < 2; ++i) {
    CirclePass& pass = test.passes.emplace_back();
    pass.counter_clockwise = i == 0;
    for (int k = 0; k <= 720; ++k) {
      const double a = full_turn * k / 720;
      pass.places.push_back((10 + deviation) * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
    pass.circularity = circularity_of(pass.places, 10);
  }
  test.both = test.passes[0].circularity;
  return test;
}

/// Distance from the middle of the plot to the colour of counter-clockwise paths, to the right [pixels].
int radius_drawn(PolarPlot& plot) {
  plot.resize(700, 760);
  QImage image(plot.size(), QImage::Format_RGB32);
  QPainter painter(&image);
  plot.draw(painter, QRectF(image.rect()));
  painter.end();
  const QColor path = theme_colours(plot.palette()).path;
  // The row of the centre is where the spokes are; a little above is no arrow and no dot.
  int best = -1;
  for (int y = image.height() / 3; y < image.height() * 2 / 3; ++y) {
    for (int x = image.width() - 1; x > image.width() / 2; --x) {
      const QColor colour = image.pixelColor(x, y);
      const int off = std::abs(colour.red() - path.red()) + std::abs(colour.green() - path.green()) +
                      std::abs(colour.blue() - path.blue());
      if (off < 30) {
        best = std::max(best, x - image.width() / 2);
        break;
      }
    }
  }
  return best;
}

TEST(PolarPlot, DivisionIsRoundAndHoldsTheLargestDeviation) {
  PolarPlot plot;
  plot.set_tests("test", "", {round_test(0.033)});
  EXPECT_DOUBLE_EQ(plot.division(), 0.01);
  plot.set_tests("test", "", {round_test(0.033), round_test(-0.1)});
  EXPECT_DOUBLE_EQ(plot.division(), 0.05);
  plot.set_tests("test", "", {round_test(0)});
  EXPECT_GT(plot.division(), 0);
}

TEST(PolarPlot, DeviationIsDrawnInDivisionsOfTheGrid) {
  // With one scale for all: a second test of 0.04 mm sets a division of 0.01 mm.
  PolarPlot outside;
  outside.set_tests("test", "", {round_test(0.04)});
  PolarPlot half;
  half.set_tests("test", "", {round_test(0.0399)});
  const int far = radius_drawn(outside);
  const int near = radius_drawn(half);
  ASSERT_GT(far, 0);
  EXPECT_NEAR(far, near, 2);  // 0.01 of a division
  PolarPlot inside;
  inside.set_tests("test", "", {round_test(-0.04)});
  // Eight divisions of a tenth of the plot's radius, the nominal circle at six tenths: 0.2 and 1.
  EXPECT_NEAR(static_cast<double>(radius_drawn(inside)) / far, 0.2, 0.03);
}

TEST(PolarPlot, LegendTakesASecondLineWhereTheFirstIsFull) {
  PolarPlot plot;
  plot.set_tests("test", "", {round_test(0.01)});
  plot.resize(plot.minimumSizeHint());
  QImage image(plot.size(), QImage::Format_RGB32);
  QPainter painter(&image);
  plot.draw(painter, QRectF(image.rect()));
  painter.end();
  const QColor plain = theme_colours(plot.palette()).plot;
  for (int y = 0; y < image.height(); ++y) {  // nothing is cut by the right edge
    for (int x = image.width() - 4; x < image.width(); ++x) {
      ASSERT_EQ(image.pixelColor(x, y), plain) << x << ", " << y;
    }
  }
}

TEST(PolarPlot, ValuesAreThoseOfTheTestWithTheirUnit) {
  const QStringList values = circular_values(round_test(0.0421));
  ASSERT_EQ(values.size(), 3);
  EXPECT_THAT(values[0].toStdString(), testing::HasSubstr("F_max 42.1 µm"));
  EXPECT_THAT(values[2].toStdString(), testing::HasSubstr("D 42.1 µm"));
  EXPECT_THAT(circular_values(round_test(-1e-12))[0].toStdString(), testing::Not(testing::HasSubstr("-0")));
}

}  // namespace
}  // namespace feedscope::ui
