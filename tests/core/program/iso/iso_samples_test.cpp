#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/program/program.h"

namespace feedscope {
namespace {

Program read_sample(const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs" / name;
  Program program = read_program(std::make_shared<const SourceText>(SourceText::from_file(file)));
  for (const Diagnostic& diagnostic : program.diagnostics) {
    ADD_FAILURE() << format(diagnostic, name);
  }
  return program;
}

TEST(IsoSamples, FanucBoresAreHelicesAtTheirPlaces) {
  const Program program = read_sample("fanuc_bores.nc");
  EXPECT_EQ(program.dialect, Dialect::fanuc);
  // 12 mm by 1.5 mm are eight turns, and one more cleans the ground.
  ASSERT_EQ(program.arcs.size(), 4U * 9);
  for (std::size_t i = 0; i < program.arcs.size(); ++i) {
    const ArcWords& arc = program.arcs[i];
    EXPECT_NEAR(std::abs(arc.center.x()), 40 / std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(std::abs(arc.center.y()), 40 / std::sqrt(2.0), 1e-9);
    EXPECT_EQ(arc.turns, 1);
  }
  EXPECT_EQ(program.bounds.min.z(), -12);
  const auto stops =
      std::count_if(program.motions.begin(), program.motions.end(), [&](const MotionBlock& block) {
        return program.path_controls[block.path_control].mode == PathMode::exact_stop;
      });
  EXPECT_EQ(stops, 3 * 2);
}

TEST(IsoSamples, LinuxCncSuperellipseIsOneInEveryPass) {
  const Program program = read_sample("linuxcnc_superellipse.ngc");
  EXPECT_EQ(program.dialect, Dialect::linuxcnc);
  std::vector<PathControl> passes;
  int points = 0;
  for (const MotionBlock& block : program.motions) {
    if (block.motion != Motion::line) {
      continue;
    }
    const PathControl& control = program.path_controls[block.path_control];
    if (passes.empty() || passes.back() != control) {
      passes.push_back(control);
    }
    const double x = std::abs(block.target.x()) / 30;
    const double y = std::abs(block.target.y()) / 20;
    EXPECT_NEAR(std::pow(x, 2.5) + std::pow(y, 2.5), 1, 1e-9);
    ++points;
  }
  EXPECT_EQ(points, 4 * (1 + 360));
  ASSERT_EQ(passes.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(passes[i].mode, PathMode::continuous);
    EXPECT_NEAR(passes[i].contour_tolerance.value(), 0.1 / std::pow(10, i), 1e-15);
    EXPECT_EQ(passes[i].compaction_tolerance, 0.0005);
  }
  EXPECT_EQ(passes[3].mode, PathMode::exact_stop);
}

}  // namespace
}  // namespace feedscope
