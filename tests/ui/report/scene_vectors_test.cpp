#include "ui/report/scene_vectors.h"

#include <gmock/gmock.h>

#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include "tests/ui/report/report_fixture.h"
#include "ui/report/pictures.h"
#include "ui/report/scene_picture.h"

namespace feedscope::ui {
namespace {

constexpr QSize size(800, 600);

PictureRequest request_of(PictureFormat format) {
  PictureRequest request;
  request.format = format;
  request.size = size;
  return request;
}

QImage drawn(const std::string& svg) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  QSvgRenderer(QByteArray::fromStdString(svg)).render(&painter);
  return image;
}

/// Averages over squares of four pixels, so that edges may be smoothed in different ways.
QImage averaged(const QImage& image) {
  return image.convertToFormat(QImage::Format_ARGB32_Premultiplied)
      .scaled(image.size() / 4, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

struct Difference {
  double mean = 0;  ///< of a colour channel, of 255
  int largest = 0;
};

Difference difference(const QImage& one, const QImage& other) {
  Difference found;
  const QImage a = averaged(one);
  const QImage b = averaged(other);
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = qPremultiply(a.pixel(x, y));
      const QRgb q = qPremultiply(b.pixel(x, y));
      const int apart = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                  std::abs(qBlue(p) - qBlue(q)), std::abs(qAlpha(p) - qAlpha(q))});
      found.mean += apart;
      found.largest = std::max(found.largest, apart);
    }
  }
  found.mean /= a.width() * a.height();
  return found;
}

class SceneVectors : public testing::TestWithParam<std::tuple<StandardView, ThemeKind, bool>> {
 protected:
  ReportInput input() const {
    ReportInput made = test::two_runs();
    made.view = std::get<0>(GetParam());
    made.annotations = {test::note(QStringLiteral("here"))};
    return made;
  }
  PictureRequest asked(PictureFormat format) const {
    PictureRequest request = request_of(format);
    request.theme = std::get<1>(GetParam());
    request.transparent = std::get<2>(GetParam());
    return request;
  }
};

TEST_P(SceneVectors, LookAsTheBitmap) {
  const ReportInput made = input();
  const QImage bitmap =
      QImage::fromData(QByteArray::fromStdString(scene_file(made, asked(PictureFormat::png))));
  const std::string svg = scene_file(made, asked(PictureFormat::svg));
  const Difference found = difference(drawn(svg), bitmap);
  EXPECT_LT(found.mean, 1.5);
  EXPECT_LT(found.largest, 80) << "a line or a word that is missing is more than 100 apart";
}

INSTANTIATE_TEST_SUITE_P(Views, SceneVectors,
                         testing::Combine(testing::Values(StandardView::iso, StandardView::top),
                                          testing::Values(ThemeKind::light, ThemeKind::dark),
                                          testing::Bool()));

TEST(SceneVectorFiles, WhatIsHiddenAroundAStretchIsHiddenInThemToo) {
  const ReportInput input = test::two_runs();
  const double duration = input.run().shown->run.trajectory->duration();
  for (const bool hidden : {false, true}) {
    const auto made = [&](PictureFormat format) {
      ScenePicture picture(input, 0, ThemeKind::light);
      picture.scene().set_stretch({PathStretch::charts, hidden});
      picture.scene().set_highlight(std::array{0.3 * duration, 0.5 * duration});
      PictureSpec spec;
      spec.format = format;
      spec.size = size;
      return make_picture(spec,
                          [&](QPainter& painter) { picture.paint(painter, QRectF(QPointF(), size), {}); });
    };
    const QImage bitmap = QImage::fromData(QByteArray::fromStdString(made(PictureFormat::png)));
    const Difference found = difference(drawn(made(PictureFormat::svg)), bitmap);
    EXPECT_LT(found.mean, 1.5);
    EXPECT_LT(found.largest, 80);
  }
}

/// Viewers smooth the edge of each band by itself: a ground of another colour must not shine through.
TEST(SceneVectorFiles, TheColourScaleHasNoGaps) {
  ReportInput input = test::two_runs();
  input.scene.colouring = Colouring::feed;
  PictureRequest request = request_of(PictureFormat::svg);
  request.transparent = true;
  const std::string svg = scene_file(input, request);
  QImage image(size * 1.37, QImage::Format_RGB32);
  image.fill(Qt::magenta);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  QSvgRenderer(QByteArray::fromStdString(svg)).render(&painter);
  painter.end();
  // The scale is the longest level stretch of strong colours as high as it is.
  constexpr int height = 5;
  const auto is_scale = [&](int x, int y) {
    const QColor upper = image.pixelColor(x, y);
    return upper.saturation() > 60 && upper.hue() < 280 && upper == image.pixelColor(x, y + height);
  };
  int longest = 0;
  int row = 0;
  int end = 0;
  for (int y = image.height() / 2; y + height < image.height(); ++y) {
    for (int x = 0, run = 0; x < image.width(); ++x) {
      run = is_scale(x, y) ? run + 1 : 0;
      if (run > longest) {
        longest = run;
        row = y;
        end = x;
      }
    }
  }
  ASSERT_GT(longest, 100);
  for (int x = end - longest + 3; x < end - 1; ++x) {
    const QColor before = image.pixelColor(x - 1, row);
    const QColor here = image.pixelColor(x, row);
    EXPECT_LT(std::abs(before.red() - here.red()) + std::abs(before.green() - here.green()) +
                  std::abs(before.blue() - here.blue()),
              30)
        << x;
  }
}

TEST(SceneVectorFiles, HoldNoBitmap) {
  const ReportInput input = test::two_runs();
  const std::string svg = scene_file(input, request_of(PictureFormat::svg));
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  const std::string pdf = scene_file(input, request_of(PictureFormat::pdf));
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);
  EXPECT_LT(svg.size(), 1'000'000U);
}

TEST(SceneVectorFiles, HoldTheirTextsAsTextToo) {
  ReportInput input = test::two_runs();
  input.scene.colouring = Colouring::contour_error;
  input.texts.programmed = "programmée";
  const std::string svg = scene_file(input, request_of(PictureFormat::svg));
  EXPECT_THAT(svg, testing::HasSubstr("µm</text>"));
  EXPECT_THAT(svg, testing::HasSubstr(">programmée</text>"));
  input.scene.colouring = Colouring::feed;
  const std::string other = scene_file(input, request_of(PictureFormat::svg));
  EXPECT_THAT(other, testing::Not(testing::HasSubstr("µm</text>")));
}

TEST(SceneVectorFiles, NothingReachesOutOfThePicturesPlace) {
  // Close to the path, labels and lines of the box lie outside of the view.
  const ReportInput input = test::two_runs();
  ScenePicture picture(input, 0, ThemeKind::light);
  const QRectF place(200, 150, 400, 300);
  picture.prepare(place.size(), {});
  picture.scene().zoom(5, {200, 150});
  PictureSpec spec;
  spec.format = PictureFormat::svg;
  spec.size = size;
  const std::string svg = make_picture(spec, [&](QPainter& painter) { picture.paint(painter, place, {}); });
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  const QImage image = drawn(svg);
  int outside = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      outside += !place.adjusted(-1, -1, 1, 1).contains(x, y) && image.pixel(x, y) != qRgb(255, 255, 255);
    }
  }
  EXPECT_EQ(outside, 0);
}

TEST(SceneVectorFiles, AreTheSameBytesAgain) {
  const ReportInput input = test::two_runs();
  for (const PictureFormat format : {PictureFormat::svg, PictureFormat::pdf}) {
    EXPECT_EQ(scene_file(input, request_of(format)), scene_file(input, request_of(format)));
  }
}

TEST(SceneVectorFiles, ASheetsPathIsVectorsToo) {
  const ReportInput input = test::two_runs();
  PictureRequest request = request_of(PictureFormat::svg);
  request.size = {1123, 794};
  EXPECT_EQ(sheet_file(input, request).find("<image"), std::string::npos);
}

TEST(ScenePicture, DrawsTheStretchOfTheSession) {
  ReportInput input = test::two_runs();
  input.scene.tool.kind = ToolKind::flat;
  const auto picture = [&] { return scene_file(input, request_of(PictureFormat::png)); };
  const std::string whole = picture();
  const double duration = input.run().shown->run.trajectory->duration();
  input.cursor = duration / 2;
  input.charts.time = Interval{0, duration / 3};
  EXPECT_TRUE(picture() == whole) << "as long as all is drawn in full";
  input.scene.stretch = {PathStretch::to_cursor, false};
  const std::string half = picture();
  EXPECT_FALSE(half == whole);
  input.scene.stretch = {PathStretch::charts, false};
  EXPECT_FALSE(picture() == whole);
  EXPECT_FALSE(picture() == half);
  input.charts.time = Interval{0, duration};
  EXPECT_TRUE(picture() == whole) << "no tool, nothing pale";
  input.scene.stretch = {PathStretch::to_cursor, true};
  input.cursor = 2 * duration;
  EXPECT_TRUE(picture() == whole) << "a run that ends before the cursor is drawn to its end";
}

}  // namespace
}  // namespace feedscope::ui
