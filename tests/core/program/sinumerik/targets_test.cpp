#include "core/program/sinumerik/geometry/targets.h"

#include <gtest/gtest.h>

#include "tests/core/program/sinumerik/part_bench.h"

namespace feedscope::sinumerik {
namespace {

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-12)
      << actual.transpose() << " instead of " << expected.transpose();
}

struct SinumerikTargets : testing::Test {
  PartBench bench;
  Targets targets{bench.context};
  const Vec3 start{1, 2, 3};
};

TEST_F(SinumerikTargets, KeepMissingCoordinates) {
  bench.set('Y', 20);
  expect_near(targets.target(start), {1, 20, 3});
}

TEST_F(SinumerikTargets, AddIncrementsOfG91ButNotOfAC) {
  bench.context.modal.incremental = true;
  bench.set('X', 10);
  bench.set('Y', 10, Reading::absolute);
  expect_near(targets.target(start), {11, 10, 3});
}

TEST_F(SinumerikTargets, HalveDiametersOfX) {
  targets.set_diameters(Action::diameters_if_absolute);
  bench.set('X', 10);
  expect_near(targets.target(start), {5, 2, 3});
  bench.set('X', 10, Reading::incremental);
  expect_near(targets.target(start), {11, 2, 3});
}

TEST_F(SinumerikTargets, TakePolarWordsAboutThePole) {
  static const Function pole{"G111", Group::own_block, Action::pole_from_zero};
  bench.context.functions.own_block = &pole;
  bench.set('X', 10);
  targets.set_pole();
  bench.clear();
  bench.set(Address::ap, 90);
  bench.set(Address::rp, 5);
  expect_near(targets.target(start), {10, 5, 3});
}

TEST_F(SinumerikTargets, KeepTheAngleUpToAnotherPole) {
  bench.set(Address::ap, 90);
  bench.set(Address::rp, 5);
  targets.program_axes();
  bench.clear();
  bench.set(Address::rp, 7);
  expect_near(targets.target(start), {0, 7, 3});
  targets.end_polar_angle();
  expect_near(targets.target(start), {7, 0, 3});  // the angle of the position, which is the pole
}

TEST_F(SinumerikTargets, TraverseAChangeOfFrameWithTheNextIncrementOnly) {
  bench.path.line({10, 0, 0});
  targets.keep_coordinates();
  bench.path.set_frame(CoordinateFrame::shift({3, 0, 0}));  // the tool is at X7 now
  bench.set('X', 1, Reading::incremental);
  expect_near(targets.target(bench.path.position()), {11, 0, 0});
  targets.program_axes();
  expect_near(targets.target(bench.path.position()), {8, 0, 0});
}

TEST_F(SinumerikTargets, ReportAnAngleThatLeavesTheEndOpen) {
  bench.set(Address::ang, 90);
  bench.set('X', 5);
  expect_near(targets.target(start), {5, 2, 3});
  const std::vector<Diagnostic> diagnostics = bench.log.take();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].code, "line-angle");
}

}  // namespace
}  // namespace feedscope::sinumerik
