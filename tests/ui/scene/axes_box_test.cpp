#include "ui/scene/draw/axes_box.h"

#include <gmock/gmock.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "ui/scene/camera/scene_camera.h"

namespace feedscope::ui {
namespace {

constexpr std::array views{StandardView::iso, StandardView::top, StandardView::front, StandardView::right};

/// The corners of a label as it is drawn.
std::array<Vec2, 4> corners(const AxesLayout::Label& label) {
  const Vec2 half = Canvas::text_size(label.text, label.style) / 2;
  const Vec2 along(std::cos(label.style.angle), std::sin(label.style.angle));
  const Vec2 across(-along.y(), along.x());
  const Vec2 centre = label.place - Vec2(label.style.horizontal * half.x(), label.style.vertical * half.y());
  return {centre - half.x() * along - half.y() * across, centre + half.x() * along - half.y() * across,
          centre + half.x() * along + half.y() * across, centre - half.x() * along + half.y() * across};
}

/// Separating axes of two rectangles.
bool overlap(const std::array<Vec2, 4>& a, const std::array<Vec2, 4>& b) {
  for (const auto& shape : {a, b}) {
    for (const Vec2& axis : {Vec2(shape[1] - shape[0]), Vec2(shape[3] - shape[0])}) {
      const auto range = [&](const std::array<Vec2, 4>& points) {
        double low = points[0].dot(axis);
        double high = low;
        for (const Vec2& p : points) {
          low = std::min(low, p.dot(axis));
          high = std::max(high, p.dot(axis));
        }
        return std::pair(low, high);
      };
      const auto [low_a, high_a] = range(a);
      const auto [low_b, high_b] = range(b);
      if (high_a <= low_b || high_b <= low_a) {
        return false;
      }
    }
  }
  return true;
}

struct Fitted {
  SceneFrame frame;
  AxesLayout axes;
  ScreenRectangle room;
};

Fitted fit(const Bounds& content, StandardView view, int width, int height) {
  const vtkNew<vtkCamera> vtk_camera;
  SceneCamera camera(*vtk_camera);
  camera.look(view);
  Fitted result{frame_around(content), {}, {Vec2(10, 10), Vec2(width - 120, height - 40)}};
  camera.fit(width, height, result.room, {},
             [&](const Projection& projection) { return lay_out_axes(result.frame, projection, 1).outline; });
  result.axes = lay_out_axes(result.frame, camera.projection(width, height), 1);
  return result;
}

Bounds box(const Vec3& low, const Vec3& high) {
  Bounds bounds;
  bounds.add(low);
  bounds.add(high);
  return bounds;
}

std::vector<std::string> texts(const AxesLayout& axes) {
  std::vector<std::string> list;
  for (const auto& label : axes.labels) {
    list.push_back(label.text);
  }
  return list;
}

TEST(AxesBox, LabelsKeepApartAndInsideTheWindowForAnyBox) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-4, 6);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int i = 0; i < 150; ++i) {
    const double size = std::pow(10, exponent(random));
    const Vec3 low = Vec3(place(random), place(random), place(random)) * size;
    const Vec3 extent =
        Vec3(std::abs(place(random)), std::abs(place(random)), i % 3 == 0 ? 0 : std::abs(place(random)));
    const Bounds content = box(low, low + extent * size);
    const int width = 500 + 37 * (i % 40);
    const int height = 400 + 23 * (i % 40);
    for (const StandardView view : views) {
      const Fitted f = fit(content, view, width, height);
      for (std::size_t a = 0; a < f.axes.labels.size(); ++a) {
        const auto corners_a = corners(f.axes.labels[a]);
        for (const Vec2& corner : corners_a) {
          EXPECT_TRUE((corner.array() >= f.room.low.array() - 3).all() &&
                      (corner.array() <= f.room.high.array() + 3).all())
              << "case " << i << ", label " << f.axes.labels[a].text << " at " << corner.transpose();
        }
        for (std::size_t b = 0; b < a; ++b) {
          EXPECT_FALSE(overlap(corners_a, corners(f.axes.labels[b])))
              << "case " << i << ", labels " << f.axes.labels[a].text << " and " << f.axes.labels[b].text;
        }
      }
    }
  }
}

TEST(AxesBox, NamesTheAxesWithTheirUnit) {
  const Fitted f = fit(box({0, 0, 0}, {100, 50, 20}), StandardView::iso, 800, 600);
  EXPECT_THAT(texts(f.axes), testing::IsSupersetOf({"X (mm)", "Y (mm)", "Z (mm)", "0", "100"}));
}

TEST(AxesBox, AnAxisSeenEndOnHasNoLabels) {
  const Fitted f = fit(box({0, 0, 0}, {100, 50, 20}), StandardView::top, 800, 600);
  EXPECT_THAT(texts(f.axes), testing::IsSupersetOf({"X (mm)", "Y (mm)"}));
  EXPECT_THAT(texts(f.axes), testing::Not(testing::Contains("Z (mm)")));
}

TEST(AxesBox, AFlatPathHasNoThirdAxis) {
  const Fitted f = fit(box({0, 0, 3}, {100, 50, 3}), StandardView::iso, 800, 600);
  EXPECT_THAT(texts(f.axes), testing::Not(testing::Contains("Z (mm)")));
  EXPECT_FALSE(f.axes.grid.empty());
}

TEST(AxesBox, FillsTheRoomItIsGiven) {
  for (const StandardView view : views) {
    const Fitted f = fit(box({0, 0, 0}, {100, 80, 60}), view, 900, 700);
    Vec2 low = f.axes.outline.front();
    Vec2 high = low;
    for (const Vec2& point : f.axes.outline) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const Vec2 used = (high - low).cwiseQuotient(f.room.size());
    EXPECT_GT(used.maxCoeff(), 0.97);
    EXPECT_LE(used.maxCoeff(), 1.01);
  }
}

/// What is drawn is bounded by the window's size whatever the camera sees, and lies in or around the window.
TEST(AxesBox, StaysSmallForEveryCamera) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t max_strokes = 0;
  std::size_t gridded = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 low(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
    const Bounds content =
        box(1e3 * low, 1e3 * low + std::pow(10, 8 * unit(random) - 4) *
                                       Vec3(unit(random), unit(random), i % 3 == 0 ? 0 : unit(random)));
    const SceneFrame frame = frame_around(content);
    const int width = 200 + static_cast<int>(3000 * unit(random));
    const int height = 200 + static_cast<int>(2000 * unit(random));
    const vtkNew<vtkCamera> vtk_camera;
    SceneCamera camera(*vtk_camera);
    camera.look(views[static_cast<std::size_t>(i) % views.size()]);
    camera.set_perspective(i % 4 == 0);
    camera.orbit(unit(random), unit(random), Vec3::Zero());
    for (int click = 0; click < static_cast<int>(90 * unit(random)); ++click) {
      camera.zoom(1.2, Vec2(width * unit(random), height * unit(random)), width, height);
    }
    const Projection view = camera.projection(width, height);
    const AxesLayout axes = lay_out_axes(frame, view, 1);
    const double across = 3 * std::hypot(width, height);  // window and margins, from corner to corner
    const bool is_parallel = !view.perspective();
    const double most = is_parallel ? across / 30 + 8 : 1001;
    EXPECT_LE(axes.labels.size(), 3 * most) << "case " << i;
    const int faces = is_parallel ? 3 : 6;  // between two sides in perspective, both are seen from inside
    EXPECT_LE(static_cast<double>(axes.grid.size()), 2 * faces * most) << "case " << i;
    EXPECT_LE(axes.frame.size(), 3 * most + 12) << "case " << i;
    for (const auto* strokes : {&axes.grid, &axes.frame}) {
      for (const auto& stroke : *strokes) {
        for (const Vec2& end : {stroke.from, stroke.to}) {
          EXPECT_LE((end - view.middle).cwiseAbs().maxCoeff(), 1.51 * std::max(width, height) + 10)
              << "case " << i;
        }
      }
    }
    max_strokes = std::max(max_strokes, axes.grid.size());
    gridded += axes.grid.empty() ? 0 : 1;
  }
  EXPECT_GT(max_strokes, 50U);
  EXPECT_GT(gridded, 1000U) << "close up there is still a grid";
}

TEST(AxesBox, TicksStandWhereTheirNumbersAre) {
  for (const bool perspective : {false, true}) {
    const vtkNew<vtkCamera> vtk_camera;
    SceneCamera camera(*vtk_camera);
    camera.look(StandardView::iso);
    camera.set_perspective(perspective);
    const SceneFrame frame = frame_around(box({0, 0, 0}, {100, 60, 30}));
    const Projection view = camera.projection(900, 700);
    const AxesLayout axes = lay_out_axes(frame, view, 1);
    for (const auto& label : axes.labels) {
      if (label.text.find('(') != std::string::npos) {
        continue;
      }
      const double value = std::stod(label.text);
      double nearest = 1e9;  // of a point with that coordinate on one of the edges
      for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
          Vec3 p;
          p[axis] = (value - frame.centre[axis]) / frame.unit;
          p[(axis + 1) % 3] = (corner % 2 == 0 ? frame.box.min : frame.box.max)[(axis + 1) % 3];
          p[(axis + 2) % 3] = (corner < 2 ? frame.box.min : frame.box.max)[(axis + 2) % 3];
          nearest = std::min(nearest, std::abs((label.place - view.to_display(p)).norm() - 9));
        }
      }
      EXPECT_LT(nearest, 0.01) << label.text;
    }
  }
}

TEST(SceneFrame, MakesTheLargestExtentOneAndPutsItsCentreInTheMiddle) {
  const SceneFrame frame = frame_around(box({1000, 0, -2}, {1400, 100, 2}));
  EXPECT_EQ(frame.unit, 400);
  EXPECT_LT((frame.to_scene(Vec3(1200, 50, 0))).norm(), 1e-12);
  EXPECT_NEAR(frame.to_scene(Vec3(1400, 50, 0)).x(), 0.5, 1e-12);
  EXPECT_NEAR(frame.to_mm(0, 0.5), 1400, 1e-9);
}

TEST(SceneFrame, OfAPointOrNothingIsAPlaneAroundIt) {
  for (const Bounds& content : {Bounds{}, box({7, 8, 9}, {7, 8, 9})}) {
    const SceneFrame frame = frame_around(content);
    EXPECT_EQ(frame.unit, 100);
    EXPECT_GT(frame.box.max.x(), frame.box.min.x());
    EXPECT_GT(frame.box.max.y(), frame.box.min.y());
    EXPECT_EQ(frame.box.max.z(), frame.box.min.z());
  }
}

}  // namespace
}  // namespace feedscope::ui
