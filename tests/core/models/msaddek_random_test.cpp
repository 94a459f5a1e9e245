#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/models/control_model.h"
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
      for (std::size_t p = 0; p + 1 < run.pieces().size(); ++p) {
        const State end = run.state_in_piece(p, run.piece_end(p) - run.pieces()[p].time);
        const State next = run.state_in_piece(p + 1, 0);
        ASSERT_LT((end.position - next.position).norm(), 1e-7) << "piece " << p;
        ASSERT_TRUE(std::isfinite(end.speed));
        if (law == std::string("dynamic")) {
          ASSERT_NEAR(end.speed, next.speed, 1e-6 * (1 + end.speed)) << "piece " << p;
        }
      }
    });
  }
}

TEST_P(MsaddekOnRandomPaths, ElementsJoinWithoutAKinkExceptAtStops) {
  for_each_run("dynamic", [](const Toolpath&, const Trajectory& run) {
    const auto& elements = run.path().elements;
    for (std::size_t e = 0; e + 1 < elements.size(); ++e) {
      ASSERT_LT((elements[e].end - elements[e + 1].start).norm(), 1e-7) << "element " << e;
      const Vec3 out = run.path().at(elements[e], elements[e].length).d1;
      const Vec3 in = run.path().at(elements[e + 1], 0).d1;
      if ((out - in).norm() > 0.011) {
        ASSERT_LT(run.state_at_path(elements[e + 1].s).speed, 1e-2) << "element " << e;
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
    for (const BlendRecord& arc : run.blends()) {
      ASSERT_LE(arc.epsilon, tolerance);
    }
  });
}

TEST_P(MsaddekOnRandomPaths, DynamicFeedStaysBelowTheStaticFeedOfEveryElement) {
  for_each_run("dynamic", [](const Toolpath& path, const Trajectory& run) {
    const Trajectory fixed = find_model("msaddek").simulate(path, testing::spinner(), settings("static"));
    ASSERT_EQ(fixed.path().elements.size(), run.path().elements.size());
    ASSERT_GE(run.duration(), fixed.duration() * (1 - 1e-9));
    std::vector<double> ceiling(run.path().elements.size());
    for (const Piece& piece : fixed.pieces()) {
      ceiling[piece.element] = piece.v;
    }
    for (std::size_t p = 0; p < run.pieces().size(); ++p) {
      const double tau = run.piece_end(p) - run.pieces()[p].time;
      for (const double share : {0.0, 0.5, 1.0}) {
        const State state = run.state_in_piece(p, share * tau);
        ASSERT_LE(state.speed, ceiling[state.element] * 1.001 + 1e-9) << "piece " << p;
      }
    }
  });
}

TEST_P(MsaddekOnRandomPaths, KeepsEveryAxisOnLinesAndTwiceOverOnArcs) {
  const Machine machine = testing::spinner();
  for_each_run("dynamic", [&](const Toolpath&, const Trajectory& run) {
    for (std::size_t p = 0; p < run.pieces().size(); ++p) {
      for (const double share : {0.0, 0.5, 1.0}) {
        const State state = run.state_in_piece(p, share * (run.piece_end(p) - run.pieces()[p].time));
        const bool line = run.path().elements[state.element].kind == ElementKind::line;
        for (int j = 0; j < 3; ++j) {
          const AxisLimits& axis = machine.axes[static_cast<std::size_t>(j)];
          ASSERT_LE(std::abs(state.velocity[j]), axis.velocity * 1.001);
          ASSERT_LE(std::abs(state.acceleration[j]), axis.acceleration * (line ? 1 + 1e-6 : 2));
          if (line) {
            ASSERT_LE(std::abs(state.jerk[j]), axis.jerk * (1 + 1e-6)) << "piece " << p;
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
