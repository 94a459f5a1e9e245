#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <random>

#include "tests/ui/report/report_fixture.h"
#include "ui/report/scene_picture.h"

namespace feedscope::ui {
namespace {

constexpr QSizeF sizes[] = {{1280, 960}, {640, 480}, {326, 215}};

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

TEST(AnnotationPlacing, LabelsAreInThePictureAndCoverNoOther) {
  ReportInput input = test::two_runs();
  for (unsigned seed = 0; seed < 12; ++seed) {
    input.annotations = some_annotations(2 + static_cast<int>(seed % 5), seed);
    ScenePicture picture(input, 0, ThemeKind::light);
    for (const QSizeF& size : sizes) {
      picture.image(size, {});
      const QRectF room(QPointF(), size);
      const AnnotatedView view{
          picture.scene(), *input.run().shown->run.trajectory, size, 1, Background::light, "run"};
      const auto placed = place_annotations(input.annotations, view);
      EXPECT_EQ(placed.size(), input.annotations.size()) << "all of the path is in view";
      for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_TRUE(room.adjusted(-0.01, -0.01, 0.01, 0.01).contains(placed[i].label))
            << "seed " << seed << ", width " << size.width() << ", label " << i;
        for (std::size_t k = 0; k < i; ++k) {
          EXPECT_FALSE(placed[i].label.intersects(placed[k].label))
              << "seed " << seed << ", width " << size.width() << ", labels " << k << " and " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
