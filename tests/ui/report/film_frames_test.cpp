#include "ui/film/film_frames.h"

#include <gmock/gmock.h>

#include <QPointF>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "tests/ui/report/report_fixture.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr QSize film_size(800, 628);  // the view 800 x 600, the caption 28

FilmLook film_look(QSize size = film_size) {
  FilmLook look;
  look.picture.size = size;
  look.trail = 0;
  return look;
}

/// Pixels that are not the same in both.
std::vector<QPoint> changed(const QImage& a, const QImage& b, const QRect& where) {
  std::vector<QPoint> pixels;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      if (a.pixel(x, y) != b.pixel(x, y)) {
        pixels.emplace_back(x, y);
      }
    }
  }
  return pixels;
}

class FilmFramesTest : public testing::Test {
 protected:
  FilmFramesTest() { input_.view = StandardView::front; }

  double duration() const { return input_.run().shown->run.trajectory->duration(); }
  /// Where an instant of the run is in a frame.
  QPointF place(double time) {
    ScenePicture picture(input_, input_.current, ThemeKind::light);
    picture.image(view_.size(), {1, 1});
    const Pixel pixel = picture.scene().pixel_of(input_.run().shown->run.trajectory->state(time).position);
    return {pixel[0], pixel[1]};
  }

  ReportInput input_ = test::two_runs();
  QRect view_{0, 0, 800, 600};
};

/// Seen from the front the marker stands on its tip: the lowest pixel that is not drawn without a tool.
TEST_F(FilmFramesTest, TheToolIsWhereTheRunIsAtTheTimeOfTheFrame) {
  const FilmTimes times{.from = 0.1, .to = duration(), .speed = 0.7, .fps = 4};
  FilmFrames with(input_, times, film_look());
  ReportInput bare = input_;
  bare.scene.tool.kind = ToolKind::none;
  FilmFrames without(bare, times, film_look());
  for (std::size_t k = 0; k < times.frames(); k += 2) {
    const auto tool = changed(with.frame(k), without.frame(k), view_);
    ASSERT_FALSE(tool.empty()) << k;
    const QPoint tip = *std::ranges::max_element(tool, {}, &QPoint::y);
    const QPointF wanted = place(std::min(0.1 + static_cast<double>(k) * 0.7 / 4, duration()));
    EXPECT_NEAR(tip.x(), wanted.x(), 3) << k;
    EXPECT_NEAR(tip.y(), wanted.y(), 3) << k;
  }
}

TEST_F(FilmFramesTest, TheTrailReachesBackSoFar) {
  const double end = 0.6 * duration();
  const FilmTimes times{.from = 0, .to = end, .speed = end, .fps = 1};
  input_.view = StandardView::top;
  FilmLook look = film_look();
  FilmFrames without(input_, times, look);
  look.trail = 0.2 * duration();
  FilmFrames with(input_, times, look);
  const auto trail = changed(with.frame(1), without.frame(1), view_);
  const auto is_drawn = [&](double time) {
    const QPointF at = place(time);
    return std::ranges::any_of(
        trail, [&](const QPoint& pixel) { return std::hypot(pixel.x() - at.x(), pixel.y() - at.y()) < 3; });
  };
  EXPECT_TRUE(is_drawn(end - 0.02 * duration()));
  EXPECT_TRUE(is_drawn(end - 0.15 * duration()));
  EXPECT_FALSE(is_drawn(end - 0.25 * duration()));
  EXPECT_FALSE(is_drawn(end + 0.05 * duration()));
  EXPECT_TRUE(changed(with.frame(0), without.frame(0), view_).empty()) << "nothing is before the start";
}

TEST_F(FilmFramesTest, AFrameIsTheSameWhateverWasDrawnBefore) {
  const FilmTimes times{.from = 0, .to = duration(), .speed = 1, .fps = 5};
  FilmLook look = film_look({900, 700});
  look.charts = true;
  look.trail.reset();
  FilmFrames film(input_, times, look);
  const QImage third = film.frame(3);
  film.frame(0);
  film.frame(7);
  EXPECT_EQ(film.frame(3), third);
  FilmFrames again(input_, times, look);
  EXPECT_EQ(again.frame(3), third);
  EXPECT_NE(again.frame(4), third);
}

TEST_F(FilmFramesTest, TheCursorRunsAlongTheCharts) {
  const FilmTimes times{.from = 0.2, .to = duration(), .speed = 1, .fps = 10};
  FilmLook look = film_look({900, 700});
  look.charts = true;
  FilmFrames film(input_, times, look);
  const QRect lowest_chart(0, 620, 900, 40);
  const auto cursor = [&](std::size_t k, std::size_t other) {
    const auto pixels = changed(film.frame(k), film.frame(other), lowest_chart);
    double sum = 0;
    for (const QPoint& pixel : pixels) {
      sum += pixel.x();
    }
    return pixels.empty() ? 0.0 : sum / static_cast<double>(pixels.size());
  };
  // The middle of two cursors moves on as both do.
  const double first = cursor(2, 4);
  const double second = cursor(4, 6);
  const double third = cursor(6, 8);
  EXPECT_GT(second, first + 10);
  EXPECT_NEAR(third - second, second - first, 2);
}

TEST_F(FilmFramesTest, HasTheSizeInPixels) {
  FilmLook look = film_look({640, 360});
  look.picture.pixel_ratio = 2;
  look.picture.theme = ThemeKind::light;
  FilmFrames film(input_, {.from = 0, .to = 1}, look);
  EXPECT_EQ(film.frame(0).size(), QSize(1280, 720));
}

TEST_F(FilmFramesTest, RefusesASizeWithoutRoom) {
  FilmLook look = film_look({400, 260});
  EXPECT_NO_THROW(FilmFrames(input_, {.from = 0, .to = 1}, look));
  look.charts = true;
  EXPECT_THAT(
      [&] { FilmFrames(input_, {.from = 0, .to = 1}, look); },
      ThrowsMessage<InputError>(HasSubstr("too small for the view and the charts; use a larger --size")));
}

}  // namespace
}  // namespace feedscope::ui
