#include "ui/scene/path/path_stretch.h"

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "tests/ui/run_fixture.h"
#include "ui/scene/path_scene.h"
#include "ui/scene/render_window.h"

namespace feedscope::ui {
namespace {

/// Long lines and arcs: a stretch ends within their spans. Drawn from above in red.
class PathStretchTest : public testing::Test {
 protected:
  PathStretchTest() {
    window_->SetSize(width, height);
    scene_.attach(*window_);
    scene_.set_background(Background::light);
    scene_.set_colouring(Colouring::run);
    scene_.set_run_colour({1, 0, 0});
    scene_.set_tool({ToolKind::none, 1, 0});
    scene_.set_executed(run_.trajectory);
    scene_.set_standard_view(StandardView::top);
  }

  double duration() const { return run_.trajectory->duration(); }
  /// How red the most red pixel is at an instant, 0 to 1.
  double redness(double time) {
    const Pixel place = scene_.pixel_of(run_.trajectory->state(time).position);
    double most = 0;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto x = static_cast<vtkIdType>(std::lround(place[0] - 0.5)) + dx;
        const auto y = static_cast<vtkIdType>(std::lround(height - place[1] - 0.5)) + dy;
        const vtkIdType at = 4 * (y * width + x);
        const double red = pixels_->GetValue(at);
        const double others = std::max(pixels_->GetValue(at + 1), pixels_->GetValue(at + 2));
        most = std::max(most, (red - others) / 255);
      }
    }
    return most;
  }
  double pixels_between(double time, double other) const {
    const Pixel a = scene_.pixel_of(run_.trajectory->state(time).position);
    const Pixel b = scene_.pixel_of(run_.trajectory->state(std::clamp(other, 0.0, duration())).position);
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  /// What is within [from, to] is red, what is outside is not.
  void expect_full_within(double from, double to) {
    window_->Render();
    window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels_);
    constexpr int instants = 400;
    for (int i = 1; i < instants; ++i) {
      const double time = duration() * i / instants;
      if (pixels_between(time, from) < 5 || pixels_between(time, to) < 5 || pixels_between(time, 0) < 20) {
        continue;  // ends, and the mark of the zero point
      }
      if (time > from && time < to) {
        EXPECT_GT(redness(time), 0.8) << time;
      } else {
        EXPECT_LT(redness(time), 0.05) << time;
      }
    }
  }

  static constexpr int width = 900;
  static constexpr int height = 700;
  feedscope::Run run_ =
      test::simulate_text("G21 G90 G94 F6000\nG1 X100\nG2 X100 Y-40 I0 J-20\nG1 X0 Y-40\nX0 Y-70\nX100\n");
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_ = make_render_window(RenderBackend::software);
  vtkNew<vtkUnsignedCharArray> pixels_;
  PathScene scene_;
};

TEST_F(PathStretchTest, AllIsDrawnInFullWithoutAChoice) {
  scene_.set_cursor(run_.trajectory->state(0.3 * duration()));
  scene_.set_highlight(std::array{0.2, 0.4});
  expect_full_within(-1, duration() + 1);
}

TEST_F(PathStretchTest, ATrailEndsAtTheCursorWithinSpans) {
  scene_.set_stretch({PathStretch::to_cursor, false});
  for (const double share : {0.1, 0.37, 0.62, 0.9}) {
    scene_.set_cursor(run_.trajectory->state(share * duration()));
    expect_full_within(-1, share * duration());
  }
  scene_.set_cursor(std::nullopt);
  expect_full_within(-1, duration() + 1);
}

TEST_F(PathStretchTest, TheChartRangeIsDrawnInFull) {
  scene_.set_stretch({PathStretch::charts, false});
  for (const auto& [from, to] : {std::pair(0.12, 0.2), std::pair(0.3, 0.55), std::pair(0.7, 1.0)}) {
    scene_.set_highlight(std::array{from * duration(), to * duration()});
    expect_full_within(from * duration(), to * duration());
  }
}

TEST_F(PathStretchTest, WhatIsHiddenIsNeitherDrawnNorPicked) {
  scene_.set_stretch({PathStretch::charts, true});
  const double from = 0.3 * duration();
  const double to = 0.55 * duration();
  scene_.set_highlight(std::array{from, to});
  expect_full_within(from, to);
  const auto picked = [&](double share) {
    return scene_.pick_time(scene_.pixel_of(run_.trajectory->state(share * duration()).position));
  };
  EXPECT_TRUE(picked(0.4));
  EXPECT_FALSE(picked(0.1));
  EXPECT_FALSE(picked(0.95));
  scene_.set_stretch({});
  EXPECT_TRUE(picked(0.1));
  expect_full_within(-1, duration() + 1);
}

TEST_F(PathStretchTest, TheProgrammedPathIsHiddenWithTheRest) {
  scene_.set_executed(nullptr);
  scene_.set_executed(run_.trajectory);
  scene_.set_programmed(run_.path.toolpath);
  scene_.set_stretch({PathStretch::to_cursor, true});
  scene_.set_cursor(run_.trajectory->state(0.1 * duration()));
  window_->Render();
  window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels_);
  const auto darkness = [&](double share) {
    const Pixel place = scene_.pixel_of(run_.trajectory->state(share * duration()).position);
    int least = 255;
    for (int dy = -2; dy <= 2; ++dy) {
      const vtkIdType y = static_cast<vtkIdType>(std::lround(height - place[1])) + dy;
      const vtkIdType at = 4 * (y * width + static_cast<vtkIdType>(std::lround(place[0])));
      least = std::min<int>(least, pixels_->GetValue(at + 1));
    }
    return 255 - least;
  };
  EXPECT_GT(darkness(0.05), 100);
  EXPECT_LT(darkness(0.6), 60) << "a grid line at most";
}

TEST(StretchChoice, SaysTheTimes) {
  const TimeStretch charts{1, 2};
  EXPECT_EQ(StretchChoice().times(charts, 3.0), std::nullopt);
  EXPECT_EQ((StretchChoice{PathStretch::charts, false}.times(charts, 3.0)), charts);
  EXPECT_EQ((StretchChoice{PathStretch::charts, false}.times(std::nullopt, 3.0)), std::nullopt);
  EXPECT_EQ((StretchChoice{PathStretch::to_cursor, true}.times(charts, 3.0)), (TimeStretch{0, 3}));
  EXPECT_EQ((StretchChoice{PathStretch::to_cursor, true}.times(charts, std::nullopt)), std::nullopt);
}

}  // namespace
}  // namespace feedscope::ui
