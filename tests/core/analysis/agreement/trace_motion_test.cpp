#include "core/analysis/agreement/trace_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace feedscope {
namespace {

constexpr double period = 1e-3;  // [s]
constexpr SeenAxes all{true, true, true};

/// A circle of `radius` [mm] at a constant `feed` [mm/s].
MotionRecord circle(double radius, double feed, double noise = 0, double jitter = 0) {
  std::mt19937 random(3);
  std::normal_distribution<double> off(0, 1);
  std::uniform_real_distribution<double> late(-1, 1);
  MotionRecord record;
  for (int i = 0; i < 3000; ++i) {
    const double time = i * period + jitter * late(random);
    const double angle = feed / radius * time;
    record.time.push_back(time);
    record.place.emplace_back(radius * std::cos(angle) + noise * off(random),
                              radius * std::sin(angle) + noise * off(random), noise * off(random));
  }
  return record;
}

TEST(TraceMotion, OnACircleTheFeedIsConstantAndTheAccelerationIsThatOfItsRadius) {
  const MotionRecord record = circle(20, 100);
  const TraceMotion motion(record, all, 0, period);
  for (const double time : {0.5, 1.234, 2.9}) {
    const State state = motion.state(time);
    EXPECT_NEAR(state.speed, 100, 0.01);
    EXPECT_NEAR(state.acceleration.norm(), 100.0 * 100.0 / 20, 0.5);
    EXPECT_NEAR(state.tangential_acceleration, 0, 0.1);
  }
}

TEST(TraceMotion, TimesThatJitterMakeNoFeed) {
  const MotionRecord record = circle(50, 100, 0, 2e-4);
  const TraceMotion motion(record, all, 0, period);
  for (double time = 0.1; time < 2.9; time += 0.0173) {
    EXPECT_NEAR(motion.state(time).speed, 100, 0.05);
  }
}

TEST(TraceMotion, NoiseIsSmoothedOverALongerStretch) {
  constexpr double noise = 2e-3;  // [mm]
  const MotionRecord record = circle(50, 100, noise);
  const TraceMotion motion(record, all, noise, period);
  const TraceMotion without(record, all, 0, period);
  EXPECT_GT(motion.feed_window(), without.feed_window());
  EXPECT_LE(motion.feed_window(), 0.0201);
  double squares = 0;
  int count = 0;
  for (double time = 0.1; time < 2.9; time += 0.0173, ++count) {
    squares += std::pow(motion.state(time).speed - 100, 2);
  }
  EXPECT_LT(std::sqrt(squares / count), 0.005 * 100 * 1.3);
}

TEST(TraceMotion, ColumnsHoldTheExtentsOfTheirSamples) {
  const MotionRecord record = circle(20, 100);
  const TraceMotion motion(record, all, 0, period);
  const std::vector<double> times{0.1, 0.1004, 0.9, 2.5};
  const std::vector<Band> bands = motion.columns(times);
  ASSERT_EQ(bands.size(), 3U);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    Extent feed;
    Extent across;
    for (double time = times[i]; time <= times[i + 1]; time += period / 2) {
      feed.add(static_cast<float>(motion.state(time).speed));
      across.add(static_cast<float>(motion.state(time).velocity.x()));
    }
    EXPECT_NEAR(bands[i][QuantityId::feed].max, feed.max, 1e-4);
    EXPECT_NEAR(bands[i][QuantityId::velocity_x].min, across.min, 1e-3);
    EXPECT_NEAR(bands[i][QuantityId::velocity_x].max, across.max, 1e-3);
  }
}

/// Encoders count from another zero point, and the trace is mirrored in X.
TEST(TraceMotion, HasTheFollowingErrorsOfSamplesWithActualPositions) {
  const MotionRecord record = circle(20, 100);
  Trace trace;
  trace.time = record.time;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    trace.place[0].push_back(-record.place[i].x());
    trace.actual[0].push_back(-record.place[i].x() + 7 +
                              1e-3 * std::min<double>(static_cast<double>(i), 500));
    trace.place[1].push_back(record.place[i].y());
  }
  TracePose pose;
  pose.mirror.x() = -1;
  const TraceMotion motion(record, all, 0, period, RecordedErrors(trace, pose));
  EXPECT_TRUE(motion.knows(QuantityId::following_error_x));
  EXPECT_FALSE(motion.knows(QuantityId::following_error_y));
  EXPECT_FALSE(motion.knows(QuantityId::actual_contour_error));
  EXPECT_NEAR(motion.drives(record.time[400])->motion.following_error.x(), 0.4, 1e-9);
  EXPECT_EQ(motion.drives(record.time[400])->motion.following_error.y(), 0);
  const std::vector<Band> bands =
      motion.columns(std::vector<double>{record.time[10], record.time[321], record.time.back()});
  EXPECT_NEAR(bands[0][QuantityId::following_error_x].min, 0.01, 1e-6);
  EXPECT_NEAR(bands[0][QuantityId::following_error_x].max, 0.321, 1e-6);
  EXPECT_NEAR(bands[1][QuantityId::following_error_x].max, 0.5, 1e-6);
  EXPECT_TRUE(bands[0][QuantityId::following_error_y].empty());
  EXPECT_TRUE(bands[0][QuantityId::actual_contour_error].empty());
  EXPECT_FALSE(TraceMotion(record, all, 0, period).drives(1).has_value());
}

TEST(TraceMotion, KnowsNothingOfAxesThatAreNotSeenOfGapsAndOfWhatWasNotRecorded) {
  MotionRecord record = circle(20, 100);
  const auto cut = [&](auto& list) { list.erase(list.begin() + 1000, list.begin() + 1500); };
  cut(record.time);
  cut(record.place);
  const TraceMotion motion(record, {true, false, false}, 0, period);
  EXPECT_TRUE(motion.knows(QuantityId::velocity_x));
  EXPECT_FALSE(motion.knows(QuantityId::velocity_y));
  EXPECT_FALSE(motion.knows(QuantityId::jerk_x));
  EXPECT_FALSE(motion.knows(QuantityId::programmed_feed));
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Band> bands =
      motion.columns(std::vector<double>{-2, -1, 0.5, 0.6, 1.2, 1.3, nothing, 2, 2.1, 4, 5});
  const auto known = [&](std::size_t i) { return !bands[i][QuantityId::velocity_x].empty(); };
  EXPECT_FALSE(known(0));
  EXPECT_TRUE(known(2));
  EXPECT_FALSE(known(4)) << "in the gap";
  EXPECT_FALSE(known(5));
  EXPECT_FALSE(known(6));
  EXPECT_TRUE(known(7));
  EXPECT_FALSE(known(9));
  EXPECT_TRUE(bands[2][QuantityId::velocity_y].empty());
  EXPECT_TRUE(bands[2][QuantityId::jerk_x].empty());
  EXPECT_NEAR(motion.state(0.9995).velocity.y(), 0, 0) << "not seen";
}

}  // namespace
}  // namespace feedscope
