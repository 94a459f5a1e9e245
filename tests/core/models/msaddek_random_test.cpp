#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/models/control_model.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double tolerance = 0.01;

/// What must hold on any path, with and without compaction [mm].
class MsaddekOnRandomPaths : public ::testing::TestWithParam<double> {
 protected:
  static Settings settings(const char* law) {
    Settings settings = complete_settings(find_model("msaddek"), testing::spinner());
    settings.set("contour_tolerance_mm", tolerance);
    settings.set("compaction_mm", GetParam());
    settings.set("law", std::string(law));
    return settings;
  }

  template <typename F>
  static void for_each_run(const char* law, F check) {
    std::mt19937 random(12);
    for (int i = 0; i < 150; ++i) {
      SCOPED_TRACE(i);
      const Toolpath path = testing::random_path(random, 1 + i);
      check(path, find_model("msaddek").simulate(path, testing::spinner(), settings(law)));
      if (HasFatalFailure()) {
        return;
      }
    }
  }
};

TEST_P(MsaddekOnRandomPaths, PathHasNoGapsAndDynamicFeedDoesNotJump) {
  for (const char* law : {"static", "dynamic"}) {
    for_each_run(law, [law](const Toolpath&, const Trajectory& run) {
      const std::vector<Part> parts = testing::parts_of(run);
      for (std::size_t p = 0; p + 1 < parts.size(); ++p) {
        const State end = testing::state_in(run, parts[p], parts[p].duration);
        const State next = testing::state_in(run, parts[p + 1], 0);
        ASSERT_LT((end.position - next.position).norm(), 1e-7) << "part at " << parts[p].time;
        ASSERT_TRUE(std::isfinite(end.speed));
        if (law == std::string("dynamic")) {
          ASSERT_NEAR(end.speed, next.speed, 1e-6 * (1 + end.speed)) << "part at " << parts[p].time;
        }
      }
    });
  }
}

TEST_P(MsaddekOnRandomPaths, ElementsJoinWithoutAKinkExceptAtStops) {
  for_each_run("dynamic", [](const Toolpath&, const Trajectory& run) {
    for (std::size_t e = 0; e + 1 < run.path().size(); ++e) {
      const ElementCurve before = run.path().curve(e);
      const ElementCurve after = run.path().curve(e + 1);
      ASSERT_LT((before.end - after.start).norm(), 1e-7) << "element " << e;
      if ((before.at(before.length).d1 - after.at(0).d1).norm() > 0.011) {
        ASSERT_LT(run.state_at_path(run.path().s(e + 1)).speed, 1e-2) << "element " << e;
      }
    }
  });
}

TEST_P(MsaddekOnRandomPaths, BeginsAndEndsAtTheProgrammedPointsAtRest) {
  for_each_run("dynamic", [](const Toolpath& path, const Trajectory& run) {
    ASSERT_LT((run.state(0).position - path.start).norm(), 1e-9);
    const State end = run.state(run.duration());
    ASSERT_LT((end.position - path.segments.back().end).norm(), 1e-6);
    ASSERT_LT(end.speed, 1e-3);
  });
}

TEST_P(MsaddekOnRandomPaths, KeepsTheContourTolerance) {
  for_each_run("dynamic", [](const Toolpath&, const Trajectory& run) {
    ASSERT_LE(run.compaction_error(), tolerance);
    for (const BlendRecord& arc : testing::blends_of(run)) {
      ASSERT_LE(arc.epsilon, tolerance);
    }
  });
}

TEST_P(MsaddekOnRandomPaths, DynamicFeedStaysBelowTheStaticFeedOfEveryElement) {
  for_each_run("dynamic", [](const Toolpath& path, const Trajectory& run) {
    const Trajectory fixed = find_model("msaddek").simulate(path, testing::spinner(), settings("static"));
    ASSERT_EQ(fixed.path().size(), run.path().size());
    ASSERT_GE(run.duration(), fixed.duration() * (1 - 1e-9));
    std::vector<double> ceiling(run.path().size());
    for (const Piece& piece : fixed.pieces()) {
      ceiling[piece.element] = piece.v;
    }
    for (const Part& part : testing::parts_of(run)) {
      const double tau = part.duration;
      for (const double share : {0.0, 0.5, 1.0}) {
        const State state = testing::state_in(run, part, share * tau);
        ASSERT_LE(state.speed, ceiling[state.element] * 1.001 + 1e-9) << "part at " << part.time;
      }
    }
  });
}

TEST_P(MsaddekOnRandomPaths, KeepsEveryAxisOnLinesAndTwiceOverOnArcs) {
  const Machine machine = testing::spinner();
  for_each_run("dynamic", [&](const Toolpath&, const Trajectory& run) {
    for (const Part& part : testing::parts_of(run)) {
      for (const double share : {0.0, 0.5, 1.0}) {
        const State state = testing::state_in(run, part, share * part.duration);
        const bool line = run.path().kind(state.element) == ElementKind::line;
        for (int j = 0; j < 3; ++j) {
          const AxisLimits& axis = machine.axes[static_cast<std::size_t>(j)];
          ASSERT_LE(std::abs(state.velocity[j]), axis.velocity * 1.001);
          ASSERT_LE(std::abs(state.acceleration[j]), axis.acceleration * (line ? 1 + 1e-6 : 2));
          if (line) {
            ASSERT_LE(std::abs(state.jerk[j]), axis.jerk * (1 + 1e-6)) << "part at " << part.time;
          }
        }
      }
    }
  });
}

TEST_P(MsaddekOnRandomPaths, GivesTheSameBytesAgain) {
  std::mt19937 random(10);
  const Toolpath path = testing::random_path(random, 200);
  const auto run = [&] {
    return find_model("msaddek").simulate(path, testing::spinner(), settings("dynamic"));
  };
  const Trajectory a = run();
  const Trajectory b = run();
  ASSERT_EQ(a.pieces().size(), b.pieces().size());
  EXPECT_EQ(a.duration(), b.duration());
}

INSTANTIATE_TEST_SUITE_P(Compaction, MsaddekOnRandomPaths, ::testing::Values(0.0, 2.0),
                         [](const auto& length) {
                           return length.param > 0 ? "WithCompaction" : "WithoutCompaction";
                         });

}  // namespace
}  // namespace feedscope
