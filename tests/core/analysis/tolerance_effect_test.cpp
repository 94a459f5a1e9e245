#include "core/analysis/notes/tolerance_effect.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

std::vector<ComparedRun> tolerance_effect_runs(const std::string& text, const std::string& model) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("corner.nc", text));
  return compare_runs(program, setups_to_compare({"spinner-mvc850"}, {model}, {0.01, 0.1}));
}

TEST(ToleranceEffect, ThereIsNoneWhereNothingIsBlended) {
  EXPECT_TRUE(tolerances_without_effect(tolerance_effect_runs("G1 X20 F3000\nX40\n", "essid")))
      << "a straight line";
  EXPECT_FALSE(tolerances_without_effect(tolerance_effect_runs("G1 X20 F3000\nY20\n", "essid")));
  EXPECT_FALSE(tolerances_without_effect(tolerance_effect_runs("G1 X20 F3000\nY20\n", "ward")))
      << "filters have no blends, but round the corner";
}

TEST(ToleranceEffect, OneToleranceIsNoComparison) {
  const std::vector<ComparedRun> runs = tolerance_effect_runs("G1 X20 F3000\nX40\n", "essid");
  EXPECT_FALSE(tolerances_without_effect(std::span(runs).first(1)));
  EXPECT_FALSE(tolerances_without_effect({}));
}

TEST(ToleranceEffect, BlendsAreTheReasonOnlyWhereTheirLimitsAct) {
  SlowerTolerance slower;
  slower.cause = {CauseKind::blend_radial_jerk, 0};
  EXPECT_NE(why_slower(slower), "");
  slower.cause = {CauseKind::axis_jerk, 0};
  EXPECT_EQ(why_slower(slower), "");
}

}  // namespace
}  // namespace feedscope
