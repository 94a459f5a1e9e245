#include "ui/contour/contour_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLocale>
#include <QPainter>
#include <QTest>
#include <algorithm>
#include <numeric>

#include "core/analysis/contour/contour_report.h"
#include "tests/ui/run_fixture.h"
#include "ui/contour/contour_chart.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

ContourCurve curve_of(const std::string& model, double tolerance) {
  SetupRequest request;
  request.model = model;
  request.tolerance = tolerance;
  const feedscope::Run run = simulate_run(
      load_program(std::make_shared<const SourceText>("test.nc", test::small_program)), make_setup(request));
  const ContourReport report = contour_report(run, 1);
  return {QString::fromStdString(model), QColor(0x00, 0x72, 0xb2), report.largest, report.spread};
}

class ContourPlotTest : public testing::Test {
 protected:
  ContourPlotTest() { QLocale::setDefault(QLocale::c()); }

  ContourCurves curves{{curve_of("essid", 0.05), curve_of("ward", 0.02)}, true, std::array{0.05, 0.05}};
  QFont font;
  const QPalette palette;
  const ThemeColours& colours = theme_colours(palette);
};

TEST_F(ContourPlotTest, AllRunsShareTheEdgesAndKeepTheirLength) {
  const ContourPlot plot(curves, QRectF(0, 0, 500, 300), font, colours);
  EXPECT_EQ(plot.histogram(0).edges, plot.histogram(1).edges);
  EXPECT_GE(plot.histogram(0).edges.back(), curves.largest());
}

TEST_F(ContourPlotTest, SidesAreAsFineAsTheirOwnExtentAsks) {
  ContourSpread mostly_across;
  mostly_across.step = 1e-4;
  mostly_across.amount.assign(601, 0.01);
  mostly_across.left.assign(601, 0);
  std::fill_n(mostly_across.left.begin(), 120, 1);  // 12 um
  mostly_across.right.assign(601, 0);
  ContourCurves sided{{{"run", Qt::blue, 0.06, mostly_across}}, true, std::nullopt};
  EXPECT_DOUBLE_EQ(sided.extent(), 0.02);
  const ContourHistogram histogram = sided.histogram(0);
  EXPECT_NEAR(histogram.edges[1] - histogram.edges[0], 0.001, 1e-12);
  EXPECT_NEAR(std::accumulate(histogram.length.begin(), histogram.length.end(), 0.0), 120, 1e-9);
  sided.sides = false;
  EXPECT_DOUBLE_EQ(sided.extent(), 0.06);
}

/// Bins may be wider than what is left of them: what keeps its tolerance is drawn within its lines.
TEST_F(ContourPlotTest, NothingIsDrawnBeyondTheLargestErrorOfARun) {
  for (const bool sides : {false, true}) {
    ContourCurves kept{{curve_of("essid", 0.05)}, sides, std::nullopt};
    const double largest = kept.runs[0].largest;
    kept.tolerance = std::array{largest, largest};
    kept.runs[0].colour = Qt::red;
    kept.runs.push_back(kept.runs[0]);
    kept.runs[1].colour = Qt::blue;
    const ContourPlot plot(kept, QRectF(0, 0, 900, 300), font, colours);
    QImage image(900, 300, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    plot.draw(painter);
    painter.end();
    const QRectF area = plot.plot();
    const double edge = plot.histogram(0).edges.back();
    const double zero = sides ? area.center().x() : area.left();
    int inside = 0;
    for (int x = static_cast<int>(area.left()) + 1; x < area.right(); ++x) {
      for (int y = static_cast<int>(area.top()) + 1; y < area.bottom() - 2; ++y) {
        const QColor colour = image.pixelColor(x, y);
        const bool is_run = colour.red() > colour.green() + 60 || colour.blue() > colour.green() + 60;
        const double error = std::abs(x - zero) / (area.right() - zero) * edge;
        EXPECT_TRUE(!is_run || error <= largest + 3 * edge / (area.right() - zero)) << x << ", " << y;
        inside += is_run ? 1 : 0;
      }
    }
    EXPECT_GT(inside, 1000);
  }
}

TEST_F(ContourPlotTest, StaysInsideItsAreaDownToANarrowDock) {
  for (const QSizeF size : {QSizeF(300, 180), QSizeF(600, 260), QSizeF(3840, 1200)}) {
    const QRectF area(QPointF(), size);
    const ContourPlot plot(curves, area, font, colours);
    EXPECT_TRUE(area.contains(plot.plot())) << size.width();
    EXPECT_GT(plot.plot().width(), 0.6 * size.width());
    EXPECT_GT(plot.plot().height(), 0.25 * size.height());
    QImage image((size + QSizeF(40, 40)).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    plot.draw(painter);
    painter.end();
    for (int x = 0; x < image.width(); ++x) {
      for (int y = 0; y < image.height(); ++y) {
        if (!area.toRect().contains(x, y)) {
          ASSERT_EQ(image.pixel(x, y), qRgb(255, 255, 255)) << x << ", " << y << " of " << size.width();
        }
      }
    }
  }
}

TEST_F(ContourPlotTest, LeftOfThePathIsOnTheLeft) {
  const ContourPlot plot(curves, QRectF(0, 0, 500, 300), font, colours);
  const double middle = plot.plot().center().y();
  const auto bin = plot.bin_at({plot.plot().center().x() - 40, middle});
  ASSERT_TRUE(bin);
  EXPECT_GT(plot.histogram(0).edges[*bin], 0) << "positive is left";
  EXPECT_FALSE(plot.bin_at({2, middle}));
}

TEST_F(ContourPlotTest, TheTipSaysWhatABarIs) {
  ContourChart chart;
  chart.resize(500, 300);
  EXPECT_TRUE(chart.tip_at({250, 150}).isEmpty());
  chart.set_curves(curves);
  const ContourPlot plot(chart.curves(), chart.rect(), chart.font(), colours);
  const QPointF middle = plot.plot().center();
  EXPECT_THAT(chart.tip_at(middle).toStdString(), HasSubstr("left or right of the programmed path"));
  const std::string left = chart.tip_at({plot.plot().left() + 60, middle.y()}).toStdString();
  EXPECT_THAT(left, testing::AllOf(HasSubstr("µm left of"), HasSubstr("essid: "), HasSubstr("ward: ")));
  curves.sides = false;
  chart.set_curves(curves);
  EXPECT_THAT(chart.tip_at(middle).toStdString(), HasSubstr("µm from the programmed path"));
}

TEST_F(ContourPlotTest, OfAnExactRunIsDrawnToo) {
  ContourCurves exact{{curve_of("cam", 0)}, true, std::nullopt};
  QImage image(400, 300, QImage::Format_RGB32);
  QPainter painter(&image);
  const ContourPlot plot(exact, QRectF(0, 0, 400, 300), font, colours);
  plot.draw(painter);
  EXPECT_GT(plot.histogram(0).edges.back(), 0);
}

}  // namespace
}  // namespace feedscope::ui
