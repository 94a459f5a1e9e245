#include "core/drives/set_walk.h"

#include <gtest/gtest.h>

#include <random>

#include "core/models/control_model.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Vec3 position_in(const SetSpan& span, double h) {
  Vec3 at = span.start;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[static_cast<Eigen::Index>(axis)] += span.axes[axis].travel(h);
  }
  return at;
}

Vec3 velocity_in(const SetSpan& span, double h) {
  Vec3 v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    v[static_cast<Eigen::Index>(axis)] = span.axes[axis].velocity(h);
  }
  return v;
}

Trajectory run_of(const ControlModel& model, const Toolpath& path) {
  return model.simulate(path, testing::spinner(), testing::spinner_settings(model));
}

TEST(SetWalk, SpansAreTheSetPathOfEveryModel) {
  std::mt19937 random(91);
  for (const ControlModel* model : all_models()) {
    for (int i = 0; i < 6; ++i) {
      const Trajectory run = run_of(*model, testing::random_path(random, 12));
      double time = 0;
      for (SetWalk walk(run); !walk.done(); walk.next()) {
        const SetSpan& span = walk.span();
        ASSERT_NEAR(span.time, time, 1e-9 * (1 + time)) << model->info().id;
        ASSERT_GT(span.duration, 0);
        for (const double share : {0.03, 0.2, 0.37, 0.5, 0.71, 0.96}) {
          const State state = run.state(span.time + share * span.duration);
          ASSERT_LT((position_in(span, share * span.duration) - state.position).norm(),
                    4 * SetWalk::tolerance)
              << model->info().id << " at " << span.time;
        }
        time = span.end();
      }
      ASSERT_NEAR(time, run.duration(), 1e-9 * (1 + time)) << model->info().id;
    }
  }
}

TEST(SetWalk, SpansMeetWithoutGaps) {
  std::mt19937 random(92);
  for (const ControlModel* model : all_models()) {
    const Trajectory run = run_of(*model, testing::random_path(random, 30));
    Vec3 reached;
    bool first = true;
    for (SetWalk walk(run); !walk.done(); walk.next()) {
      const SetSpan& span = walk.span();
      ASSERT_EQ(span.begins, first) << model->info().id << " at " << span.time;
      if (!first) {
        ASSERT_LT((span.start - reached).norm(), 1e-7) << model->info().id << " at " << span.time;
      }
      reached = position_in(span, span.duration);
      first = false;
    }
  }
}

TEST(SetWalk, LinesAreOneSpanAJerkAndArcsFew) {
  Toolpath path = testing::polyline({{0, 0, 0}, {100, 0, 0}}, 50);
  testing::append_arc(path, {100, 30, 0}, 6.283185307179586, 50);
  const Trajectory run = run_of(find_model("cam"), path);
  int lines = 0;
  int arcs = 0;
  for (SetWalk walk(run); !walk.done(); walk.next()) {
    const bool on_line = run.state(walk.span().time + walk.span().duration / 2).element == 0;
    (on_line ? lines : arcs) += 1;
  }
  EXPECT_EQ(lines, 1);
  // R (w h)^10/(2^10 10!) = 3e-9 mm: 0.91 rad a span.
  EXPECT_EQ(arcs, 7);
}

TEST(SetWalk, BeginsAnywhereAsIfFromTheStart) {
  std::mt19937 random(93);
  for (const ControlModel* model : all_models()) {
    const Trajectory run = run_of(*model, testing::random_path(random, 20));
    std::uniform_real_distribution<double> anywhere(0, run.duration());
    for (int i = 0; i < 20; ++i) {
      const double time = anywhere(random);
      const SetWalk walk(run, time);
      ASSERT_FALSE(walk.done());
      ASSERT_NEAR(walk.span().time, time, 1e-9);
      ASSERT_LT((walk.span().start - run.state(time).position).norm(), 1e-8) << model->info().id;
      ASSERT_LT((velocity_in(walk.span(), 0) - run.state(time).velocity).norm(), 1e-5) << model->info().id;
    }
  }
}

TEST(SetWalk, OfNoMotionIsDone) {
  const Trajectory nothing;
  EXPECT_TRUE(SetWalk(nothing).done());
}

}  // namespace
}  // namespace feedscope
