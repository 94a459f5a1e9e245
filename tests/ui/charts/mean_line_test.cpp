#include "ui/charts/mean_line.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

using feedscope::test::simulate_text;

TEST(MeanLine, MeansTimesTheirTimesAddUpToThePath) {
  const auto run = simulate_text("G21 G90 F3000\nG1 X50\nY50\nG4 P500\nX0\n");
  const double duration = run.trajectory->duration();
  std::vector<double> times;
  for (int i = 0; i <= 40; ++i) {
    times.push_back(duration * i / 40);
  }
  const std::vector<float> means = mean_feeds(*run.trajectory, RapidTimes().outside(times), times.size() - 1);
  ASSERT_EQ(means.size(), 40U);
  const double sum = std::accumulate(means.begin(), means.end(), 0.0);
  EXPECT_NEAR(sum * duration / 40, run.trajectory->state(duration).path_length, 1e-3);
  EXPECT_TRUE(mean_feeds(*run.trajectory, {}, 0).empty());
}

TEST(MeanLine, StandsAlongHighColumnsOnly) {
  const QRectF plot(10, 0, 60, 100);
  std::vector<ColumnSpan> columns(60, ColumnSpan{40, 45});  // low: the curve tells it all
  for (std::size_t i = 20; i < 40; ++i) {
    columns[i] = {10, 90};
  }
  for (std::size_t i = 50; i < 55; ++i) {
    columns[i] = {10, 90};  // too few
  }
  const std::vector<float> means(60, 30.0F);
  const auto height_of = [](double value) { return 100 - value; };
  const std::vector<QPolygonF> lines = mean_lines(plot, columns, means, height_of);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].size(), 20);
  EXPECT_EQ(lines[0].front(), QPointF(30.5, 70));
  EXPECT_EQ(lines[0].back(), QPointF(49.5, 70));
  std::vector<float> broken = means;
  broken[25] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(mean_lines(plot, columns, broken, height_of)[0].size(), 14);
  EXPECT_EQ(mean_lines(plot, columns, means, height_of, true)[0].size(), 60) << "everywhere";
  EXPECT_TRUE(mean_lines(plot, columns, std::vector<float>(3), height_of).empty());
}

/// As the lines would be in one go: strips must leave no seam.
TEST(MeanLine, IsDrawnWithoutSeams) {
  QPolygonF line;
  for (int i = 0; i < 400; ++i) {
    line.append(QPointF(10.5 + i, 100 + 80 * std::sin(1.7 * i) * std::cos(0.03 * i)));
  }
  for (const double scale : {1.0, 1.5}) {
    QImage drawn(420, 200, QImage::Format_RGB32);
    drawn.fill(Qt::lightGray);
    QImage expected = drawn;
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    draw_mean_lines(painter, {line}, Qt::darkBlue, Qt::white, scale);
    painter.end();
    QPainter at_once(&expected);
    at_once.setRenderHint(QPainter::Antialiasing);
    for (const QPen& pen : {QPen(QColor(255, 255, 255, 200), 4 * scale), QPen(Qt::darkBlue, 1.6 * scale)}) {
      at_once.setPen(QPen(pen.color(), pen.widthF(), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      at_once.drawPolyline(line);
    }
    at_once.end();
    int most = 0;
    for (int y = 0; y < drawn.height(); ++y) {
      for (int x = 0; x < drawn.width(); ++x) {
        most = std::max(most, std::abs(qGray(drawn.pixel(x, y)) - qGray(expected.pixel(x, y))));
      }
    }
    EXPECT_LE(most, 2) << "scale " << scale;
  }
}

}  // namespace
}  // namespace feedscope::ui
