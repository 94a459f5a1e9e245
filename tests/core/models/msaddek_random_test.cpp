#include <gtest/gtest.h>

#include <random>

#include "core/models/control_model.h"
#include "tests/support/parts.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double tolerance = 0.01;

/// What must hold on any path beyond what tests/contract looks at, with and without compaction [mm].
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
  static void for_each_run(F check) {
    std::mt19937 random(12);
    for (int i = 0; i < 150; ++i) {
      SCOPED_TRACE(i);
      const Toolpath path = testing::random_path(random, 1 + i);
      check(path, find_model("msaddek").simulate(path, testing::spinner(), settings("dynamic")));
      if (HasFatalFailure()) {
        return;
      }
    }
  }
};

TEST_P(MsaddekOnRandomPaths, KeepsTheContourTolerance) {
  for_each_run([](const Toolpath&, const Trajectory& run) {
    ASSERT_LE(run.compaction_error(), tolerance);
    for (const BlendRecord& arc : testing::blends_of(run)) {
      ASSERT_LE(arc.epsilon, tolerance);
    }
  });
}

TEST_P(MsaddekOnRandomPaths, DynamicFeedStaysBelowTheStaticFeedOfEveryElement) {
  for_each_run([](const Toolpath& path, const Trajectory& run) {
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

INSTANTIATE_TEST_SUITE_P(Compaction, MsaddekOnRandomPaths, ::testing::Values(0.0, 2.0),
                         [](const auto& length) {
                           return length.param > 0 ? "WithCompaction" : "WithoutCompaction";
                         });

}  // namespace
}  // namespace feedscope
