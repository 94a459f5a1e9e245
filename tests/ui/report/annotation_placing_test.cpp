#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <random>

#include "tests/ui/report/report_fixture.h"
#include "ui/report/scene_picture.h"

namespace feedscope::ui {
namespace {

/// A picture, and how many labels have room in it beside each other.
struct PictureRoom {
  QSizeF size;
  int labels;
};
constexpr PictureRoom pictures[] = {{{1280, 960}, 6}, {{640, 480}, 6}, {{326, 215}, 3}};

/// Annotations of all kinds at places of the path, with labels where they want.
std::vector<Annotation> some_annotations(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::uniform_real_distribution<double> away(-90, 90);
  std::vector<Annotation> all;
  for (int i = 0; i < count; ++i) {
    Annotation annotation;
    annotation.id = i + 1;
    annotation.kind = annotation_kinds[random() % std::size(annotation_kinds)];
    annotation.place = {static_cast<std::uint32_t>(random() % 4), share(random)};
    annotation.until = {static_cast<std::uint32_t>(random() % 4), share(random)};
    annotation.text = QStringLiteral("place %1\n{feed}").arg(i);
    annotation.offset = {away(random), away(random)};
    annotation.size = 8;
    all.push_back(annotation);
  }
  return all;
}

/// Whether the line from a label to its place crosses a text.
bool crosses_text(const PlacedAnnotation& placed, const QRectF& text) {
  constexpr int parts = 400;
  const QPointF from = placed.label.center();
  for (int i = 0; i <= parts; ++i) {
    const QPointF at = from + (placed.middle - from) * i / parts;
    if (text.contains(at) && !placed.label.contains(at)) {
      return true;
    }
  }
  return false;
}

TEST(AnnotationPlacing, LabelsAreInTheRoomOfThePathAndCoverNoOther) {
  ReportInput input = test::two_runs();
  for (unsigned seed = 0; seed < 12; ++seed) {
    for (const auto& [size, most] : pictures) {
      input.annotations = some_annotations(std::min(2 + static_cast<int>(seed % 5), most), seed);
      ScenePicture picture(input, 0, ThemeKind::light);
      picture.image(size, {});
      const QRectF room(QPointF(), size);
      const auto placed = picture.annotations(size, {});
      EXPECT_EQ(placed.size(), input.annotations.size()) << "all of the path is in view";
      for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_TRUE(room.adjusted(-0.01, -0.01, 0.01, 0.01).contains(placed[i].label))
            << "seed " << seed << ", width " << size.width() << ", label " << i;
        for (const auto& [upper, lower] : picture.scene().covered()) {
          const QRectF text(QPointF(upper[0], upper[1]), QPointF(lower[0], lower[1]));
          EXPECT_FALSE(placed[i].label.intersects(text))
              << "seed " << seed << ", width " << size.width() << ", label " << i;
        }
        for (std::size_t k = 0; k < placed.size(); ++k) {
          const bool has_leader = placed[k].kind != AnnotationKind::text && k != i;
          EXPECT_FALSE(has_leader && crosses_text(placed[k], placed[i].label))
              << "seed " << seed << ", width " << size.width() << ", line of " << k << " and label " << i;
        }
        for (std::size_t k = 0; k < i; ++k) {
          EXPECT_FALSE(placed[i].label.intersects(placed[k].label))
              << "seed " << seed << ", width " << size.width() << ", labels " << k << " and " << i;
        }
      }
    }
  }
}

TEST(AnnotationPlacing, ALabelKeepsItsPlaceInAPictureOfAnotherSize) {
  ReportInput input = test::two_runs();
  Annotation annotation = test::note("here");
  annotation.offset = {120, 90};
  annotation.view = {1280, 960};
  input.annotations = {annotation};
  ScenePicture picture(input, 0, ThemeKind::light);
  for (const QSizeF& size : {QSizeF(1280, 960), QSizeF(640, 480)}) {
    picture.image(size, {});
    const PlacedAnnotation placed = picture.annotations(size, {}).at(0);
    const QPointF away = placed.label.center() - placed.middle;
    EXPECT_NEAR(away.x(), 120 * size.width() / 1280, 0.01);
    EXPECT_NEAR(away.y(), 90 * size.width() / 1280, 0.01);
  }
  input.annotations[0].view = {};
  picture.image({640, 480}, {});
  const PlacedAnnotation placed = picture.annotations({640, 480}, {}).at(0);
  EXPECT_NEAR((placed.label.center() - placed.middle).x(), 120, 0.01) << "made in no view that is known";
}

/// Near the edge of the view, where a wide stroke would reach over legend and colour scale.
TEST(AnnotationPlacing, NothingIsDrawnOverLegendAndColourScale) {
  ReportInput input = test::two_runs();
  const QSizeF size(640, 480);
  for (unsigned seed = 0; seed < 6; ++seed) {
    const auto picture_with = [&](const std::vector<Annotation>& annotations, QPainterPath& room) {
      ReportInput seen = input;
      seen.annotations = annotations;
      ScenePicture picture(seen, 0, ThemeKind::light);
      picture.prepare(size, {});
      picture.scene().fit();
      picture.scene().zoom(3, {200.0 + 40 * seed, 240});
      QImage image(size.toSize(), QImage::Format_RGB32);
      QPainter painter(&image);
      picture.paint(painter, QRectF(QPointF(), size), {});
      room = QPainterPath();
      room.addRect(QRectF(QPointF(), size));
      for (const auto& [upper, lower] : picture.scene().covered()) {
        QPainterPath text;
        text.addRect(QRectF(QPointF(upper[0], upper[1]), QPointF(lower[0], lower[1])).adjusted(1, 1, -1, -1));
        room -= text;
      }
      return image;
    };
    std::vector<Annotation> regions = some_annotations(6, seed);
    for (Annotation& annotation : regions) {
      annotation.kind = AnnotationKind::region;
      annotation.place = {0, 0.0};
      annotation.until = {3, 1.0};
    }
    QPainterPath room;
    const QImage without = picture_with({}, room);
    const QImage with = picture_with(regions, room);
    int inside = 0;
    int outside = 0;
    for (int y = 0; y < with.height(); ++y) {
      for (int x = 0; x < with.width(); ++x) {
        const bool changed = with.pixel(x, y) != without.pixel(x, y);
        const bool in_room = room.contains(QPointF(x + 0.5, y + 0.5));
        (in_room ? inside : outside) += changed ? 1 : 0;
      }
    }
    EXPECT_EQ(outside, 0) << "seed " << seed;
    EXPECT_GT(inside, 100) << "seed " << seed;
  }
}

}  // namespace
}  // namespace feedscope::ui
