#include "ui/scene/sampled_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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
  const SampledPath path = sample_programmed(*run.path);
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
  const SampledPath path = sample_programmed(*run.path);
  ASSERT_EQ(path.size(), 4);
  EXPECT_EQ(path.kinds[0], SpanKind::rapid);
  EXPECT_EQ(path.kinds[1], SpanKind::cut);
  EXPECT_EQ(path.kinds[2], SpanKind::rapid);
  EXPECT_DOUBLE_EQ(length_of(path, SpanKind::rapid), 20);
  EXPECT_DOUBLE_EQ(length_of(path, SpanKind::cut), 10);
}

/// Turns home, changes the tool or goes to a coordinate of the machine on the way.
std::string program_with_machine_moves(unsigned seed) {
  std::mt19937 random(seed);
  const auto place = [&] { return std::to_string(static_cast<int>(random() % 100)); };
  const char* const machine[] = {"G28 G91 Z0\nG90\n", "G30 G91 X0 Z0\nG90\n", "G53 G0 Y-10 Z0\n"};
  std::string text = "G21 G90 G94 F2400\nG0 X0 Y0 Z5\n";
  for (int i = 0; i < 12; ++i) {
    text += "G1 X" + place() + " Y" + place() + " Z-" + place() + "\nX" + place() + "\n";
    text += machine[random() % 3];
    text += "G0 X" + place() + " Y" + place() + "\nZ5\n";
  }
  return text;
}

/// What is drawn is what the tool runs along, point by point: nothing between two places whose connection the
/// program does not say.
TEST(SampledPath, LeavesGapsAtMovesToMachinePositions) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    for (const char* model : {"cam", "essid", "ward"}) {
      const auto run = simulate_text(program_with_machine_moves(seed), model);
      const Toolpath& toolpath = *run.path;
      ASSERT_GT(not_counted(toolpath).machine_moves, 0U);
      const SampledPath programmed = sample_programmed(toolpath);
      EXPECT_NEAR(length_of(programmed, SpanKind::cut) + length_of(programmed, SpanKind::rapid),
                  toolpath.length(), 1e-3)
          << "seed " << seed;
      const SampledPath executed = sample_executed(run.trajectory);
      const double drawn = length_of(executed, SpanKind::cut) + length_of(executed, SpanKind::rapid) +
                           length_of(executed, SpanKind::blend) + length_of(executed, SpanKind::curve);
      EXPECT_NEAR(drawn, run.trajectory->path_length(), 2e-3 * drawn) << model << ", seed " << seed;
      const auto gaps = [](const SampledPath& path) { return std::ranges::count(path.kinds, SpanKind::gap); };
      EXPECT_EQ(gaps(executed), gaps(programmed)) << model << ", seed " << seed;
      EXPECT_GE(gaps(programmed), 11) << "seed " << seed;
    }
  }
}

TEST(SampledPath, OfNothingIsEmpty) {
  EXPECT_EQ(sample_programmed(Toolpath{}).size(), 0);
  EXPECT_EQ(sample_executed(std::make_shared<const Trajectory>()).size(), 0);
  EXPECT_TRUE(sample_executed(std::make_shared<const Trajectory>()).bounds.empty());
}

TEST(SampledExecuted, LiesOnTheTrajectoryAtItsTimes) {
  const auto run = simulate_text(random_program(1, 60));
  const SampledPath path = sample_executed(run.trajectory);
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

/// Single precision is that of the part, however far the part is from the zero point.
TEST(SampledExecuted, IsAsExactFarFromTheZeroPoint) {
  const auto run = simulate_text(
      "G21 G90 G94 F600\nG0 X500000 Y420000 Z0.02\nG1 Z0\nX500000.02\nY420000.02\nX500000 Y420000\nG0 X0\n");
  const auto is_cut = [](SpanKind kind) { return kind != SpanKind::rapid && kind != SpanKind::gap; };
  constexpr double exact = 2e-9;  // [mm] 1e-7 of 20 um
  std::size_t count = 0;
  const SampledPath executed = sample_executed(run.trajectory);
  for (std::size_t i = 0; i < executed.size(); ++i) {
    if (is_cut(executed.kinds[i])) {
      const State state = run.trajectory->state(executed.times[i]);
      EXPECT_LT((executed.position(i) - state.position).norm(), exact) << i;
      ++count;
    }
  }
  EXPECT_GT(count, 20U);
  const SampledPath programmed = sample_programmed(*run.path);
  EXPECT_LT((programmed.position(4) - Vec3(500'000.02, 420'000.02, 0)).norm(), exact);
  EXPECT_LT(programmed.position(0).norm(), 0.1) << "the start is as exact as its distance";
}

TEST(SampledExecuted, ColoursChangeInSmallSteps) {
  const auto run = simulate_text(random_program(2, 60));
  const SampledPath path = sample_executed(run.trajectory);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] == SpanKind::cut && (path.positions[i + 1] - path.positions[i]).norm() > 1e-6F) {
      EXPECT_LT(std::abs(path.value(Colouring::feed, i + 1) - path.value(Colouring::feed, i)),
                path.peak_feed / 12)
          << i;
    }
  }
}

class MarkedCorners : public ::testing::TestWithParam<const char*> {};

TEST_P(MarkedCorners, HaveTheLengthOfTheBlends) {
  const auto run = simulate_text(random_program(3, 40), GetParam());
  const SampledPath path = sample_executed(run.trajectory);
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
  const SampledPath path = sample_executed(run.trajectory);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if ((path.positions[i + 1] - path.positions[i]).norm() > 0) {
      EXPECT_EQ(path.value(Colouring::feed, i), path.value(Colouring::feed, i + 1))
          << "from X" << path.position(i).x();
    }
  }
  EXPECT_EQ(path.value(Colouring::feed, 0), units::from_mm_min(3000));
  EXPECT_EQ(path.value(Colouring::feed, path.size() - 1), units::from_mm_min(600));
}

TEST(SampledExecuted, KeepsToItsBudgetAndToThePath) {
  const auto run = simulate_text(random_program(4, 400));
  constexpr std::size_t budget = 1000;
  const SampledPath path = sample_executed(run.trajectory, budget);
  EXPECT_LE(path.size(), 3 * budget + 2);
  EXPECT_GE(path.size(), budget / 3);
  const double spacing = run.trajectory->path_length() / budget;
  const SampledPath whole = sample_executed(run.trajectory);
  ASSERT_GT(whole.size(), 3 * budget) << "else the test shows nothing";
  // The two walk the path together, so the nearest kept point in time is within a few spacings.
  std::size_t k = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    while (k + 1 < path.size() && path.times[k + 1] <= whole.times[i]) {
      ++k;
    }
    EXPECT_LT((whole.position(i) - path.position(k)).norm(), 3 * spacing) << i;
  }
}

/// Rounds of one square, each from standstill to standstill.
std::string rounds(std::size_t count) {
  std::string text = "G21 G90 G94\nG1 F6000\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += "X10\nX10.5 Y10\nX0 Y10.5\nX0 Y0\nG4 P0.01\n";
  }
  return text;
}

/// Largest value of every round, of rounds that take `time` each.
std::vector<double> largest_by_round(const SampledPath& path, double time, std::size_t count,
                                     const std::function<double(std::size_t)>& value) {
  std::vector<double> largest(count);
  for (std::size_t i = 1; i < path.size(); ++i) {
    double& here = largest[std::min(count - 1, static_cast<std::size_t>(path.times[i - 1] / time))];
    here = std::max(here, value(i));
  }
  return largest;
}

// Threads take a thousand pieces each: where one ends and the next begins nothing shows.
TEST(SampledExecuted, EveryRoundOfALongProgramIsTheSame) {
  constexpr std::size_t count = 300;
  const auto run = simulate_text(rounds(count));
  ASSERT_GT(run.trajectory->pieces().size(), 3 * 1024U) << "else the test shows nothing";
  const SampledPath path = sample_executed(run.trajectory);
  EXPECT_EQ(path.times.front(), 0);
  EXPECT_EQ(path.times.back(), run.trajectory->duration());
  EXPECT_TRUE(std::ranges::is_sorted(path.times));
  const double time = run.trajectory->duration() / count;
  const auto errors = largest_by_round(
      path, time, count, [&](std::size_t i) { return path.value(Colouring::contour_error, i); });
  const auto spans = largest_by_round(path, time, count, [&](std::size_t i) {
    return double{(path.positions[i] - path.positions[i - 1]).norm()};
  });
  for (std::size_t round = 1; round < count; ++round) {
    EXPECT_NEAR(errors[round], errors[0], 0.01 * errors[0]) << round;
    EXPECT_NEAR(spans[round], spans[0], 1e-3) << round;
  }
  const double blends = length_of(sample_executed(simulate_text(rounds(1)).trajectory), SpanKind::blend);
  EXPECT_NEAR(length_of(path, SpanKind::blend), count * blends, 1e-4 * count * blends);
}

/// Stored values have 8 bits: half a unit of the last is 0.4 %. At the border of two pieces either counts.
class Around {
 public:
  Around(const Trajectory& trajectory, double time) {
    constexpr double instant = 1e-9;
    for (const double at : {time - instant, time, time + instant}) {
      states_.push_back(trajectory.state(at));
    }
  }
  bool any(const std::function<bool(const State&)>& holds) const {
    return std::ranges::any_of(states_, holds);
  }
  /// `size`: what the stored number is exact to; 0: its own.
  void expect(double stored, const std::function<double(const State&)>& value,
              const std::function<double(const State&)>& size, const char* what) const {
    EXPECT_TRUE(any([&](const State& state) {
      return std::abs(stored - value(state)) <= 0.004 * std::max(size(state), std::abs(value(state))) + 1e-3;
    })) << what
        << " " << stored << " at " << states_[1].time << " s, not " << value(states_[1]);
  }

 private:
  std::vector<State> states_;
};

TEST(SampledExecuted, HoldsTheMotionAtItsTimes) {
  const auto speed = [](const State& s) { return s.speed; };
  const auto ratio = [](const State& s) { return s.programmed_feed > 0 ? s.speed / s.programmed_feed : 0.0; };
  const auto acceleration = [](const State& s) { return s.acceleration.norm(); };
  const auto jerk = [](const State& s) { return 2 * s.jerk.norm(); };
  const auto tangential = [](const State& s) { return s.tangential_acceleration; };
  for (const char* model : {"essid", "tapie", "ward"}) {
    const auto run = simulate_text(random_program(5, 20), model);
    const SampledPath path = sample_executed(run.trajectory);
    for (std::size_t i = 0; i < path.size(); ++i) {
      constexpr double instant = 1e-9;
      if (i > 0 && i + 1 < path.size() && path.times[i + 1] - path.times[i - 1] < instant) {
        continue;  // a phase of no duration
      }
      const Around around(*run.trajectory, path.times[i]);
      EXPECT_TRUE(around.any([&](const State& s) { return s.cause.kind == path.causes[i]; }))
          << path.times[i];
      around.expect(path.value(Colouring::feed, i), speed, speed, "feed");
      around.expect(path.value(Colouring::feed_ratio, i), ratio, ratio, "ratio");
      around.expect(path.value(Colouring::acceleration, i), acceleration, acceleration, "acceleration");
      around.expect(2 * path.value(Colouring::jerk, i), jerk, jerk, "jerk");
      if (path.value(Colouring::feed, i) > 1) {  // at rest there is no tangent
        around.expect(path.value(Colouring::tangential_acceleration, i), tangential, acceleration,
                      "tangential acceleration");
        around.expect(
            path.value(Colouring::tangential_jerk, i), [](const State& s) { return s.tangential_jerk; }, jerk,
            "tangential jerk");
      }
    }
  }
}

TEST(SampledExecuted, SpansHaveOneCause) {
  const auto run = simulate_text(random_program(6, 40));
  const SampledPath path = sample_executed(run.trajectory);
  const Bounds& all = run.path->bounds;
  // A part shorter than half of this by the mean of its blend may end in a span.
  const double unseen = 1e-4 * (all.max - all.min).norm();
  int changes = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.causes[i] != path.causes[i + 1]) {
      ++changes;
      EXPECT_LT(double{(path.positions[i + 1] - path.positions[i]).norm()}, unseen) << i;
    }
  }
  EXPECT_GT(changes, 40);
}

TEST(SampledExecuted, DeviatesInBlendsByAsMuchAsTheyCutTheCorner) {
  const auto run = simulate_text("G21 G90 G94 F3000\nG1 X40\nY40\nX80\n");
  const SampledPath path = sample_executed(run.trajectory);
  double largest = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double size = path.value(Colouring::contour_error, i);
    largest = std::max(largest, size);
    if (path.kinds[i] == SpanKind::cut && (i == 0 || path.kinds[i - 1] == SpanKind::cut)) {
      EXPECT_EQ(size, 0) << "on the programmed line";
    }
  }
  // In a right angle the nearest programmed point of the blend's middle is the corner's foot on either line.
  const BlendRecord blend = testing::blends_of(*run.trajectory).front();
  EXPECT_NEAR(largest, blend.epsilon / std::sqrt(2.0), 0.03 * blend.epsilon);
  double largest_drawn = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    largest_drawn = std::max(largest_drawn, path.deviation(i).norm());
  }
  EXPECT_NEAR(largest_drawn, blend.epsilon, 0.03 * blend.epsilon) << "along the bisector";
}

TEST(SampledExecuted, FindsTheDeviationsOfItsPointsWhenAsked) {
  for (const char* model : {"essid", "msaddek", "ward"}) {
    for (unsigned seed = 7; seed < 10; ++seed) {
      const auto run = simulate_text(random_program(seed, 30), model);
      const SampledPath path = sample_executed(run.trajectory);
      EXPECT_FALSE(path.deviations->asked());
      const SampledDeviations& found = path.found_deviations();
      EXPECT_TRUE(path.deviations->asked());
      ASSERT_EQ(found.errors.size(), path.size());
      ASSERT_EQ(found.shifts.size(), path.size());
      PathDeviation deviation(*run.path);
      for (std::size_t i = 0; i < path.size(); ++i) {
        const State at = run.trajectory->state(path.times[i]);
        const auto there = deviation(at.position, run.trajectory->path().segment(at.element));
        constexpr double nothing = 1e-9;  // [mm]
        EXPECT_NEAR(double(float(found.errors[i])), there.nearest.norm(),
                    0.004 * there.nearest.norm() + nothing)
            << model << ", seed " << seed << ", " << at.time << " s";
        EXPECT_NEAR((path.deviation(i) - there.along_bisector).norm(), 0,
                    0.004 * there.along_bisector.norm() + nothing);
        EXPECT_NEAR(contour_error_at(*run.trajectory, deviation, path.times[i]), there.nearest.norm(),
                    nothing);
      }
    }
  }
}

SampledPath points_at(const std::vector<float>& places) {
  SampledPath path;
  for (const float x : places) {
    path.positions.emplace_back(x, 0.0F, 0.0F);
    path.kinds.push_back(SpanKind::cut);
    path.bounds.add(Vec3(double(x), 0, 0));
  }
  return path;
}

TEST(Levels, OfASmallPathAreAllPoints) {
  const auto levels = levels_of(points_at({0, 1, 2}));
  ASSERT_EQ(levels.size(), 1);
  EXPECT_EQ(levels[0].size(), 3);
  EXPECT_EQ(levels[0][2], 2);
}

TEST(Levels, HalveAtLeastAndKeepEndsAndTheBeginningsOfLongSpans) {
  constexpr int passes = 10;
  constexpr int points_a_pass = 60'000;
  std::vector<float> places;
  for (int i = 0; i < passes * points_a_pass; ++i) {
    const int back = i / points_a_pass % 2;
    const int step = i % points_a_pass;
    places.push_back(100.0F * static_cast<float>(back == 0 ? step : points_a_pass - step) / points_a_pass);
  }
  const auto long_span = static_cast<std::uint32_t>(places.size() - 1);
  places.push_back(places.back() + 50);
  places.push_back(places.back() + 1e-5F);
  const SampledPath path = points_at(places);
  const auto levels = levels_of(path);
  ASSERT_GE(levels.size(), 3);
  for (std::size_t level = 1; level < levels.size(); ++level) {
    EXPECT_LE(2 * levels[level].size(), levels[level - 1].size());
    EXPECT_EQ(levels[level][0], 0);
    EXPECT_EQ(levels[level][levels[level].size() - 1], places.size() - 1);
    EXPECT_TRUE(std::ranges::binary_search(levels[level].points, long_span)) << "the long span begins there";
    for (std::size_t k = 0; k + 1 < levels[level].size(); ++k) {
      ASSERT_LT(levels[level][k], levels[level][k + 1]);
    }
  }
  EXPECT_LT(levels.back().size(), 10'000);
}

/// A rapid from far away takes no points from the part while the view turns.
TEST(Levels, AreThoseOfWhatIsCut) {
  std::vector<float> places{500'000.0F};
  for (int i = 0; i < 300'000; ++i) {
    places.push_back(static_cast<float>(i % 1000) / 1000);
  }
  SampledPath path = points_at(places);
  path.kinds.front() = SpanKind::rapid;
  const auto levels = levels_of(path);
  ASSERT_GE(levels.size(), 2U);
  EXPECT_LE(levels.back().spacing, 1.0 / 50);
}

TEST(Boxes, HoldTheirSpans) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-50, 50);
  std::vector<Eigen::Vector3f> positions(1000);
  for (auto& p : positions) {
    p = {place(random), place(random), place(random)};
  }
  const auto boxes = boxes_of(positions);
  ASSERT_EQ(boxes.size(), 16);
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    for (const std::size_t end : {i, i + 1}) {
      EXPECT_TRUE((positions[end].array() >= boxes[i / spans_of_box].low.array()).all()) << i;
      EXPECT_TRUE((positions[end].array() <= boxes[i / spans_of_box].high.array()).all()) << i;
    }
  }
}

}  // namespace
}  // namespace feedscope::ui
