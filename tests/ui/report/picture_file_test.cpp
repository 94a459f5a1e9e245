#include "ui/paper/picture_file.h"

#include <gmock/gmock.h>

#include <QFont>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "tests/ui/report/pdf_reading.h"

namespace feedscope::ui {
namespace {

/// A clipped red square from 10, 10 to 50, 50, a translucent circle, a picture, a dashed line and a text.
void paint(QPainter& painter) {
  painter.save();
  painter.setClipRect(QRectF(0, 0, 50, 50));
  painter.fillRect(QRectF(10, 10, 200, 200), Qt::red);
  painter.restore();
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 255, 128));
  painter.drawEllipse(QRectF(100, 20, 40, 40));
  QImage image(2, 2, QImage::Format_ARGB32);
  image.fill(Qt::green);
  painter.drawImage(QRectF(20, 70, 20, 20), image);
  painter.setPen(QPen(Qt::black, 2, Qt::DashLine));
  painter.drawLine(QPointF(60, 80), QPointF(190, 80));
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(20);
  painter.setFont(font);
  painter.translate(150, 50);
  painter.drawText(QPointF(0, 0), QStringLiteral("Hé"));
}

PictureSpec spec_of(PictureFormat format) {
  PictureSpec spec;
  spec.format = format;
  spec.size = {200, 100};
  spec.title = QStringLiteral("a < b");
  return spec;
}

std::string made(const PictureSpec& spec) {
  return make_picture(spec, paint);
}

QImage drawn_svg(const std::string& svg) {
  QSvgRenderer renderer(QByteArray::fromStdString(svg));
  EXPECT_TRUE(renderer.isValid());
  QImage image(200, 100, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  renderer.render(&painter);
  return image;
}

std::size_t dark_pixels(const QImage& image, const QRect& room) {
  std::size_t dark = 0;
  for (int y = room.top(); y <= room.bottom(); ++y) {
    for (int x = room.left(); x <= room.right(); ++x) {
      dark += qAlpha(image.pixel(x, y)) > 128 && qGray(image.pixel(x, y)) < 80 ? 1 : 0;
    }
  }
  return dark;
}

TEST(PictureFile, PngHasThePixelsAskedForAndTheirSizeOnPaper) {
  PictureSpec spec = spec_of(PictureFormat::png);
  spec.scale = 3;
  QImage image = QImage::fromData(QByteArray::fromStdString(made(spec)));
  EXPECT_EQ(image.size(), QSize(600, 300));
  EXPECT_EQ(image.pixelColor(60, 60), QColor(Qt::red));
  EXPECT_EQ(image.pixelColor(160, 60), QColor(Qt::white));
  spec.paper = QSizeF(50.8, 25.4);
  image = QImage::fromData(QByteArray::fromStdString(made(spec)));
  EXPECT_EQ(image.dotsPerMeterX(), 11811);  // 600 pixels on two inches
}

TEST(PictureFile, PngBelow96DotsAnInchShowsTheWholePictureSmaller) {
  PictureSpec spec = spec_of(PictureFormat::png);
  for (const bool transparent : {false, true}) {
    spec.transparent = transparent;
    spec.scale = 0.5;
    spec.paper = QSizeF(50.8, 25.4);
    const QImage image = QImage::fromData(QByteArray::fromStdString(made(spec)));
    EXPECT_EQ(image.size(), QSize(100, 50));
    EXPECT_EQ(image.dotsPerMeterX(), 1969);  // 100 pixels on two inches
    EXPECT_EQ(image.pixelColor(10, 10), QColor(Qt::red));
    EXPECT_EQ(image.pixelColor(28, 10).alpha(), transparent ? 0 : 255);
    EXPECT_EQ(image.pixelColor(15, 40), QColor(Qt::green));
    EXPECT_GT(dark_pixels(image, {75, 15, 20, 13}), 5U) << "the text";
  }
}

TEST(PictureFile, ATransparentPngIsEmptyWhereNothingIsDrawn) {
  PictureSpec spec = spec_of(PictureFormat::png);
  spec.transparent = true;
  const QImage image = QImage::fromData(QByteArray::fromStdString(made(spec)));
  EXPECT_EQ(image.pixelColor(0, 0).alpha(), 0);
  EXPECT_EQ(image.pixelColor(20, 20), QColor(Qt::red));
  EXPECT_EQ(image.pixelColor(120, 40).alpha(), 128);
}

TEST(PictureFile, SvgShowsTheSameWithoutAnyFont) {
  PictureSpec spec = spec_of(PictureFormat::svg);
  spec.transparent = true;
  const std::string svg = made(spec);
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("<text")));
  EXPECT_THAT(svg, testing::HasSubstr("<title>a &lt; b</title>"));
  const QImage image = drawn_svg(svg);
  EXPECT_EQ(image.pixelColor(20, 20), QColor(Qt::red));
  EXPECT_EQ(image.pixelColor(30, 80), QColor(Qt::green));
  EXPECT_NEAR(image.pixelColor(120, 40).alpha(), 128, 2);
  EXPECT_EQ(image.pixelColor(0, 0).alpha(), 0);
  EXPECT_EQ(image.pixelColor(60, 30).alpha(), 0) << "clipped";
  EXPECT_GT(dark_pixels(image, {150, 30, 40, 25}), 30U) << "the text";
  EXPECT_GT(dark_pixels(image, {60, 78, 130, 4}), 60U) << "the line";
}

/// The points of a path of moves and lines as SVG writes it.
QPolygonF points_of_path(const QString& data) {
  static const QRegularExpression part("([mlhv]?) ?(-?[0-9]*\\.?[0-9]+)");
  QPolygonF points;
  QPointF at;
  QChar command;
  std::optional<double> x;
  for (auto found = part.globalMatch(data); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    command = match.captured(1).isEmpty() ? command : match.captured(1).front();
    const double step = match.captured(2).toDouble();
    if ((command == 'm' || command == 'l') && !x) {
      x = step;
      continue;
    }
    at += command == 'h' ? QPointF(step, 0) : QPointF(x.value_or(0), step);
    x.reset();
    points << at;
  }
  return points;
}

QString path_of_svg(const QPolygonF& points) {
  PictureSpec spec = spec_of(PictureFormat::svg);
  spec.transparent = true;
  const std::string svg = make_picture(spec, [&](QPainter& painter) { painter.drawPolyline(points); });
  static const QRegularExpression path(" d=\"(m[^\"]*)\"");
  return path.match(QString::fromStdString(svg)).captured(1);
}

double distance_to_line(const QPolygonF& line, const QPointF& point) {
  double least = std::numeric_limits<double>::infinity();
  for (qsizetype i = 0; i + 1 < line.size(); ++i) {
    const QPointF way = line[i + 1] - line[i];
    const double square = QPointF::dotProduct(way, way);
    const double share =
        square > 0 ? std::clamp(QPointF::dotProduct(point - line[i], way) / square, 0.0, 1.0) : 0;
    const QPointF away = point - line[i] - share * way;
    least = std::min(least, std::hypot(away.x(), away.y()));
  }
  return least;
}

TEST(PictureFile, SvgLeavesOutPointsThatAStraightLinePasses) {
  QPolygonF points;
  for (int i = 0; i <= 100; ++i) {
    points << QPointF(0.25 * i, 0.5 * i);
  }
  points << QPointF(25, 70) << QPointF(25, 60) << QPointF(5, 60);
  EXPECT_EQ(path_of_svg(points), "m0 0 25 50v20-10h-20");
}

TEST(PictureFile, SvgKeepsEveryPointOfALineWithinAHundredthOfAUnit) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> step(-0.02, 0.03 * seed);
    QPolygonF points{QPointF(50, 50)};
    for (int i = 0; i < 400; ++i) {
      points << points.back() + (i / 50 % 2 == 0 ? QPointF(step(random), 0.01 * std::sin(0.1 * i))
                                                 : QPointF(step(random), step(random)));
    }
    const QPolygonF written = points_of_path(path_of_svg(points));
    EXPECT_LT(written.size(), points.size());
    for (const QPointF& point : points) {
      ASSERT_LE(distance_to_line(written, point), 0.01) << "seed " << seed;
    }
  }
}

TEST(PictureFile, SvgWritesTheOutlineOfALetterOnce) {
  PictureSpec spec = spec_of(PictureFormat::svg);
  const std::string svg = make_picture(spec, [](QPainter& painter) {
    painter.drawText(QPointF(10, 50), QStringLiteral("000"));
    painter.drawText(QPointF(10, 80), QStringLiteral("0"));
  });
  EXPECT_EQ(QString::fromStdString(svg).count("<path id="), 1);
  EXPECT_EQ(QString::fromStdString(svg).count("<use "), 4);
}

TEST(PictureFile, SvgOnPaperIsMeasuredInMillimetres) {
  PictureSpec spec = spec_of(PictureFormat::svg);
  spec.paper = QSizeF(297, 148.5);
  EXPECT_THAT(made(spec), testing::HasSubstr("width=\"297mm\" height=\"148.5mm\" viewBox=\"0 0 200 100\""));
}

TEST(PictureFile, PdfHasOnePageOfTheSizeWithItsFontsInside) {
  PictureSpec spec = spec_of(PictureFormat::pdf);
  spec.paper = QSizeF(297, 148.5);
  const std::string bytes = made(spec);
  test::PdfReading pdf(bytes);
  EXPECT_EQ(pdf.page_count(), 1U);
  EXPECT_NEAR(pdf.page_size(0).first, 297 / 25.4 * 72, 1);
  EXPECT_NEAR(pdf.page_size(0).second, 148.5 / 25.4 * 72, 1);
  EXPECT_EQ(pdf.info("/Title"), "a < b");
  EXPECT_TRUE(pdf.fonts_embedded());
}

TEST(PictureFile, TheSamePaintingGivesTheSameBytes) {
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg, PictureFormat::pdf}) {
    EXPECT_EQ(made(spec_of(format)), made(spec_of(format)));
  }
}

}  // namespace
}  // namespace feedscope::ui
