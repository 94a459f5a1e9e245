#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/program/program.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

ReadProgram read_sample(const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs" / name;
  ReadProgram program = read_program(std::make_shared<const SourceText>(SourceText::from_file(file)));
  for (const Diagnostic& diagnostic : program.diagnostics) {
    ADD_FAILURE() << format(diagnostic, name);
  }
  return program;
}

TEST(IsoSamples, FanucBoresAreHelicesAtTheirPlaces) {
  const ReadProgram program = read_sample("fanuc_bores.nc");
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

TEST(IsoSamples, FanucFlangeKeepsTheCutterBesideItsContours) {
  const ReadProgram program = read_sample("fanuc_flange.nc");
  EXPECT_EQ(program.dialect, Dialect::fanuc);
  // Outside: 10 mm corners and a cutter of 6 mm radius; slots: half circles of 7 mm and one of 4 mm.
  std::vector<double> radii;
  for (std::size_t i = 1; i < program.motions.size(); ++i) {
    const MotionBlock& block = program.motions[i];
    if (block.motion == Motion::arc) {
      const ArcWords& arc = program.arcs[static_cast<std::size_t>(block.arc)];
      radii.push_back(std::round((block.target - arc.center).norm() * 1e6) / 1e6);
    }
  }
  EXPECT_EQ(std::count(radii.begin(), radii.end(), 16), 4);
  EXPECT_EQ(std::count(radii.begin(), radii.end(), 14), 1);
  EXPECT_EQ(std::count(radii.begin(), radii.end(), 3), 8);
  EXPECT_EQ(radii.size(), 13U);
  const auto at_bottom = [&](double level) {
    return std::count_if(program.motions.begin(), program.motions.end(),
                         [&](const MotionBlock& block) { return block.target.z() == level; });
  };
  EXPECT_EQ(at_bottom(-15), 8) << "holes";
  EXPECT_EQ(at_bottom(-12), 8) << "threads";
  for (const MotionBlock& block : program.motions) {
    if (block.target.z() == -15) {
      EXPECT_NEAR(block.target.head<2>().norm(), 16, 1e-9);
    }
  }
}

TEST(IsoSamples, LinuxCncSuperellipseIsOneInEveryPass) {
  const ReadProgram program = read_sample("linuxcnc_superellipse.ngc");
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
