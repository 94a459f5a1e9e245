#include "core/analysis/contour/path_deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/brute_force.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using testing::append_arc;
using testing::polyline;
using testing::random_path;

TEST(PathDeviation, OfNoPathIsNone) {
  const Toolpath nothing;
  EXPECT_EQ(PathDeviation(nothing)({1, 2, 3}, 0).nearest, Vec3::Zero());
}

TEST(PathDeviation, IsTheWayFromALine) {
  const Toolpath path = polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 10);
  PathDeviation deviation(path);
  EXPECT_LT((deviation({4, 0.5, -1}, 0).nearest - Vec3(0, 0.5, -1)).norm(), 1e-12);
  EXPECT_LT((deviation({9.7, 0.3, 0}, 0).nearest - Vec3(0, 0.3, 0)).norm(), 1e-12) << "on the bisector";
  EXPECT_LT((deviation({9.8, 4, 0}, 1).nearest - Vec3(-0.2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((deviation({10, 12, 0}, 1).nearest - Vec3(0, 2, 0)).norm(), 1e-12) << "beyond the end";
}

TEST(PathDeviation, IsTheWayFromACircle) {
  Toolpath path;
  path.start = Vec3(5, 0, 0);
  append_arc(path, Vec3::Zero(), 4.5, 10);
  PathDeviation deviation(path);
  for (double angle = 0; angle < 4.5; angle += 0.1) {
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    EXPECT_LT((deviation(5.25 * out, 0).nearest - 0.25 * out).norm(), 1e-12) << angle;
  }
}

TEST(PathDeviation, IsTheShortestWayFromAHelix) {
  Arc helix;
  helix.center = Vec3::Zero();
  helix.x = Vec3::UnitX();
  helix.y = Vec3::UnitY();
  helix.rise = Vec3(0, 0, 0.8);
  helix.radius = 5;
  helix.sweep = 30;
  Toolpath path;
  path.start = helix.at(0).position;
  path.arcs = {helix};
  Segment segment;
  segment.end = helix.at(helix.length()).position;
  segment.length = helix.length();
  segment.kind = SegmentKind::arc;
  segment.index = 0;
  path.segments = {segment};
  PathDeviation deviation(path);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> aside(-0.4, 0.4);
  for (double s = 1; s < helix.length() - 1; s += 0.9) {
    const Vec3 place = helix.at(s).position + Vec3(aside(random), aside(random), aside(random));
    const Vec3 offset = deviation(place, 0).nearest;
    double least = 1e9;
    for (double t = s - 1; t < s + 1; t += 1e-3) {
      least = std::min(least, (place - helix.at(t).position).norm());
    }
    EXPECT_LE(offset.norm(), least + 1e-9) << s;
    EXPECT_GE(offset.norm(), least - 1e-5) << s;
  }
}

TEST(PathDeviation, InACornerKeepsOneDirectionOnTheWayThroughIt) {
  const Toolpath path = polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 10);
  PathDeviation deviation(path);
  const Vec3 inwards = Vec3(-1, 1, 0).normalized();
  // Offset by 0.3 from one leg and then the other, in between both.
  for (const Vec3& place : {Vec3(8, 0.3, 0), Vec3(9.7, 0.3, 0), Vec3(9.7, 0.4, 0), Vec3(9.7, 3, 0)}) {
    const auto result = deviation(place, 0);
    EXPECT_LT((result.along_bisector - 0.3 * std::sqrt(2.0) * inwards).norm(), 1e-12) << place.transpose();
    // Taken back along it, the place is on the path.
    const Vec3 base = place - result.along_bisector;
    EXPECT_NEAR(std::min(std::abs(base.y()), std::abs(base.x() - 10)), 0, 1e-12);
  }
}

TEST(PathDeviation, AtAReversalIsHowFarTheCornerIsMissed) {
  const Toolpath path = polyline({{0, 0, 0}, {10, 0, 0}, {0, 0, 0}}, 10);
  PathDeviation deviation(path);
  for (double x = 0; x < 9.9; x += 0.1) {
    EXPECT_LT((deviation({x, 0.01, 0}, 0).nearest - Vec3(0, 0.01, 0)).norm(), 1e-12) << x;
  }
  for (double x = 9.9; x > 0; x -= 0.1) {
    EXPECT_LT((deviation({x, 0.01, 0}, 1).nearest - Vec3(0, 0.01, 0)).norm(), 1e-12) << x;
  }
}

TEST(PathDeviation, IsTheWayFromTheNearestPass) {
  const Toolpath path = polyline({{0, 0, 0}, {100, 0, 0}, {100, 0.2, 0}, {0, 0.2, 0}}, 10);
  PathDeviation deviation(path);
  for (int x = 1; x < 90; ++x) {
    EXPECT_LT((deviation({double(x), 0.09, 0}, 0).nearest - Vec3(0, 0.09, 0)).norm(), 1e-12) << x;
    EXPECT_LT((deviation({double(x), 0.15, 0}, 0).nearest - Vec3(0, -0.05, 0)).norm(), 1e-12) << x;
  }
}

TEST(PathDeviation, IsOfTheSegmentUnderWayWhereSeveralAreAsNear) {
  const Toolpath path = polyline({{0, 0, 0}, {10, 0, 0}, {0, 0, 0}, {10, 0, 0}}, 10);
  const PathDeviation deviation(path);
  for (const std::size_t segment : {0, 1, 2}) {
    EXPECT_EQ(deviation.nearest({4, 0.3, 0}, segment, 1).segment, segment);
  }
}

TEST(PathDeviation, OnTheWayPastAPlaceDoesNotTakeThePassBesideForItsOwn) {
  const Toolpath path = polyline({{0, 0, 0}, {100, 0, 0}, {100, 0.2, 0}, {0, 0.2, 0}}, 10);
  const PathDeviation deviation(path);
  for (int x = 1; x < 90; ++x) {
    EXPECT_NEAR(deviation.foot_near(0, {double(x), 0.15, 0}).s, x, 1e-12);
  }
  EXPECT_EQ(deviation.foot_near(0, {99.99, 0.15, 0}).segment, 1u) << "round the corner";
}

TEST(PathDeviation, IsThatOfBruteForceWhereverThePlaceIs) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    Toolpath path = random_path(random, 1 + 2 * round);
    for (Segment& segment : path.segments) {
      if (segment.kind == SegmentKind::arc && round % 2 == 1) {
        Arc& arc = path.arcs[static_cast<std::size_t>(segment.index)];
        arc.rise = arc.x.cross(arc.y) * arc.radius * (round % 4 == 1 ? 0.05 : 2);
        arc.sweep *= 3;
        segment.length = arc.length();
      }
    }
    const PathDeviation deviation(path);
    std::uniform_int_distribution<std::size_t> some(0, path.segments.size() - 1);
    std::normal_distribution<double> aside(0, round % 3 == 0 ? 0.01 : 5);
    for (int i = 0; i < 60; ++i) {
      const Vec3 place = path.segments[some(random)].end + Vec3(aside(random), aside(random), aside(random));
      const PathDeviation::Foot foot = deviation.nearest(place, some(random), some(random));
      ASSERT_NEAR(std::sqrt(foot.squared), testing::brute_force_distance(path, place), 2e-9)
          << "round " << round << ", place " << place.transpose();
      ASSERT_NEAR(foot.offset.norm(), std::sqrt(foot.squared), 1e-12);
      ASSERT_LT(testing::brute_force_distance(path, foot.segment, place - foot.offset), 1e-6);
    }
  }
}

TEST(PathDeviation, FollowsShortBlocksThatThePlaceIsSaidToBeFarFrom) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 2000; ++i) {
    points.emplace_back(i * 0.05, 3 * std::sin(i * 0.005), 0);
  }
  const Toolpath path = polyline(points, 10);
  PathDeviation deviation(path);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 along = (points[i + 1] - points[i]).normalized();
    const Vec3 aside = 0.02 * Vec3(-along.y(), along.x(), 0);
    const Vec3 offset =
        deviation((points[i] + points[i + 1]) / 2 + aside, static_cast<std::uint32_t>(i / 50 * 50)).nearest;
    EXPECT_LT((offset - aside).norm(), 1e-12) << i;
  }
}

TEST(PathDeviation, IsNoneOnThePathItself) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const Toolpath path = random_path(random, 60);
    PathDeviation deviation(path);
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
      const Segment& segment = path.segments[i];
      for (const double u : {0.0, 0.3, 0.7, 1.0}) {
        const Vec3 place = segment.kind == SegmentKind::arc
                               ? path.arc_of(segment).at(u * segment.length).position
                               : Vec3(path.start_of(i) + u * (segment.end - path.start_of(i)));
        EXPECT_LT(deviation(place, static_cast<std::uint32_t>(i)).nearest.norm(), 1e-7)
            << "round " << round << ", segment " << i << ", " << u;
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
