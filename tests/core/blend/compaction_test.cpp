#include "core/blend/compaction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/paths.h"

namespace feedscope {
namespace {

CompactedPath compact_within(const Toolpath& toolpath, double longest, double tolerance) {
  Settings settings;
  settings.set("contour_tolerance_mm", tolerance);
  settings.set("program_tolerance", "on");
  return compact(toolpath, longest, PathRules(toolpath, settings));
}

/// Points every `step` [mm] on a circle of `radius` [mm].
std::vector<Vec3> circle(double radius, double step, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = i * step / radius;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return points;
}

TEST(Compaction, MergesAStraightRunIntoSegmentsOfTheGivenLength) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 1000; ++i) {
    points.push_back({0.1 * i, 0, 0});
  }
  const CompactedPath compacted = compact_within(testing::polyline(points, 50), 5, 0.007);
  ASSERT_EQ(compacted.path.segments.size(), 20u);
  for (const Segment& segment : compacted.path.segments) {
    EXPECT_NEAR(segment.length, 5, 1e-9);
  }
  EXPECT_EQ(compacted.first.back(), 1000u);
  EXPECT_LT(compacted.deviation, 1e-12);
}

TEST(Compaction, GoesAsFarRoundACircleAsTheToleranceAllows) {
  // A chord of length c leaves a circle of radius r by c^2 / 8r.
  const double radius = 50;
  const double tolerance = 0.004;
  const double longest_chord = std::sqrt(8 * radius * tolerance);
  const CompactedPath compacted =
      compact_within(testing::polyline(circle(radius, 0.01, 10000), 50), 5, tolerance);
  for (std::size_t i = 0; i + 1 < compacted.path.segments.size(); ++i) {
    EXPECT_NEAR(compacted.path.segments[i].length, longest_chord, 0.02);
  }
  EXPECT_LE(compacted.deviation, tolerance);
  EXPECT_GT(compacted.deviation, 0.95 * tolerance);
}

TEST(Compaction, KeepsBlocksApartWhoseFeedDiffers) {
  Toolpath path = testing::polyline({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, 50);
  path.segments[2].feed = path.segments[3].feed = 60;
  EXPECT_EQ(compact_within(path, 5, 0.01).first, (std::vector<std::uint32_t>{0, 2, 4}));
}

TEST(Compaction, LeavesLongBlocksRapidsArcsAndReversalsAlone) {
  Toolpath path = testing::polyline({{0, 0, 0}, {6, 0, 0}, {7, 0, 0}, {8, 0, 0}, {7.5, 0, 0}}, 50);
  path.segments[2].rapid = true;
  testing::append_arc(path, {7.5, 1, 0}, 0.1, 50);
  EXPECT_EQ(compact_within(path, 5, 0.01).path.segments.size(), path.segments.size());
}

TEST(Compaction, OfLengthZeroChangesNothing) {
  std::mt19937 random(5);
  const Toolpath path = testing::random_path(random, 200);
  const CompactedPath compacted = compact_within(path, 0, 0.01);
  ASSERT_EQ(compacted.path.segments.size(), path.segments.size());
  EXPECT_EQ(compacted.deviation, 0);
}

TEST(Compaction, KeepsEveryReplacedPointWithinTheTolerance) {
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i) {
    const Toolpath path = testing::random_path(random, 300);
    const double tolerance = i % 2 == 0 ? 0.05 : 0.002;
    const CompactedPath compacted = compact_within(path, 3, tolerance);
    ASSERT_LE(compacted.deviation, tolerance);
    for (std::size_t c = 0; c < compacted.path.segments.size(); ++c) {
      const Segment& chord = compacted.path.segments[c];
      const std::uint32_t last = compacted.first[c + 1] - 1;
      ASSERT_EQ(chord.end, path.segments[last].end);
      if (last == compacted.first[c]) {
        continue;
      }
      ASSERT_LE(chord.length, 3 * (1 + 1e-9));
      const Vec3 start = compacted.path.start_of(c);
      const Vec3 direction = compacted.path.tangent_at_start(c);
      for (std::uint32_t b = compacted.first[c]; b < last; ++b) {
        const Vec3 way = path.segments[b].end - start;
        ASSERT_LE((way - way.dot(direction) * direction).norm(), tolerance * (1 + 1e-9));
      }
    }
  }
}

TEST(MergeCollinear, TakesAStraightRunTogetherWhateverItsLength) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 1000; ++i) {
    points.push_back(Vec3(1, 2, -2) * (0.1 * i));
  }
  const CompactedPath merged = merge_collinear(testing::polyline(points, 50), 1e-9);
  EXPECT_EQ(merged.first, (std::vector<std::uint32_t>{0, 1000}));
  EXPECT_NEAR(merged.path.segments.front().length, 300, 1e-9);
}

TEST(MergeCollinear, KeepsWhatIsNotOneMotionApart) {
  const auto straight = [] {
    return testing::polyline({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, 50);
  };
  const auto firsts = [](const Toolpath& path) { return merge_collinear(path, 1e-6).first; };
  using Firsts = std::vector<std::uint32_t>;
  ASSERT_EQ(firsts(straight()), (Firsts{0, 4}));
  Toolpath feeds = straight();
  feeds.segments[2].feed = 60;
  EXPECT_EQ(firsts(feeds), (Firsts{0, 2, 3, 4}));
  Toolpath rapids = straight();
  rapids.segments[0].rapid = rapids.segments[1].rapid = true;
  EXPECT_EQ(firsts(rapids), (Firsts{0, 1, 2, 4})) << "every rapid is a motion from rest to rest";
  Toolpath spindles = straight();
  spindles.spindles.push_back({});
  spindles.segments[3].spindle = 1;
  EXPECT_EQ(firsts(spindles), (Firsts{0, 3, 4}));
  Toolpath stops = straight();
  stops.path_controls.push_back({});
  stops.path_controls.back().mode = PathMode::exact_stop;
  stops.segments[0].path_control = stops.segments[1].path_control = 1;
  EXPECT_EQ(firsts(stops), (Firsts{0, 1, 2, 4}));
  Toolpath curves = straight();
  curves.segments[0].on_curve = curves.segments[1].on_curve = true;
  EXPECT_EQ(firsts(curves), (Firsts{0, 1, 2, 4}));
  Toolpath dwells = testing::polyline({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 50);
  testing::append_dwell(dwells, 1);
  testing::append_line(dwells, {3, 0, 0}, 50);
  testing::append_line(dwells, {2, 0, 0}, 50);
  testing::append_arc(dwells, {2, 1, 0}, 1, 50);
  EXPECT_EQ(firsts(dwells), (Firsts{0, 2, 3, 4, 5, 6})) << "dwell, reversal, arc";
}

TEST(MergeCollinear, LeavesNoPointOutThatIsOffTheLine) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> off(-1, 1);
  constexpr double tolerance = 1e-4;
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec3> points{Vec3::Zero()};
    for (int k = 1; k <= 100; ++k) {
      const double noise = k % 10 == 0 ? 20 * tolerance : 0.5 * tolerance;
      points.push_back({0.1 * k, noise * off(random), noise * off(random)});
    }
    const Toolpath path = testing::polyline(points, 50);
    const CompactedPath merged = merge_collinear(path, tolerance);
    EXPECT_LT(merged.path.segments.size(), path.segments.size());
    EXPECT_LE(merged.deviation, tolerance);
    for (std::size_t line = 0; line < merged.path.segments.size(); ++line) {
      const Vec3& start = merged.path.start_of(line);
      const Vec3 direction = merged.path.tangent_at_start(line);
      for (std::uint32_t block = merged.first[line]; block < merged.first[line + 1]; ++block) {
        EXPECT_LE((path.segments[block].end - start).cross(direction).norm(), tolerance * (1 + 1e-9));
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
