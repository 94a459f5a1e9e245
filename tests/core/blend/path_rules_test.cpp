#include "core/blend/path_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/blend/junction.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

Settings settings(double tolerance, const char* program_tolerance = "on") {
  Settings values;
  values.set("contour_tolerance_mm", tolerance);
  values.set("program_tolerance", program_tolerance);
  return values;
}

/// Three lines with two corners, the last two lines under a path control of which `member` is `value`.
template <typename T>
Toolpath corners_under(T PathControl::*member, T value) {
  PathControl control;
  control.*member = value;
  Toolpath path = testing::polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, 50);
  path.path_controls.push_back(control);
  path.segments[1].path_control = path.segments[2].path_control = 1;
  return path;
}

TEST(PathRules, WithoutPathControlTheSettingCounts) {
  const Toolpath path = corners_under(&PathControl::look_ahead, Switch::on);
  const PathRules rules(path, settings(0.02));
  EXPECT_EQ(rules.corner_tolerance(0), 0.02);
  EXPECT_EQ(rules.longest_blend(0), std::numeric_limits<double>::infinity());
}

TEST(PathRules, TheProgramsToleranceCountsAndTheSmallerOneWhereTwoMeet) {
  const Toolpath path = corners_under(&PathControl::contour_tolerance, std::optional(0.05));
  const PathRules rules(path, settings(0.02));
  EXPECT_EQ(rules.corner_tolerance(0), 0.02);
  EXPECT_EQ(rules.corner_tolerance(1), 0.05);
  EXPECT_EQ(PathRules(path, settings(0.02, "off")).corner_tolerance(1), 0.02);
}

TEST(PathRules, ABlendDistanceBoundsTheBlend) {
  const Toolpath path = corners_under(&PathControl::blend_distance, std::optional(0.5));
  const PathRules rules(path, settings(0.02));
  EXPECT_EQ(rules.longest_blend(1), 0.5);
  EXPECT_EQ(rules.corner_tolerance(1), 0.5) << "no blend strays farther than it reaches";
  EXPECT_EQ(PathRules(path, settings(0.02, "off")).longest_blend(1), std::numeric_limits<double>::infinity());
}

TEST(PathRules, ExactStopsAreStopsWhateverTheTolerance) {
  const Toolpath path = corners_under(&PathControl::mode, PathMode::exact_stop);
  EXPECT_EQ(junction_kind(path, 1), JunctionKind::corner) << "the block before does not ask for it";
  EXPECT_EQ(junction_kind(path, 2), JunctionKind::stop);
}

TEST(PathRules, BlocksOfOnePathControlThatAllowsItAreCompacted) {
  const Toolpath free = corners_under(&PathControl::contour_tolerance, std::optional(0.05));
  const PathRules rules(free, settings(0.02));
  EXPECT_TRUE(rules.may_compact(1, 2));
  EXPECT_FALSE(rules.may_compact(0, 1));
  const Toolpath forbidden = corners_under(&PathControl::compaction, Switch::off);
  EXPECT_FALSE(PathRules(forbidden, settings(0.02)).may_compact(1, 2));
}

}  // namespace
}  // namespace feedscope
