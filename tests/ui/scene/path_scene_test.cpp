#include "ui/scene/path_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <set>

#include "tests/ui/run_fixture.h"
#include "ui/scene/render_window.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {
namespace {

using test::simulate_text;

constexpr std::array views{StandardView::iso,    StandardView::top,  StandardView::front, StandardView::right,
                           StandardView::bottom, StandardView::back, StandardView::left};

double distance(const Pixel& a, const Pixel& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

class PathSceneTest : public testing::Test {
 protected:
  PathSceneTest() {
    window_->SetSize(width, height);
    scene_.attach(*window_);
  }

  void show(const feedscope::Run& run, StandardView view) {
    scene_.set_programmed(run.path.toolpath);
    scene_.set_executed(run.trajectory);
    scene_.set_standard_view(view);
    window_->Render();
  }

  vtkSmartPointer<vtkUnsignedCharArray> pixels() {
    vtkNew<vtkUnsignedCharArray> rgba;
    window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, rgba);
    return rgba.Get();
  }

  static constexpr int width = 800;
  static constexpr int height = 600;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_ = make_render_window(RenderBackend::software);
  PathScene scene_;
};

/// Two runs that are 0.05 mm apart at most: one line in the whole view, two close up.
TEST_F(PathSceneTest, ARunIsNamedAsHiddenWhereTheShownOneCoversIt) {
  const auto run = simulate_text("G21 G90 F3000\nG1 X100\nY100\n");
  show(run, StandardView::top);
  const auto legend_width = [&](double apart, double zoom) {
    scene_.set_overlays(
        {{std::make_shared<const SampledPath>(sample_executed(run.trajectory)), {1, 0, 0}, "B", apart}});
    scene_.set_standard_view(StandardView::top);
    scene_.zoom(zoom, {width / 2.0, height / 2.0});
    window_->Render();
    const auto [upper, lower] = scene_.covered().front();
    return lower[0] - upper[0];
  };
  EXPECT_GT(legend_width(0.05, 1), legend_width(5, 1) + 50);
  EXPECT_EQ(legend_width(0.05, 100), legend_width(5, 100));
}

/// Around the zero points, and nowhere else, the picture of a program with several offsets is another one
/// than that of the same path without.
TEST_F(PathSceneTest, ZeroPointsOfSeveralOffsetsAreMarked) {
  const auto run = simulate_text("G21 G90 F3000\nG10 L2 P2 X60 Y30\nG54 G1 X20 Y3\nG55 X20 Y30 Z10\nM30\n");
  const std::vector<ZeroPoint>& points = run.path->zero_points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1].name, "G55");
  EXPECT_EQ(points[1].place, Vec3(60, 30, 0));
  EXPECT_TRUE(points[0].assumed);
  EXPECT_FALSE(points[1].assumed);
  show(run, StandardView::top);
  const vtkSmartPointer<vtkUnsignedCharArray> with = pixels();
  auto plain = std::make_shared<Toolpath>(*run.path);
  plain->zero_points.resize(1);
  scene_.set_programmed(plain);
  window_->Render();
  const vtkSmartPointer<vtkUnsignedCharArray> without = pixels();
  int changed = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const vtkIdType at = vtkIdType{4} * (y * width + x);
      if (with->GetValue(at) == without->GetValue(at) &&
          with->GetValue(at + 1) == without->GetValue(at + 1)) {
        continue;
      }
      ++changed;
      const auto near = [&](const ZeroPoint& point) {
        const Pixel mark = scene_.pixel_of(point.place);
        const double right = x - mark[0];
        const double down = height - y - mark[1];
        return right > -12 && right < 120 && down > -12 && down < 30;
      };
      EXPECT_TRUE(near(points[0]) || near(points[1])) << x << ", " << y;
    }
  }
  EXPECT_GT(changed, 200);
}

TEST_F(PathSceneTest, PicksTheTimeOfThePointUnderThePixel) {
  const auto run =
      simulate_text("G21 G90 G94 F3000\nG1 X20 Y3\nX40 Y18 Z5\nG2 X60 Y18 I10 J0\nG1 X75 Y60 Z20\n");
  for (const StandardView view : views) {
    show(run, view);
    for (int i = 0; i <= 200; ++i) {
      const double time = run.trajectory->duration() * i / 200;
      const Pixel pixel = scene_.pixel_of(run.trajectory->state(time).position);
      const auto picked = scene_.pick_time(pixel);
      ASSERT_TRUE(picked) << "at " << time << " s";
      EXPECT_LT(distance(scene_.pixel_of(run.trajectory->state(*picked).position), pixel), 1.01)
          << "at " << time << " s, picked " << *picked << " s";
    }
  }
}

TEST_F(PathSceneTest, PicksInPerspectiveToo) {
  const auto run =
      simulate_text("G21 G90 G94 F3000\nG1 X20 Y3\nX40 Y18 Z5\nG2 X60 Y18 I10 J0\nX75 Y60 Z20\n");
  scene_.set_perspective(true);
  show(run, StandardView::iso);
  scene_.zoom(1.7, {300, 200});
  scene_.orbit({40, -25});
  for (int i = 0; i <= 100; ++i) {
    const double time = run.trajectory->duration() * i / 100;
    const Pixel pixel = scene_.pixel_of(run.trajectory->state(time).position);
    const auto picked = scene_.pick_time(pixel);
    ASSERT_TRUE(picked) << time;
    EXPECT_LT(distance(scene_.pixel_of(run.trajectory->state(*picked).position), pixel), 1.01) << time;
  }
}

TEST_F(PathSceneTest, PicksTheExaggeratedPathWhereItIsDrawn) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X40\nY40\nX80\n");
  show(run, StandardView::top);
  scene_.set_exaggeration(100);
  const std::uint32_t blend = run.trajectory->blend(0).element;
  const BlendedPath& path = run.trajectory->path();
  const double corner = run.trajectory->state_at_path(path.s(blend) + path.length(blend) / 2).time;
  const Vec3 drawn = scene_.drawn_at(corner);
  const Vec3 true_place = run.trajectory->state(corner).position;
  const Vec3 from_corner = true_place - Vec3(40, 0, 0);
  EXPECT_NEAR((drawn - Vec3(40, 0, 0)).norm(), 100 * from_corner.norm(), 3 * from_corner.norm());
  const auto picked = scene_.pick_time(scene_.pixel_of(drawn));
  ASSERT_TRUE(picked);
  EXPECT_NEAR(*picked, corner, 1e-3 * run.trajectory->duration());
  EXPECT_NEAR(scene_.contour_error_at(corner), from_corner.norm() / std::sqrt(2.0),
              1e-6 * from_corner.norm());
}

TEST_F(PathSceneTest, TheTurntableKeepsZUprightAndThePivotInItsPlace) {
  const auto run = simulate_text(test::small_program);
  show(run, StandardView::iso);
  const Vec3 pivot(20, 0, 0);
  const Pixel before = scene_.pixel_of(pivot);
  for (const Pixel& shift : {Pixel{30, 12}, Pixel{-80, 40}, Pixel{7, -300}, Pixel{500, 900}}) {
    scene_.orbit(shift, pivot);
    EXPECT_LT(distance(scene_.pixel_of(pivot), before), 1e-6);
    const double right = scene_.pixel_of({20, 0, 10})[0] - scene_.pixel_of({20, 0, 0})[0];
    EXPECT_NEAR(right, 0, 1e-6) << "Z does not lean";
  }
  EXPECT_LE(std::abs(scene_.camera().elevation), std::acos(0.0) + 1e-12) << "never over the top";
}

TEST_F(PathSceneTest, ZoomKeepsThePlaceUnderTheMouse) {
  const auto run = simulate_text(test::small_program);
  for (const bool perspective : {false, true}) {
    scene_.set_perspective(perspective);
    show(run, StandardView::top);
    const Pixel place = scene_.pixel_of({40, 15, 0});
    const double span = scene_.pixel_of({60, 15, 0})[0] - place[0];
    scene_.zoom(2, place);
    EXPECT_LT(distance(scene_.pixel_of({40, 15, 0}), place), 1e-6) << perspective;
    EXPECT_NEAR(scene_.pixel_of({60, 15, 0})[0] - place[0], 2 * span, 1e-6 * span) << perspective;
  }
}

TEST_F(PathSceneTest, ASessionBringsTheCameraBack) {
  const auto run = simulate_text(test::small_program);
  show(run, StandardView::iso);
  scene_.orbit({33, 21});
  scene_.zoom(3, {200, 250});
  const CameraState state = scene_.camera();
  EXPECT_FALSE(state.fitted);
  const Pixel place = scene_.pixel_of({40, 15, 0});
  scene_.set_perspective(true);
  scene_.set_standard_view(StandardView::back);
  EXPECT_GT(distance(scene_.pixel_of({40, 15, 0}), place), 5);
  scene_.set_camera(state);
  EXPECT_LT(distance(scene_.pixel_of({40, 15, 0}), place), 1e-6);
  // Another run of the program, with another frame about it, does not move the view.
  scene_.set_executed(simulate_text(test::small_program, "cam").trajectory);
  EXPECT_LT(distance(scene_.pixel_of({40, 15, 0}), place), 0.1);
}

TEST_F(PathSceneTest, TellsTheTimesOfWhatIsInView) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X100\nY50\nX0\n", "cam");
  show(run, StandardView::top);
  const auto all = scene_.visible_times();
  ASSERT_TRUE(all);
  EXPECT_EQ((*all)[0], 0);
  EXPECT_EQ((*all)[1], run.trajectory->duration());
  const auto half = scene_.times_within(scene_.pixel_of({80, -10, 0}), scene_.pixel_of({120, 20, 0}));
  ASSERT_TRUE(half);
  EXPECT_NEAR((*half)[0], run.trajectory->state_at_path(80).time, 1e-3);
  EXPECT_NEAR((*half)[1], run.trajectory->state_at_path(120).time, 1e-3);
  EXPECT_FALSE(scene_.times_within(scene_.pixel_of({40, 20, 0}), scene_.pixel_of({60, 30, 0})));
}

TEST_F(PathSceneTest, FitsTheRangeOfTheCharts) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X100\nY50\nX0\n", "cam");
  show(run, StandardView::top);
  const double from = run.trajectory->state_at_path(90).time;
  const double to = run.trajectory->state_at_path(110).time;
  scene_.fit_times(from, to);
  const auto seen = scene_.visible_times();
  ASSERT_TRUE(seen);
  EXPECT_LE((*seen)[0], from + 1e-9);
  EXPECT_GE((*seen)[1], to - 1e-9);
  EXPECT_LT((*seen)[1] - (*seen)[0], 2 * (to - from));
}

/// Wherever it is: a place of any shape, seen from any side.
TEST_F(PathSceneTest, APlaceThatIsLookedAtIsBesideTheLegend) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X100\nY50\nX0 Y0\nZ40\n", "cam");
  for (const StandardView view : {StandardView::top, StandardView::iso, StandardView::front}) {
    show(run, view);
    const double end = run.trajectory->duration();
    for (const auto& [from, to] : {std::pair(0.0, 1.0), std::pair(0.1, 0.3), std::pair(0.6, 0.62)}) {
      scene_.fit_times(from * end, to * end);
      for (int i = 0; i <= 20; ++i) {
        const Pixel at = scene_.pixel_of(scene_.drawn_at((from + (to - from) * i / 20) * end));
        for (const auto& [upper, lower] : scene_.covered()) {
          EXPECT_FALSE(at[0] > upper[0] && at[0] < lower[0] && at[1] > upper[1] && at[1] < lower[1])
              << from << " to " << to << ": " << at[0] << ", " << at[1];
        }
      }
    }
  }
}

TEST_F(PathSceneTest, FacesOfTheCubeAreViews) {
  scene_.set_cube(true);
  show(simulate_text(test::small_program), StandardView::iso);
  std::set<StandardView> found;
  for (int x = width - 80; x < width; x += 2) {
    for (int y = 0; y < 80; y += 2) {
      if (const auto view = scene_.cube_view({double(x), double(y)})) {
        found.insert(*view);
      }
    }
  }
  EXPECT_EQ(found, (std::set{StandardView::top, StandardView::front, StandardView::right}));
  EXPECT_FALSE(scene_.cube_view({100, 400}));
}

TEST_F(PathSceneTest, PicksExactlyWhereNothingOverlaps) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X20\nX40 Y15\nG3 X60 I10 J0\nG1 Y60\n");
  show(run, StandardView::top);
  for (int i = 1; i < 100; ++i) {
    const double time = run.trajectory->duration() * i / 100;
    const auto picked = scene_.pick_time(scene_.pixel_of(run.trajectory->state(time).position));
    ASSERT_TRUE(picked);
    EXPECT_NEAR(*picked, time, 1e-3 * run.trajectory->duration());
  }
}

TEST_F(PathSceneTest, PicksWithinEightPixelsAndNotBeyond) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X100\nY1\n");
  show(run, StandardView::top);
  const double time = run.trajectory->duration() / 2;
  Pixel pixel = scene_.pixel_of(run.trajectory->state(time).position);
  pixel[1] += 7;
  EXPECT_NEAR(scene_.pick_time(pixel).value_or(-1), time, 1e-3);
  pixel[1] += 2;
  EXPECT_FALSE(scene_.pick_time(pixel));
}

TEST_F(PathSceneTest, PicksThePassInFront) {
  const auto run = simulate_text(
      "G21 G90 G94 F3000\nG1 X100 F3000\nY10\nZ-20\nY0\nX0\n"
      "Y-30\n");
  show(run, StandardView::top);
  const auto picked = scene_.pick_time(scene_.pixel_of({50, 0, 0}));
  ASSERT_TRUE(picked);
  EXPECT_NEAR(run.trajectory->state(*picked).position.z(), 0, 1e-6) << "not the pass 20 mm below";
}

TEST_F(PathSceneTest, PicksNothingWithoutAnExecutedPath) {
  EXPECT_FALSE(scene_.pick_time({400, 300}));
  show(simulate_text("M30\n"), StandardView::iso);
  EXPECT_FALSE(scene_.pick_time({400, 300}));
}

TEST_F(PathSceneTest, EveryViewShowsTheWholePath) {
  for (const double size : {1e-3, 1.0, 300.0, 1e6}) {
    const std::string x = std::to_string(size);
    const std::string y = std::to_string(size / 3);
    const auto run = simulate_text("G21 G90 G94 F3000\nG1 X" + x + "\nY" + y + "\nX0 Z" + y + "\n", "cam");
    for (const StandardView view : views) {
      show(run, view);
      for (int i = 0; i <= 50; ++i) {
        const Pixel p = scene_.pixel_of(run.trajectory->state(run.trajectory->duration() * i / 50).position);
        EXPECT_TRUE(p[0] > 0 && p[0] < width && p[1] > 0 && p[1] < height)
            << size << " mm: " << p[0] << " " << p[1];
      }
    }
  }
}

/// However high above the part the tool goes in rapid traverse, the part is drawn as large.
TEST_F(PathSceneTest, RapidsFarAwayLeaveThePictureToWhatIsCut) {
  const auto size_at = [&](const std::string& above, StandardView view) {
    const auto run = simulate_text("G21 G90 G94 F3000\nG0 Z" + above +
                                   "\nG0 X10 Y10\nG0 Z2\nG1 Z0\nX50\nY40\nX10\nY10\nG0 Z" + above + "\n");
    show(run, view);
    return distance(scene_.pixel_of({10, 10, 0}), scene_.pixel_of({50, 40, 0}));
  };
  for (const StandardView view : {StandardView::iso, StandardView::top, StandardView::front}) {
    const double usual = size_at("20", view);
    EXPECT_GT(usual, 150);
    for (const char* above : {"60", "200", "2000"}) {
      EXPECT_GT(size_at(above, view), 0.6 * usual) << above << " mm above";
    }
  }
}

TEST_F(PathSceneTest, RapidsAreDrawnUnlessTheyAreHidden) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG0 Z30\nX50\nZ0\nG1 X0\nY50\n");
  const auto drawn_pixels = [&] {
    window_->Render();
    const auto shown = pixels();
    const auto first = shown->GetPointer(0);
    std::size_t count = 0;
    for (int i = 0; i < width * height; ++i) {
      count += std::equal(first + 4 * i, first + 4 * i + 3, first) ? 0 : 1;
    }
    return count;
  };
  show(run, StandardView::front);
  EXPECT_TRUE(scene_.rapids_shown());
  const std::size_t with = drawn_pixels();
  scene_.set_rapids_shown(false);
  const std::size_t without = drawn_pixels();
  EXPECT_LT(without + 100, with);
  scene_.set_rapids_shown(true);
  EXPECT_EQ(drawn_pixels(), with);
}

TEST_F(PathSceneTest, StandardViewsLookAlongTheAxes) {
  const auto run = simulate_text(test::small_program);
  const auto moves = [&](const Vec3& step) {
    const Pixel from = scene_.pixel_of({10, 10, 0});
    const Pixel to = scene_.pixel_of(Vec3(10, 10, 0) + step);
    return std::pair(to[0] - from[0], from[1] - to[1]);  // right, up
  };
  const auto expect = [&](const Vec3& step, double right, double up) {
    const auto [x, y] = moves(step);
    EXPECT_NEAR(x / std::hypot(x, y), right, 1e-9);
    EXPECT_NEAR(y / std::hypot(x, y), up, 1e-9);
  };
  show(run, StandardView::top);
  expect(Vec3::UnitX(), 1, 0);
  expect(Vec3::UnitY(), 0, 1);
  show(run, StandardView::front);
  expect(Vec3::UnitX(), 1, 0);
  expect(Vec3::UnitZ(), 0, 1);
  show(run, StandardView::right);
  expect(Vec3::UnitY(), 1, 0);
  expect(Vec3::UnitZ(), 0, 1);
  show(run, StandardView::iso);
  expect(Vec3::UnitZ(), 0, 1);
  expect(Vec3::UnitX(), std::sqrt(0.75), -0.5);
  expect(Vec3::UnitY(), std::sqrt(0.75), 0.5);
}

TEST_F(PathSceneTest, FollowsTheWindowsSizeUntilItIsMovedByHand) {
  const auto run = simulate_text(test::small_program);
  show(run, StandardView::top);
  const double before = scene_.pixel_of({60, 60, 0})[0] - scene_.pixel_of({0, 60, 0})[0];
  window_->SetSize(2 * width, 2 * height);
  window_->Render();
  const double after = scene_.pixel_of({60, 60, 0})[0] - scene_.pixel_of({0, 60, 0})[0];
  EXPECT_GT(after, 1.8 * before);
}

TEST_F(PathSceneTest, TellsOfEveryChange) {
  int changes = 0;
  scene_.on_change([&] { ++changes; });
  const auto run = simulate_text(test::small_program);
  const auto expect_change = [&](const char* what) {
    EXPECT_GE(changes, 1) << what;
    changes = 0;
  };
  scene_.set_programmed(run.path.toolpath);
  expect_change("programmed");
  scene_.set_executed(run.trajectory);
  expect_change("executed");
  scene_.set_executed(run.trajectory, std::make_shared<const SampledPath>(sample_executed(run.trajectory)));
  expect_change("executed with samples");
  scene_.set_cursor(Vec3(1, 2, 3));
  expect_change("cursor");
  scene_.set_standard_view(StandardView::front);
  expect_change("view");
  scene_.set_colouring(Colouring::jerk);
  expect_change("colouring");
  scene_.set_exaggeration(10);
  expect_change("exaggeration");
  scene_.set_tool({ToolKind::ball, 6, 0});
  expect_change("tool");
  scene_.set_background(Background::dark);
  expect_change("background");
  scene_.set_perspective(true);
  expect_change("perspective");
  scene_.set_highlight(std::array{0.1, 0.2});
  expect_change("highlight");
  scene_.set_executed(nullptr);
  expect_change("taken away");
}

/// Of the last frame.
std::vector<unsigned char> pixels_of(vtkGenericOpenGLRenderWindow& window, int width, int height) {
  window.Render();
  const vtkNew<vtkUnsignedCharArray> pixels;
  window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
  return {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()};
}

/// It is wider than the path and follows it in depth: of passes one behind another it would cover now this
/// one, now that.
TEST_F(PathSceneTest, AMarkedRangeNeverCoversThePath) {
  std::string passes = "G21 G90 G94 F3000\n";
  for (int i = 0; i < 12; ++i) {  // seen from the corner they lie close above each other and far behind
    passes += "G1 Y" + std::to_string(5 * i) + " Z" + std::to_string(-2 * i) + "\nX" +
              std::to_string(i % 2 == 0 ? 60 : 0) + "\n";
  }
  const auto run = simulate_text(passes);
  show(run, StandardView::iso);
  scene_.set_colouring(Colouring::run);
  scene_.set_run_colour({0, 0.8, 0});
  const auto is_path = [](const unsigned char* pixel) {
    return pixel[1] > 150 && pixel[0] < 100 && pixel[2] < 100;
  };
  std::size_t covered = 0;
  std::size_t underlaid = 0;
  std::size_t path = 0;
  for (int view = 0; view < 12; ++view) {
    scene_.orbit({3.0, 1.0});
    scene_.set_highlight(std::nullopt);
    const auto without = pixels_of(*window_, width, height);
    scene_.set_highlight(std::array{0.0, run.trajectory->duration()});
    const auto with = pixels_of(*window_, width, height);
    for (std::size_t i = 0; i < without.size(); i += 4) {
      const bool was = is_path(&without[i]);
      path += was ? 1 : 0;
      covered += was && !is_path(&with[i]) ? 1 : 0;
      underlaid += !was && !std::equal(&without[i], &without[i] + 3, &with[i]) ? 1 : 0;
    }
  }
  EXPECT_GT(path, 10000U);
  EXPECT_GT(underlaid, path / 4) << "it is to be seen";
  EXPECT_LT(1000 * covered, path) << "but for the mixed colours of edges";
}

/// A part of 20 um with its lower left corner at a place, to which the tool comes from the zero point.
std::string small_part_at(const Vec3& place) {
  const auto at = [&](double x, double y) {
    return fmt::format(" X{:.3f} Y{:.3f}", place.x() + x, place.y() + y);
  };
  return fmt::format("G21 G90 G94 F600\nG0{0} Z0.02\nG1 Z0\nG1{1}\n{2}\nG3{3} I-0.01 J0\nG1{0}\nG0 Z0.02\n",
                     at(0, 0), at(0.02, 0), at(0.02, 0.01), at(0.01, 0.02));
}

/// Far from the zero point pictures are those of a part near it, but for the numbers at the axes.
class FarPartTest : public PathSceneTest {
 protected:
  FarPartTest() {
    scene_.set_colouring(Colouring::run);
    scene_.set_run_colour({0, 0.8, 0});
    scene_.set_rapids_shown(false);
  }

  static bool is_path(const unsigned char* pixel) { return pixel[1] > pixel[0] + 40; }
  static inline const Vec3 near_place{16, 12, 0};
  static inline const std::array far_places{Vec3(8000, 6000, 0), Vec3(500'000, 420'000, 0),
                                            Vec3(500'000, 4'200'000, 0)};
};

TEST_F(FarPartTest, IsDrawnAsNearTheZeroPoint) {
  const auto near = simulate_text(small_part_at(near_place));
  for (const Vec3& place : far_places) {
    const auto far = simulate_text(small_part_at(place));
    for (const bool perspective : {false, true}) {
      for (const StandardView view : {StandardView::iso, StandardView::top, StandardView::front}) {
        scene_.set_perspective(perspective);
        show(far, view);
        CameraState camera = scene_.camera();
        const auto drawn = pixels_of(*window_, width, height);
        camera.fitted = false;
        camera.focal += near_place - place;
        show(near, view);
        scene_.set_camera(camera);
        const auto wanted = pixels_of(*window_, width, height);
        std::size_t path = 0;
        std::size_t other = 0;
        for (std::size_t i = 0; i < drawn.size(); i += 4) {
          const bool shown = is_path(&wanted[i]) || is_path(&drawn[i]);
          path += shown ? 1 : 0;
          other += shown && std::abs(wanted[i + 1] - drawn[i + 1]) > 16 ? 1 : 0;
        }
        EXPECT_GT(path, 1500U) << place.transpose();
        EXPECT_LE(50 * other, path) << "but for edges; " << place.transpose() << ", view "
                                    << static_cast<int>(view);
      }
    }
  }
}

TEST_F(FarPartTest, IsPickedWhereItIsDrawnAndAtItsPlaces) {
  for (const Vec3& place : far_places) {
    const auto run = simulate_text(small_part_at(place));
    show(run, StandardView::iso);
    const auto drawn = pixels_of(*window_, width, height);
    const double pixel_mm = scene_.camera().height / height;
    const double begin = run.trajectory->state_at_path(place.norm() + 0.03).time;
    for (int i = 0; i <= 100; ++i) {
      const double time = begin + (run.trajectory->duration() - begin) * i / 100;
      const State state = run.trajectory->state(time);
      const Vec3 position = state.position;
      if (run.trajectory->is_rapid(state.element)) {
        break;
      }
      const Pixel pixel = scene_.pixel_of(position);
      const auto x = static_cast<std::size_t>(pixel[0]);
      const auto y = static_cast<std::size_t>(height - pixel[1]);
      EXPECT_TRUE(is_path(&drawn[4 * (y * width + x)])) << place.transpose() << " at " << time << " s";
      const auto picked = scene_.pick_time(pixel);
      ASSERT_TRUE(picked);
      EXPECT_LT((run.trajectory->state(*picked).position - position).norm(), 4 * pixel_mm) << time;
    }
  }
}

TEST_F(PathSceneTest, ColoursAreExplainedInEveryHeight) {
  scene_.set_cube(true);
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X40\nY40\nX80\n");
  for (int low = 130; low <= 600; low += 47) {
    window_->SetSize(width, low);
    show(run, StandardView::iso);
    const auto pixels = pixels_of(*window_, width, low);
    const Rgb top = scale_colour(ColourScale{}, 0.99, Background::light);
    std::size_t found = 0;
    for (int y = 0; y < 60; ++y) {  // from below
      for (int x = 0; x < 260; ++x) {
        const unsigned char* pixel = &pixels[4 * static_cast<std::size_t>(y * width + x)];
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c) {
          same = same && std::abs(pixel[c] - 255 * top[c]) < 12;
        }
        found += same ? 1 : 0;
      }
    }
    EXPECT_GE(found, 8U) << "height " << low;
    EXPECT_EQ(scene_.cube_view({width - 38.0, 38.0}).has_value(), low > 168) << "height " << low;
  }
}

/// The largest size, as a share of its present one, that the box of the path has in a rectangle that nothing
/// covers: by all rectangles between edges of the window and of what covers it.
double largest_in_free_rectangle(const PathScene& scene, const Pixel& box, int width, int height) {
  const auto covered = scene.covered();
  std::vector<double> x{0, double(width)};
  std::vector<double> y{0, double(height)};
  for (const auto& [upper, lower] : covered) {
    x.insert(x.end(), {upper[0], lower[0]});
    y.insert(y.end(), {upper[1], lower[1]});
  }
  double best = 0;
  for (const double left : x) {
    for (const double right : x) {
      for (const double top : y) {
        for (const double bottom : y) {
          bool free = left < right && top < bottom;
          for (const auto& [upper, lower] : covered) {
            free = free && !(upper[0] < right && left < lower[0] && upper[1] < bottom && top < lower[1]);
          }
          if (free) {
            best = std::max(best, std::min((right - left) / box[0], (bottom - top) / box[1]));
          }
        }
      }
    }
  }
  return best;
}

/// Data first: after a fit the path reaches within 6 % of the free part of the picture in one direction.
TEST_F(PathSceneTest, AFittedPathFillsWhatItsOverlaysLeave) {
  const auto run = simulate_text(
      "G21 G90 G94 F3000\nG1 X60\nG3 X60 Y40 I0 J20\nG1 X0 Z-8\nG2 X-10 Y20 I5 J-18\nG1 X0 Y0 Z0\n");
  struct Size {
    int width, height;
  };
  for (const Size size : {Size{160, 120}, {320, 400}, {764, 456}, {1280, 800}, {700, 1400}, {3840, 2160}}) {
    window_->SetSize(size.width, size.height);
    const double scale = std::clamp(size.height / 800.0, 0.7, 2.7);
    scene_.set_scale(scale);
    scene_.set_cube(size.width == 764);
    for (const StandardView view : views) {
      for (const bool perspective : {false, true}) {
        if (perspective && view == StandardView::left && size.width == 3840) {
          continue;  // the eye would come between the ends of the path, whose lines are not straight there
        }
        scene_.set_perspective(perspective);
        show(run, view);
        Pixel low{1e9, 1e9};
        Pixel high{-1e9, -1e9};
        for (int i = 0; i <= 400; ++i) {
          const Pixel p =
              scene_.pixel_of(run.trajectory->state(run.trajectory->duration() * i / 400).position);
          for (const std::size_t axis : {0, 1}) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
          }
          EXPECT_TRUE(p[0] > 0 && p[0] < size.width && p[1] > 0 && p[1] < size.height) << size.width;
          const double line = 3 * scale;  // [pixels] the outline of an arc has a point every 3 degrees
          for (const auto& [upper, lower] : scene_.covered()) {
            EXPECT_FALSE(p[0] > upper[0] + line && p[0] < lower[0] - line && p[1] > upper[1] + line &&
                         p[1] < lower[1] - line)
                << size.width << "x" << size.height << ", view " << int(view) << ": under a text";
          }
        }
        const Pixel box{high[0] - low[0], high[1] - low[1]};
        EXPECT_LE(largest_in_free_rectangle(scene_, box, size.width, size.height), 1 / 0.94)
            << size.width << "x" << size.height << ", view " << int(view)
            << (perspective ? " perspective" : "");
      }
    }
  }
}

/// Seen from the right, front and top, what is long in X goes down to the right, what is long in Y up.
TEST_F(PathSceneTest, AnInsetLiesWhereItLeavesMoreToThePath) {
  constexpr double side = 180;
  window_->SetSize(768, 469);
  scene_.set_inset(side);
  const auto place = [&](const char* program) {
    show(simulate_text(program), StandardView::iso);
    const auto [upper, lower] = *scene_.inset();
    EXPECT_NEAR(lower[0] - upper[0], side, 1e-9);
    EXPECT_NEAR(lower[1] - upper[1], side, 1e-9);
    for (const auto& [from, to] : scene_.covered()) {
      const bool itself = from == upper && to == lower;
      EXPECT_TRUE(itself || from[0] >= lower[0] || to[0] <= upper[0] || from[1] >= lower[1] ||
                  to[1] <= upper[1])
          << program;
    }
    return upper;
  };
  EXPECT_LT(place("G21 G90 G94 F3000\nG1 X80\nY20\nX0\nY0\n")[0], 20);
  EXPECT_GT(place("G21 G90 G94 F3000\nG1 Y80\nX20\nY0\nX0\n")[0], 768 - side - 20);
  scene_.set_colouring(Colouring::cause);  // its names take the width of the picture
  EXPECT_LT(place("G21 G90 G94 F3000\nG1 X80\nY20\nX0\nY0\n")[1], 469 - side - 20);
  scene_.set_inset(std::nullopt);
  EXPECT_FALSE(scene_.inset());
}

/// Drawn at four times the size, everything is where it was.
TEST_F(PathSceneTest, ALargerPictureHasTheSameComposition) {
  const auto run = simulate_text(test::small_program);
  std::vector<Pixel> places;
  for (const int enlarged : {1, 2}) {
    window_->SetSize(1920 * enlarged, 1080 * enlarged);
    scene_.set_scale(1.35 * enlarged);
    show(run, StandardView::iso);
    std::size_t next = 0;
    const auto compare = [&](const Pixel& place) {
      if (enlarged == 1) {
        places.push_back(place);
      } else {
        ASSERT_LT(next, places.size());
        EXPECT_NEAR(places[next][0], place[0] / 2, 6) << next;
        EXPECT_NEAR(places[next][1], place[1] / 2, 6) << next;
        ++next;
      }
    };
    for (const auto& [upper, lower] : scene_.covered()) {
      compare(upper);
      compare(lower);
    }
    for (int i = 0; i <= 10; ++i) {
      compare(scene_.pixel_of(run.trajectory->state(run.trajectory->duration() * i / 10).position));
    }
  }
}

/// Between neighbouring passes, as in a finishing with a rapid back after each of many.
TEST_F(PathSceneTest, RapidsThatCoverThePictureAreHidden) {
  std::string text = "G21 G90 G94 F3000\n";
  for (int i = 0; i < 400; ++i) {
    text += fmt::format("G0 X0 Y{0}\nG1 X50\n", 0.1 * i);
  }
  const auto run = simulate_text(text, "cam");
  const auto dots = [&] {
    window_->Render();
    const auto shown = pixels();
    std::size_t count = 0;
    for (int i = 0; i < width * height; ++i) {
      count += shown->GetPointer(4 * i)[0] < 240 ? 1 : 0;
    }
    return count;
  };
  scene_.set_colouring(Colouring::feed);
  show(run, StandardView::top);
  const std::size_t usual = dots();
  scene_.set_rapids_shown(false);
  EXPECT_EQ(dots(), usual) << "they are hidden anyway";
  scene_.set_rapids_shown(true);
  scene_.set_all_rapids_shown(true);
  EXPECT_NE(dots(), usual);
  scene_.set_all_rapids_shown(false);
  scene_.zoom(40, {400, 300});
  const std::size_t near = dots();
  scene_.set_rapids_shown(false);
  EXPECT_NE(dots(), near) << "close up they are few";
}

}  // namespace
}  // namespace feedscope::ui
