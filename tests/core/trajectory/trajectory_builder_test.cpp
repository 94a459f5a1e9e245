#include "core/trajectory/trajectory_builder.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

std::shared_ptr<const Toolpath> three_blocks() {
  return std::make_shared<const Toolpath>(
      testing::polyline({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}}, 10));
}

TrajectoryBuilder builder_of(const std::shared_ptr<const Toolpath>& path) {
  TrajectoryBuilder builder(path, Vec3::Constant(500));
  for (std::uint32_t i = 0; i < path->segments.size(); ++i) {
    builder.add_segment(i);
  }
  return builder;
}

TEST(TrajectoryBuilder, APieceRunsOverSeveralElements) {
  TrajectoryBuilder builder = builder_of(three_blocks());
  builder.add_piece({0, 0, 2, 0, 0, 0, {CauseKind::programmed_feed}}, 2);
  const std::vector<Part> parts = testing::parts_of(builder.finish());
  ASSERT_EQ(parts.size(), 3U);
  for (std::uint32_t e = 0; e < 3; ++e) {
    EXPECT_EQ(parts[e].element, e);
    EXPECT_DOUBLE_EQ(parts[e].time, 0.5 * e);
    EXPECT_DOUBLE_EQ(parts[e].duration, e == 2 ? 1 : 0.5);
    EXPECT_EQ(parts[e].q, 0);
  }
}

TEST(TrajectoryBuilder, LevelPiecesOfOneSpeedForOneCauseAreOne) {
  const Cause feed{CauseKind::programmed_feed};
  TrajectoryBuilder builder = builder_of(three_blocks());
  builder.add_level_piece({0, 0, 2, 0, 0, 0, feed}, 0.25);
  builder.add_level_piece({0, 0.5, 2, 0, 0, 0, feed}, 0.25);
  builder.add_level_piece({0, 0, 2, 0, 0, 1, feed}, 0.5);
  builder.add_level_piece({0, 0, 2, 0, 0, 2, {CauseKind::axis_velocity, 0}}, 0.5);
  builder.add_level_piece({0, 1, 4, 0, 0, 2, {CauseKind::axis_velocity, 0}}, 0.25);
  const Trajectory run = builder.finish();
  ASSERT_EQ(run.pieces().size(), 3U);
  EXPECT_EQ(run.pieces()[1].time, 1);
  EXPECT_EQ(run.pieces()[2].time, 1.5);
  EXPECT_EQ(run.duration(), 1.75);
  EXPECT_DOUBLE_EQ(run.state(0.75).path_length, 1.5);
}

TEST(TrajectoryBuilder, ReservingChangesNothing) {
  TrajectoryBuilder builder = builder_of(three_blocks());
  builder.reserve_for_path(6, 0);
  for (std::uint32_t e = 0; e < 3; ++e) {
    builder.add_piece({0, 0, e + 1.0, 0, 0, e, {}}, 0.5);
    builder.reserve_for_path(100, e);
  }
  const Trajectory run = builder.finish();
  ASSERT_EQ(run.pieces().size(), 3U);
  EXPECT_EQ(run.pieces()[2].v, 3);
  EXPECT_EQ(run.duration(), 1.5);
}

TEST(TrajectoryBuilder, ARampIsItsThreeStretchesOfConstantJerkOnEveryElement) {
  // Jerk 8 for 0.5 s, 4 mm/s2 held for 0.25 s, jerk -8 for 0.5 s: to 3 mm/s in 1.25 s and 15/8 mm.
  TrajectoryBuilder builder = builder_of(three_blocks());
  const auto held = static_cast<std::uint8_t>(cause_index({CauseKind::axis_acceleration, 0}));
  builder.add_piece({0, 0, 0, 4, 8, 0, {CauseKind::axis_jerk, 0}, Law::ramp, held}, 1.25);
  builder.add_piece({0, 0.875, 3, 0, 0, 1, {CauseKind::programmed_feed}}, 2.125 / 3);
  const Trajectory run = builder.finish();
  EXPECT_NEAR(run.state(0.5).tangential_acceleration, 4, 1e-12);
  EXPECT_EQ(run.state(0.6).cause.kind, CauseKind::axis_acceleration);
  EXPECT_EQ(run.state(0.9).cause.kind, CauseKind::axis_jerk);
  EXPECT_NEAR(run.state(1.25).speed, 3, 1e-12);
  EXPECT_NEAR(run.state(1.25).position.x(), 1.875, 1e-12);
  EXPECT_NEAR(run.state_at_path(1).position.x(), 1, 1e-12);
  EXPECT_EQ(run.state_at_path(1 + 1e-6).line, 2U);
  double end = 0;
  for (const Part& part : testing::parts_of(run)) {
    EXPECT_NEAR(part.time, end, 1e-12);
    EXPECT_LE(part.q, run.path().length(part.element));
    end = part.time + part.duration;
  }
  EXPECT_DOUBLE_EQ(end, run.duration());
}

TEST(TrajectoryBuilder, APieceThatEndsWithItsElementHasNoPartOnTheNextWhateverTheirLengthsAreRoundedTo) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> length(0.005, 0.05);
  std::vector<Vec3> points{{0, 0, 0}, {1179.87, 0, 0}};
  for (int i = 0; i < 200; ++i) {
    points.push_back(points.back() + Vec3(0, length(random), 0));
  }
  const auto path = std::make_shared<const Toolpath>(testing::polyline(points, 10));
  TrajectoryBuilder builder = builder_of(path);
  constexpr double speed = 0.7;
  constexpr double begun = 1e-17;  // what rounding leaves of the piece before, of its element [mm]
  for (std::uint32_t e = 0; e < path->segments.size(); ++e) {
    builder.add_piece({0, begun, speed, 0, 0, e, {CauseKind::programmed_feed}},
                      path->segments[e].length / speed);
  }
  const std::vector<Part> parts = testing::parts_of(builder.finish());
  EXPECT_EQ(parts.size(), path->segments.size());
}

TEST(TrajectoryBuilder, SlowingThatDoesNotSayWhatForTakesTheCauseBehindItOrTheStop) {
  TrajectoryBuilder builder = builder_of(three_blocks());
  const Cause slowing{CauseKind::ramp_down};
  builder.add_piece({0, 0, 2, -2, 0, 0, slowing}, 0.5);
  builder.add_piece({0, 0.75, 1, 0, 0, 0, {CauseKind::radial_acceleration, 1}}, 0.25);
  builder.add_piece({0, 0, 1, -0.5, 0, 1, slowing}, 2);
  builder.add_piece({0, 0, 0, 1, 0, 2, {CauseKind::axis_acceleration, 0}}, 2);
  const Trajectory run = builder.finish();
  EXPECT_EQ(run.state(0.1).slower_place, (Cause{CauseKind::radial_acceleration, 1}));
  EXPECT_EQ(run.state(1).slower_place, Cause{CauseKind::exact_stop});
}

}  // namespace
}  // namespace feedscope
