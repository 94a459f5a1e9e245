#include "ui/charts/curve_columns.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "ui/charts/usual_band.h"

namespace feedscope::ui {
namespace {

constexpr int width = 200;
constexpr int height = 100;

QImage drawn(const std::vector<ColumnSpan>& columns, CurvePen pen = {Qt::black, 1.8}) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  draw_columns(painter, QRectF(0, 0, width, height), columns, pen);
  return image;
}

/// How much of a pixel is covered, 0 to 1.
double ink(const QImage& image, int x, int y) {
  return 1 - image.pixelColor(x, y).lightnessF();
}

double ink_of_column(const QImage& image, int x) {
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    sum += ink(image, x, y);
  }
  return sum;
}

TEST(CurveColumns, ALevelLineIsAsThickAsItsPen) {
  const QImage image = drawn(std::vector<ColumnSpan>(width, {50, 50}));
  for (int x = 0; x < width; ++x) {
    EXPECT_NEAR(ink_of_column(image, x), 1.8, 0.05) << x;
  }
}

TEST(CurveColumns, ASlantedLineIsAsThickAsALevelOne) {
  std::vector<ColumnSpan> columns;
  for (int x = 0; x < width; ++x) {
    columns.push_back({90 - 0.4 * (x + 1), 90 - 0.4 * x});
  }
  const QImage image = drawn(columns);
  for (int x = 5; x < width - 5; ++x) {
    EXPECT_NEAR(ink_of_column(image, x), 1.8 * std::hypot(1, 0.4), 0.15) << x;
  }
}

TEST(CurveColumns, CoverEveryPixelTheyHold) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(5, 95);
  for (int round = 0; round < 20; ++round) {
    std::vector<ColumnSpan> columns;
    for (int x = 0; x < width; ++x) {
      const auto [top, bottom] = std::minmax({anywhere(random), anywhere(random)});
      columns.push_back(round % 2 == 0 || x % 40 < 20 ? ColumnSpan{top, bottom} : ColumnSpan{50, 50});
    }
    const QImage image = drawn(columns);
    for (int x = 0; x < width; ++x) {
      const ColumnSpan& span = columns[static_cast<std::size_t>(x)];
      double covered = 0;
      for (int y = static_cast<int>(std::ceil(span.top)); y < static_cast<int>(span.bottom); ++y) {
        covered += ink(image, x, y);
      }
      const double held = std::max(0.0, std::floor(span.bottom) - std::ceil(span.top));
      EXPECT_GE(covered, 0.3 * held - 0.5) << round << ' ' << x;
    }
  }
}

TEST(CurveColumns, JumpsAreJoined) {
  std::vector<ColumnSpan> columns(width, {80, 80});
  std::fill(columns.begin() + 100, columns.end(), ColumnSpan{20, 20});
  const QImage image = drawn(columns);
  for (int y = 22; y < 78; ++y) {
    EXPECT_GT(ink(image, 99, y) + ink(image, 100, y), 0.4) << y;
  }
}

TEST(CurveColumns, EmptyColumnsAndDashesStayWhite) {
  std::vector<ColumnSpan> columns(width, {50, 50});
  columns[30] = {};
  const QImage image = drawn(columns);
  EXPECT_EQ(ink_of_column(image, 30), 0);
  EXPECT_GT(ink_of_column(image, 29), 1);
  const QImage dashed = drawn(std::vector<ColumnSpan>(width, {50, 50}), {Qt::black, 1.8, true});
  int blank = 0;
  for (int x = 0; x < width; ++x) {
    blank += ink_of_column(dashed, x) == 0 ? 1 : 0;
  }
  EXPECT_EQ(blank, width * 4 / 10);
  EXPECT_EQ(drawn({}).pixelColor(10, 50), QColor(Qt::white));
}

/// Two curves that swing over the whole height within each column: both are still to be seen.
TEST(CurveColumns, CurvesThatSwingDoNotHideEachOther) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(0, 3);
  std::vector<ColumnSpan> wide;
  std::vector<ColumnSpan> narrow;
  for (int x = 0; x < width; ++x) {
    wide.push_back({5 + noise(random), 95 - noise(random)});
    narrow.push_back({20 + noise(random), 80 - noise(random)});
  }
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF plot(0, 0, width, height);
  const CurvePen red{Qt::red, 1.2, false, true};
  const CurvePen blue{Qt::blue, 1.2, false, true};
  fill_hollows(painter, plot, wide, {QColor(255, 200, 200), 1.2});
  fill_hollows(painter, plot, narrow, {QColor(200, 200, 255), 1.2});
  draw_columns(painter, plot, wide, red);
  draw_columns(painter, plot, narrow, blue);
  painter.end();
  const auto count = [&](int y0, int y1, auto test) {
    int found = 0;
    for (int y = y0; y < y1; ++y) {
      for (int x = 0; x < width; ++x) {
        found += test(image.pixelColor(x, y)) ? 1 : 0;
      }
    }
    return found;
  };
  const auto is_red = [](const QColor& c) { return c.red() > 200 && c.green() < 60; };
  const auto is_blue = [](const QColor& c) { return c.blue() > 200 && c.green() < 60; };
  const auto is_pale = [](const QColor& c) { return c.green() > 150 && c.green() < 250; };
  EXPECT_GT(count(0, 12, is_red), width / 2) << "upper edge of the wide curve";
  EXPECT_GT(count(88, height, is_red), width / 2);
  EXPECT_GT(count(15, 30, is_blue), width / 2) << "upper edge of the narrow curve";
  EXPECT_GT(count(30, 70, is_pale), 0.95 * 40 * width) << "the inside is pale";
}

/// Columns of 40 + 30 sin(2 pi t / `period`), t in columns.
std::vector<ColumnSpan> wave(double period) {
  std::vector<ColumnSpan> columns;
  for (int x = 0; x < 1000; ++x) {
    ColumnSpan span{1e9, -1e9};
    for (int i = 0; i <= 100; ++i) {
      const double y = 40 + 30 * std::sin(2 * std::numbers::pi * (x + i / 100.0) / period);
      span = {std::min(span.top, y), std::max(span.bottom, y)};
    }
    columns.push_back(span);
  }
  return columns;
}

TEST(CurveColumns, HideACurveThatSwingsWithinThem) {
  for (const double period : {5.0, 10.0, 24.0, 300.0}) {
    EXPECT_FALSE(hidden_in_bars(wave(period))) << period;
  }
  for (const double period : {0.1, 0.5, 1.0, 1.5}) {
    EXPECT_TRUE(hidden_in_bars(wave(period))) << period;
  }
}

TEST(CurveColumns, HideACurveWhateverItsPeaks) {
  std::vector<ColumnSpan> slow = wave(24);
  std::vector<ColumnSpan> fast = wave(0.5);
  for (std::size_t i = 0; i < slow.size(); i += 50) {
    slow[i].top = fast[i].top = -1000;
  }
  EXPECT_FALSE(hidden_in_bars(slow));
  EXPECT_TRUE(hidden_in_bars(fast));
}

TEST(CurveColumns, HideNothingWhereTheyAreLowOrEmpty) {
  EXPECT_FALSE(hidden_in_bars({}));
  EXPECT_FALSE(hidden_in_bars(std::vector<ColumnSpan>(100)));
  EXPECT_FALSE(hidden_in_bars(std::vector<ColumnSpan>(100, {50, 53}))) << "no thicker than a pen";
  EXPECT_TRUE(hidden_in_bars(std::vector<ColumnSpan>(100, {50, 60})));
}

TEST(UsualBand, SaysMoreThanRarePeaksAndThanBars) {
  std::vector<ColumnSpan> columns(1000, {50, 50.5});
  for (std::size_t i = 0; i < columns.size(); i += 5) {
    columns[i] = {10, 90};
  }
  EXPECT_FALSE(hidden_in_bars(columns));
  EXPECT_TRUE(says_more(std::vector<ColumnSpan>(84, {49, 51}), columns)) << "nearly always at 50";
  EXPECT_FALSE(says_more(std::vector<ColumnSpan>(84, {15, 85}), columns)) << "often elsewhere";
  EXPECT_FALSE(says_more(std::vector<ColumnSpan>(84, {10, 70}), wave(24)));
  EXPECT_TRUE(says_more(std::vector<ColumnSpan>(84, {10, 70}), wave(0.5)));
  EXPECT_NEAR(mean_height(columns), 0.8 * 0.5 + 0.2 * 80, 1e-9);
  EXPECT_EQ(mean_height(std::vector<ColumnSpan>(3)), 0);
}

}  // namespace
}  // namespace feedscope::ui
