#include "ui/shared/plot_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <vector>

#include "ui/shared/plot_text.h"

namespace feedscope::ui {
namespace {

using testing::ElementsAre;

TEST(TimeTicks, HaveNoDecimalsThatAreAllNought) {
  const Ticks whole = round_ticks(60, 160, 5);
  EXPECT_EQ(time_tick_text(whole, whole.values.size() - 1), "2:30");
  const Ticks halves = round_ticks(119, 121, 5);
  EXPECT_EQ(time_tick_text(halves, halves.values.size() - 1), "2:01.0");
  const Ticks hours = round_ticks(3600, 7200, 3);
  EXPECT_EQ(time_tick_text(hours, 0), "1:06:40");
}

TEST(TimeTicks, AScaleHasOneUnit) {
  const Ticks minutes = round_ticks(0, 160, 9);
  EXPECT_EQ(time_tick_text(minutes, 0), "0");
  EXPECT_EQ(time_tick_text(minutes, 1), "0:20") << "not 20 next to 1:00";
  EXPECT_EQ(time_scale_title("Time", minutes), "Time");
  const Ticks seconds = round_ticks(0, 50, 6);
  EXPECT_EQ(time_tick_text(seconds, 1), "10");
  EXPECT_EQ(time_scale_title("Time", seconds), "Time [s]");
}

const QRectF plot(60, 10, 100, 50);

/// White, with what `draw` paints in black lines and red labels.
template <typename Draw>
QImage painted(Draw draw) {
  QImage image(200, 100, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  PlotGrid grid(painter, plot, {Qt::black, Qt::blue, Qt::red});
  draw(grid);
  return image;
}

bool has_red(const QImage& image, const QRect& area) {
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      if (colour.red() > 200 && colour.green() < 150) {
        return true;
      }
    }
  }
  return false;
}

TEST(PlotGrid, LinesLieOnWholePixelsAndCrossThePlot) {
  const QImage image = painted([](PlotGrid& grid) {
    grid.level(30.3, {});
    grid.upright(99.8, {}, GridLine::strong);
  });
  EXPECT_EQ(image.pixelColor(70, 30), QColor(Qt::black));
  EXPECT_EQ(image.pixelColor(70, 29), QColor(Qt::white));
  EXPECT_EQ(image.pixelColor(70, 31), QColor(Qt::white));
  EXPECT_EQ(image.pixelColor(100, 20), QColor(Qt::blue));
  EXPECT_EQ(image.pixelColor(100, 63), QColor(Qt::blue)) << "a tick below the plot";
  EXPECT_EQ(image.pixelColor(100, 70), QColor(Qt::white));
}

TEST(PlotGrid, ALabelThatWouldTouchTheOneBeforeIsLeftOut) {
  const QImage close = painted([](PlotGrid& grid) {
    grid.upright(80, "1000");
    grid.upright(90, "1000");
    grid.upright(140, "1000");
  });
  EXPECT_TRUE(has_red(close, {60, 64, 35, 25}));
  EXPECT_FALSE(has_red(close, {103, 64, 12, 25}));
  EXPECT_TRUE(has_red(close, {120, 64, 40, 25}));
  const QImage backwards = painted([](PlotGrid& grid) {
    grid.upright(140, "1000");
    grid.upright(130, "1000");
    grid.upright(80, "1000");
  });
  EXPECT_TRUE(has_red(backwards, {60, 64, 35, 25}));
  EXPECT_TRUE(has_red(backwards, {120, 64, 40, 25}));
  const QImage levels = painted([](PlotGrid& grid) {
    grid.level(55, "8");
    grid.level(50, "8");
  });
  const QImage one = painted([](PlotGrid& grid) { grid.level(55, "8"); });
  EXPECT_EQ(levels.copy(0, 0, 58, 100), one.copy(0, 0, 58, 100));
}

TEST(EntriesInRows, BeginANewRowWhereTheNextOneHasNoRoom) {
  const std::vector<double> widths{40, 40, 40, 300, 10};
  const auto entries = entries_in_rows(widths, QRectF(5, 7, 100, 0), 12, 15, 10);
  EXPECT_THAT(entries, ElementsAre(QRectF(5, 7, 40, 12), QRectF(55, 7, 40, 12), QRectF(5, 22, 40, 12),
                                   QRectF(5, 37, 300, 12), QRectF(5, 52, 10, 12)));
}

}  // namespace
}  // namespace feedscope::ui
