#include "ui/scene/sampled_path.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/units.h"
#include "tests/support/parts.h"
#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

using test::simulate_text;

std::string random_program(unsigned seed, int blocks) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 100);
  std::string text = "G21 G90 G94 F2400\n";
  for (int i = 0; i < blocks; ++i) {
    text += (i % 7 == 3 ? "G0" : "G1") + std::string(" X") + std::to_string(place(random)) + " Y" +
            std::to_string(place(random)) + "\n";
  }
  return text;
}

TEST(SampledProgrammed, HoldsTheEndsOfLinesAndPointsOnArcs) {
  const auto run = simulate_text("G21 G90 G17 G94 F1000\nG1 X10 Y0\nG3 X10 Y20 I0 J10\nG1 X0\n", "cam");
  const SampledPath path = sample_programmed(*run.input.toolpath);
  EXPECT_LT((path.position(0) - Vec3(0, 0, 0)).norm(), 1e-5);
  EXPECT_LT((path.position(1) - Vec3(10, 0, 0)).norm(), 1e-5);
  EXPECT_LT((path.position(path.size() - 1) - Vec3(0, 20, 0)).norm(), 1e-5);
  ASSERT_EQ(path.size(), 1 + 1 + 60 + 1) << "half a circle in steps of 3 degrees";
  for (std::size_t i = 1; i <= 61; ++i) {
    EXPECT_NEAR((path.position(i) - Vec3(10, 10, 0)).norm(), 10, 1e-5) << i;
  }
}

TEST(SampledProgrammed, TellsRapidsFromCuts) {
  const auto run = simulate_text("G21 G90 G94 F1000\nG0 X10\nG1 Y10\nG0 Z10\n", "cam");
  const SampledPath path = sample_programmed(*run.input.toolpath);
  ASSERT_EQ(path.size(), 4);
  EXPECT_EQ(path.kinds[0], SpanKind::rapid);
  EXPECT_EQ(path.kinds[1], SpanKind::cut);
  EXPECT_EQ(path.kinds[2], SpanKind::rapid);
  EXPECT_DOUBLE_EQ(length_of(path, SpanKind::rapid), 20);
  EXPECT_DOUBLE_EQ(length_of(path, SpanKind::cut), 10);
}

TEST(SampledPath, OfNothingIsEmpty) {
  EXPECT_EQ(sample_programmed(Toolpath{}).size(), 0);
  EXPECT_EQ(sample_executed(Trajectory{}).size(), 0);
  EXPECT_TRUE(sample_executed(Trajectory{}).bounds.empty());
}

TEST(SampledExecuted, LiesOnTheTrajectoryAtItsTimes) {
  const auto run = simulate_text(random_program(1, 60));
  const SampledPath path = sample_executed(*run.trajectory);
  ASSERT_GT(path.size(), 100);
  EXPECT_EQ(path.times.front(), 0);
  EXPECT_EQ(path.times.back(), run.trajectory->duration());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const State state = run.trajectory->state(path.times[i]);
    EXPECT_LT((path.position(i) - state.position).norm(), 1e-4) << i;
    if (i > 0) {
      EXPECT_GE(path.times[i], path.times[i - 1]);
    }
  }
}

TEST(SampledExecuted, ColoursChangeInSmallSteps) {
  const auto run = simulate_text(random_program(2, 60));
  const SampledPath path = sample_executed(*run.trajectory);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] == SpanKind::cut && (path.positions[i + 1] - path.positions[i]).norm() > 1e-6F) {
      EXPECT_LT(std::abs(path.feeds[i + 1] - path.feeds[i]), path.peak_feed / 12) << i;
    }
  }
}

class MarkedCorners : public ::testing::TestWithParam<const char*> {};

TEST_P(MarkedCorners, HaveTheLengthOfTheBlends) {
  const auto run = simulate_text(random_program(3, 40), GetParam());
  const SampledPath path = sample_executed(*run.trajectory);
  double length = 0;
  for (const BlendRecord& blend : testing::blends_of(*run.trajectory)) {
    length += run.trajectory->is_rapid(blend.element) ? 0 : blend.length;
  }
  ASSERT_GT(length, 0);
  EXPECT_NEAR(length_of(path, SpanKind::blend), length, 0.01 * length);
}

INSTANTIATE_TEST_SUITE_P(CubicsAndConnectingArcs, MarkedCorners, ::testing::Values("essid", "msaddek"));

TEST(SampledExecuted, FeedThatJumpsDoesNotFlowAlongTheLine) {
  const auto run = simulate_text("G21 G90 G94\nG1 X100 F3000\nX200 F600\n", "cam");
  const SampledPath path = sample_executed(*run.trajectory);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if ((path.positions[i + 1] - path.positions[i]).norm() > 0) {
      EXPECT_EQ(path.feeds[i], path.feeds[i + 1]) << "from X" << path.position(i).x();
    }
  }
  EXPECT_FLOAT_EQ(path.feeds.front(), static_cast<float>(units::from_mm_min(3000)));
  EXPECT_FLOAT_EQ(path.feeds.back(), static_cast<float>(units::from_mm_min(600)));
}

TEST(SampledExecuted, KeepsToItsBudgetAndToThePath) {
  const auto run = simulate_text(random_program(4, 400));
  constexpr std::size_t budget = 1000;
  const SampledPath path = sample_executed(*run.trajectory, budget);
  EXPECT_LE(path.size(), 2 * budget + 2);
  EXPECT_GE(path.size(), budget / 3);
  const double spacing = run.trajectory->path_length() / budget;
  const SampledPath whole = sample_executed(*run.trajectory);
  ASSERT_GT(whole.size(), 2 * budget) << "else the test shows nothing";
  // The two walk the path together, so the nearest kept point in time is within a few spacings.
  std::size_t k = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    while (k + 1 < path.size() && path.times[k + 1] <= whole.times[i]) {
      ++k;
    }
    EXPECT_LT((whole.position(i) - path.position(k)).norm(), 3 * spacing) << i;
  }
}

TEST(Thinned, KeepsEndsAndTheBeginningsOfLongSpans) {
  SampledPath path;
  for (const float x : {0.0F, 0.1F, 0.2F, 5.0F, 5.1F, 9.0F, 9.05F}) {
    path.positions.emplace_back(x, 0.0F, 0.0F);
    path.kinds.push_back(SpanKind::cut);
    path.feeds.push_back(x);
    path.times.push_back(static_cast<double>(x));
  }
  const SampledPath kept = thinned(path, 1);
  std::vector<float> places;
  for (const auto& p : kept.positions) {
    places.push_back(p.x());
  }
  EXPECT_EQ(places, (std::vector<float>{0.0F, 0.2F, 5.0F, 5.1F, 9.0F, 9.05F}));
  EXPECT_EQ(kept.feeds, places);
}

}  // namespace
}  // namespace feedscope::ui
