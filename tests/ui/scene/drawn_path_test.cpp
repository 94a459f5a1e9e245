#include "ui/scene/path/drawn_path.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

namespace feedscope::ui {
namespace {

constexpr int width = 900;
constexpr int height = 700;

/// A random walk in a box of 100 mm; now and then a long span crosses it.
std::shared_ptr<const SampledPath> walk(std::mt19937& random, std::size_t points) {
  auto path = std::make_shared<SampledPath>();
  path->origin = {1000, -50, 3};
  std::normal_distribution<float> step(0, 0.05F);
  std::uniform_real_distribution<float> anywhere(-50, 50);
  Eigen::Vector3f here(0, 0, 0);
  for (std::size_t i = 0; i < points; ++i) {
    const bool jump = i % 5000 == 0;
    for (int axis = 0; axis < 3; ++axis) {
      here[axis] = jump ? anywhere(random) : std::clamp(here[axis] + step(random), -50.F, 50.F);
    }
    path->positions.push_back(here);
    path->bounds.add(path->origin + here.cast<double>());
  }
  path->kinds.assign(points, SpanKind::cut);
  path->levels = levels_of(*path);
  path->boxes = boxes_of(path->positions);
  return path;
}

class DrawnPathTest : public testing::TestWithParam<bool> {
 protected:
  /// Looks at a random point of the path from a random side; `extent`: of what is seen [of the path's].
  Projection view(const SampledPath& path, double extent) {
    std::normal_distribution<double> normal;
    const std::size_t at = std::uniform_int_distribution<std::size_t>(0, path.size() - 1)(random);
    const Vec3 focal = frame.to_scene(path.position(at));
    const Vec3 from = Vec3(normal(random), normal(random), normal(random)).normalized() * 2;
    const vtkNew<vtkCamera> camera;
    camera->SetFocalPoint(focal.data());
    camera->SetPosition(Vec3(focal + from).data());
    camera->SetViewUp(normal(random), normal(random), normal(random));
    camera->SetParallelScale(extent / 2);
    camera->SetParallelProjection(GetParam() ? 0 : 1);
    return {*camera, width, height};
  }
  bool in_window(const Vec3& position, const Projection& projection) const {
    const Vec2 pixel = projection.to_display(frame.to_scene(position));
    return pixel.x() >= 0 && pixel.x() <= width && pixel.y() >= 0 && pixel.y() <= height;
  }
  /// Whether the span from a point of the path to the next reaches into the window, for each point: by points
  /// along it.
  std::vector<bool> seen(const SampledPath& path, const Projection& projection) const {
    std::vector<bool> spans(path.size());
    bool before = in_window(path.position(0), projection);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const bool next = in_window(path.position(i + 1), projection);
      const Vec3 middle = 0.5 * (path.position(i) + path.position(i + 1));
      spans[i] = before || next || in_window(middle, projection);
      before = next;
    }
    return spans;
  }

  std::mt19937 random{7};
  SceneFrame frame;
};

TEST_P(DrawnPathTest, DrawsEverySpanThatReachesIntoTheViewAndNotMuchMore) {
  const auto samples = walk(random, 150'000);
  ASSERT_GT(samples->levels.size(), 1U);
  frame = frame_around(samples->bounds);
  DrawnPath path(samples);
  for (const double extent : {1.0, 0.1, 0.01, 0.001}) {
    for (int i = 0; i < 3; ++i) {
      const Projection projection = view(*samples, extent);
      path.show(0, frame, projection);
      const PathPart& part = *path.part(0);
      std::vector<bool> drawn(samples->size());
      for (std::size_t k = 0; k < part.size(); ++k) {
        if (part.joined(k)) {
          ASSERT_EQ(part[k + 1], part[k] + 1) << "a line that is not of the path";
          drawn[part[k]] = true;
        }
      }
      const std::vector<bool> wanted = seen(*samples, projection);
      EXPECT_TRUE(std::ranges::find(wanted, true) != wanted.end());
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        ASSERT_TRUE(drawn[k] || !wanted[k]) << "span " << k << " at extent " << extent;
      }
      if (extent < 0.05 && !GetParam()) {
        EXPECT_LT(part.size(), samples->size() / 10);
      }
      EXPECT_FALSE(path.show(0, frame, projection)) << "made again for the same view";
    }
  }
}

TEST_P(DrawnPathTest, DrawsCoarseLevelsWhole) {
  const auto samples = walk(random, 150'000);
  frame = frame_around(samples->bounds);
  DrawnPath path(samples);
  const std::size_t coarsest = samples->levels.size() - 1;
  EXPECT_TRUE(path.show(coarsest, frame, view(*samples, 0.001)));
  EXPECT_EQ(path.part(coarsest)->size(), samples->levels[coarsest].size());
  EXPECT_FALSE(path.show(coarsest, frame, view(*samples, 0.01)));
}

INSTANTIATE_TEST_SUITE_P(Projections, DrawnPathTest, testing::Bool(), [](const auto& projection) {
  return projection.param ? "Perspective" : "Parallel";
});

}  // namespace
}  // namespace feedscope::ui
