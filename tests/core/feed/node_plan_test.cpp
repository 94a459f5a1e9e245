#include "core/feed/node_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/feed/node_planner.h"
#include "core/feed/profile_speeds.h"
#include "core/feed/profile_walk.h"

namespace feedscope {
namespace {

PlanElement element(double length, double speed, double jerk = 15000) {
  return {length, MotionLimits{{speed, {}}, {1000, 0}, {jerk, 0}}};
}

std::vector<SpeedBound> ceilings(const std::vector<PlanElement>& elements) {
  std::vector<SpeedBound> ceiling(elements.size() + 1);
  for (std::size_t j = 1; j < elements.size(); ++j) {
    ceiling[j] = elements[j - 1].speed();
    ceiling[j].lower(elements[j].speed().value, elements[j].speed().cause);
  }
  return ceiling;
}

double duration(const std::vector<PlanElement>& elements, const std::vector<PlanNode>& nodes) {
  double sum = 0;
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const SpanLimits span = span_limits(elements, nodes[n].junction, nodes[n + 1].junction);
    sum += plan_profile(nodes[n].speed, 0, nodes[n + 1].speed, span.length, span.ceiling, span.ramp())
               .duration();
  }
  return sum;
}

TEST(NodePlan, ManyShortBlocksRunAsOneLongOne) {
  // Without corners the law must not depend on how a line is cut into blocks.
  const std::vector<PlanElement> one{element(50, 80)};
  const std::vector<PlanElement> many(500, element(0.1, 80));
  const auto nodes = plan_nodes(many, ceilings(many));
  EXPECT_EQ(nodes.size(), 2u);
  EXPECT_NEAR(duration(many, nodes), duration(one, plan_nodes(one, ceilings(one))), 1e-9);
}

TEST(NodePlan, ASlowPlaceBecomesANodeAtItsCeiling) {
  const std::vector<PlanElement> elements{element(20, 80), element(1, 10), element(20, 80)};
  const auto nodes = plan_nodes(elements, ceilings(elements));
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_EQ(nodes[1].junction, 1u);
  EXPECT_EQ(nodes[2].junction, 2u);
  EXPECT_DOUBLE_EQ(nodes[1].speed, 10);
  EXPECT_DOUBLE_EQ(nodes[2].speed, 10);
}

TEST(NodePlan, ANodeIsNotHeldDownByLimitsOfElementsThatASlowerPlaceCutsOff) {
  // At first the gap up to junction 2 has the low jerk of its first element; then junction 1 becomes a node.
  const std::vector<PlanElement> elements{element(5, 2, 20), element(7, 80, 300), element(50, 40, 300)};
  const std::vector<std::uint32_t> last{2};
  const std::vector<std::uint32_t> both{1, 2};
  const auto nodes = plan_nodes(elements, ceilings(elements), last);
  const auto known = plan_nodes(elements, ceilings(elements), both);
  ASSERT_EQ(nodes.size(), 4u);
  ASSERT_EQ(known.size(), 4u);
  EXPECT_EQ(nodes[1].speed, 2);
  EXPECT_EQ(nodes[2].speed, reachable_speed(2, 7, {1000, 300}));
  EXPECT_EQ(nodes[2].speed, known[2].speed);
}

TEST(NodePlan, ANodeIsLoweredToWhatTheNextCanBeReachedFrom) {
  const std::vector<PlanElement> elements{element(50, 80), element(0.05, 40), element(0.5, 5),
                                          element(50, 80)};
  const auto nodes = plan_nodes(elements, ceilings(elements));
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const SpanLimits span = span_limits(elements, nodes[n].junction, nodes[n + 1].junction);
    EXPECT_LE(ramp_length(nodes[n].speed, nodes[n + 1].speed, span.ramp()), span.length * (1 + 1e-9));
  }
}

TEST(NodePlan, LevelJunctionsAreNodesInAnyCase) {
  const std::vector<PlanElement> elements(10, element(1, 30));
  const std::vector<std::uint32_t> level{3, 4};
  const auto nodes = plan_nodes(elements, ceilings(elements), level);
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_EQ(nodes[1].junction, 3u);
  EXPECT_EQ(nodes[2].junction, 4u);
}

/// Every gap has a feasible law that passes nothing too fast, from standstill to standstill.
void expect_kept(const std::vector<PlanElement>& elements, const std::vector<PlanNode>& nodes) {
  const auto ceiling = ceilings(elements);
  ASSERT_EQ(nodes.front().speed, 0);
  ASSERT_EQ(nodes.back().speed, 0);
  ASSERT_EQ(nodes.back().junction, elements.size());
  for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
    const std::size_t first = nodes[n].junction;
    const std::size_t last = nodes[n + 1].junction;
    ASSERT_LT(first, last);
    const SpanLimits span = span_limits(elements, first, last);
    const SpeedProfile profile =
        plan_profile(nodes[n].speed, 0, nodes[n + 1].speed, span.length, span.ceiling, span.ramp());
    ASSERT_TRUE(profile.feasible) << "node " << n;
    ASSERT_EQ(first_too_fast(elements, ceiling, first, last, profile), last) << "node " << n;
  }
}

TEST(NodePlan, KeepsEveryCeilingAndEveryRampOnRandomStretches) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int run = 0; run < 300; ++run) {
    SCOPED_TRACE(run);
    std::vector<PlanElement> elements;
    const int count = 1 + static_cast<int>(200 * unit(random));
    for (int i = 0; i < count; ++i) {
      elements.push_back(element(std::pow(10, 4 * unit(random) - 3), std::pow(10, 3 * unit(random) - 1),
                                 5000 + 15000 * unit(random)));
    }
    expect_kept(elements, plan_nodes(elements, ceilings(elements)));
  }
}

TEST(NodePlan, PlannedAgainKeepsEveryCeilingAndIsAsFastAsPlannedFromTheStart) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  double again_time = 0;
  double new_time = 0;
  for (int run = 0; run < 200; ++run) {
    SCOPED_TRACE(run);
    std::vector<PlanElement> elements;
    const std::uint32_t count = 50 + static_cast<std::uint32_t>(500 * unit(random));
    for (std::uint32_t i = 0; i < count; ++i) {
      elements.push_back(element(std::pow(10, 2 * unit(random) - 2), 5 + 50 * unit(random)));
    }
    std::vector<bool> is_level(count);
    const auto level = [&] {
      std::vector<std::uint32_t> junctions;
      for (std::uint32_t j = 1; j < count; ++j) {
        if (is_level[j]) {
          junctions.push_back(j);
        }
      }
      return junctions;
    };
    std::vector<PlanNode> nodes = plan_nodes(elements, ceilings(elements));
    for (int round = 0; round < 4; ++round) {
      std::vector<std::uint32_t> changed;
      for (std::uint32_t e = 1; e + 1 < count; ++e) {
        if (unit(random) < 0.02) {
          changed.push_back(e);
          const double acceleration = elements[e].acceleration().value * unit(random);
          const double jerk = elements[e].jerk().value * unit(random);
          elements[e].set_ramps({acceleration, 0}, {jerk, 0});
          is_level[e] = is_level[e + 1] = unit(random) < 0.8;
        }
      }
      nodes = plan_nodes_again(elements, ceilings(elements), level(), nodes, changed);
      expect_kept(elements, nodes);
      for (const std::uint32_t j : level()) {
        EXPECT_TRUE(
            std::any_of(nodes.begin(), nodes.end(), [&](const PlanNode& n) { return n.junction == j; }));
      }
    }
    again_time += duration(elements, nodes);
    new_time += duration(elements, plan_nodes(elements, ceilings(elements), level()));
  }
  EXPECT_NEAR(again_time / new_time, 1, 1e-3);
}

TEST(NodePlan, KeepsEveryCeilingOnStairsThatRiseBlockByBlock) {
  // Every place is slower than the next: the worst case for taking the slowest places first.
  std::vector<PlanElement> elements;
  for (int i = 0; i < 20000; ++i) {
    elements.push_back(element(0.01, 1 + 0.001 * i));
  }
  expect_kept(elements, plan_nodes(elements, ceilings(elements)));
}

TEST(NodePlan, ALongStretchIsPlannedInPartsAsItWouldBeInOneGo) {
  // With slow ramps over short blocks a ramp is longer than a part, so that ends of parts are not kept.
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int run = 0; run < 24; ++run) {
    SCOPED_TRACE(run);
    const double length = std::pow(10, -3 * unit(random));
    const double jerk = std::pow(10, 1 + 3 * unit(random));
    const std::uint32_t count = 3000 + static_cast<std::uint32_t>(12000 * unit(random));
    std::vector<PlanElement> elements;
    std::vector<std::uint32_t> level;
    for (std::uint32_t i = 0; i < count; ++i) {
      const double slow = unit(random) < 0.01 ? 0.05 : 1;
      elements.push_back(element(length * (0.5 + unit(random)), slow * (50 + 50 * unit(random)), jerk));
      if (run % 3 > 0 && i > 0 && unit(random) < (run % 3 == 1 ? 0.001 : 0.2)) {
        level.push_back(i);
      }
    }
    std::vector<std::uint32_t> junctions{0};
    junctions.insert(junctions.end(), level.begin(), level.end());
    junctions.push_back(count);
    const std::vector<SpeedBound> ceiling = ceilings(elements);
    NodePlanner whole(elements, ceiling);
    ASSERT_EQ(whole.plan(junctions, 0), NodePlanner::Outcome::planned);

    const std::vector<PlanNode> nodes = plan_nodes(elements, ceiling, level);
    ASSERT_EQ(nodes.size(), whole.nodes().size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      ASSERT_EQ(nodes[n].junction, whole.nodes()[n].junction);
      ASSERT_EQ(nodes[n].speed, whole.nodes()[n].speed);
      ASSERT_EQ(nodes[n].cause, whole.nodes()[n].cause);
    }
  }
}

TEST(NodePlanner, SaysWhichEndCannotKeepItsSpeed) {
  const std::vector<PlanElement> elements{element(1, 50), element(0.01, 50), element(1, 2), element(0.01, 50),
                                          element(1, 50)};
  const std::vector<SpeedBound> ceiling = ceilings(elements);
  NodePlanner planner(elements, ceiling);
  EXPECT_EQ(planner.plan(std::vector<std::uint32_t>{1, 2}, 0), NodePlanner::Outcome::begin_slower);
  EXPECT_EQ(planner.plan(std::vector<std::uint32_t>{3, 4}, 0), NodePlanner::Outcome::end_slower);
  EXPECT_EQ(planner.plan(std::vector<std::uint32_t>{2, 3}, 0), NodePlanner::Outcome::planned);
}

TEST(ProfileSpeeds, AreAboveASpeedWhereAWalkAlongTheProfileIs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int run = 0; run < 2000; ++run) {
    SCOPED_TRACE(run);
    const RampLimits limits{std::pow(10, 1 + 3 * unit(random)), std::pow(10, 2 + 3 * unit(random))};
    const double v0 = unit(random) < 0.2 ? 0 : 50 * unit(random);
    const double v1 = unit(random) < 0.2 ? 0 : 50 * unit(random);
    const double least = ramp_length(v0, v1, limits);
    const double length = least * (unit(random) < 0.2 ? 1 : 1 + 3 * unit(random)) + 1e-3;
    const SpeedProfile profile = plan_profile(v0, 0, v1, length, 60, limits);
    ASSERT_TRUE(profile.feasible);
    const ProfileSpeeds speeds(v0, v1, length, 60, limits);
    EXPECT_NEAR(speeds.largest(), profile.peak, 1e-9 * profile.peak);
    EXPECT_NEAR(profile_time(v0, v1, length, 60, limits), profile.duration(), 1e-9 * profile.duration());
    const double speed = 60 * unit(random);
    const Bracket above = speeds.above(speed);
    ProfileWalk walk(profile);
    for (int i = 1; i < 64; ++i) {
      const double s = length * i / 64;
      const double v = walk.move_to(s).v;
      if (std::abs(v - speed) > 1e-6 * (1 + speed)) {
        EXPECT_EQ(v > speed, above.low < s && s < above.high) << "at " << s;
      }
    }
  }
}

TEST(ProfileSpeeds, AreInClosedFormOnAGentleRamp) {
  // The ramp takes 2 sqrt(20/500) = 0.4 s and 20/2 times that, 4 mm; half of the speed is reached after half
  // of the time, J t^3 / 6 from the start.
  const ProfileSpeeds speeds(0, 20, 4, 20, {1000, 500});
  const Bracket above = speeds.above(10);
  EXPECT_NEAR(above.low, 500 * 0.2 * 0.2 * 0.2 / 6, 1e-12);
  EXPECT_NEAR(above.high, 4, 1e-12);
  EXPECT_LT(speeds.above(20).high, speeds.above(20).low);
}

TEST(LookaheadHorizon, LetsTheToolStopWithinTheBlocksAhead) {
  std::vector<PlanElement> elements(100, element(0.1, 200));
  for (std::uint32_t i = 0; i < 100; ++i) {
    elements[i].order = i;
  }
  auto ceiling = ceilings(elements);
  apply_lookahead_horizon(elements, 8, ceiling);
  EXPECT_EQ(ceiling[50].cause.kind, CauseKind::lookahead_horizon);
  EXPECT_NEAR(ceiling[50].value, reachable_speed(0, 0.8, {1000, 15000}), 1e-9);
  EXPECT_DOUBLE_EQ(ceiling[99].value,
                   200);  // the end of the path is in sight: planned as a standstill anyway
}

}  // namespace
}  // namespace feedscope
