#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>

#include "tests/core/program/sinumerik/read_sinumerik.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

/// Only that curves have become arcs may be said of a sample.
ReadProgram read_sample(const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs" / name;
  ReadProgram program = read_program(std::make_shared<const SourceText>(SourceText::from_file(file)));
  EXPECT_EQ(program.dialect, Dialect::sinumerik);
  for (const Diagnostic& diagnostic : program.diagnostics) {
    EXPECT_TRUE(diagnostic.code == "curve-as-arcs" || diagnostic.code == "machining-mode")
        << format(diagnostic, name);
  }
  return program;
}

TEST(SinumerikSamples, PlateHasFourPocketsTwiceAndTenHoles) {
  const ReadProgram program = read_sample("sinumerik_plate.mpf");
  // A helix, a circle and four corners in each of three rounds.
  EXPECT_EQ(program.arcs.size(), 2U * 4 * (2 + 3 * 4));
  EXPECT_NEAR(program.bounds.max.x(), 55, 1e-9);
  EXPECT_NEAR(program.bounds.min.y(), -35, 1e-9);
  std::set<std::pair<int, int>> holes;
  double deepest = 0;
  for (const MotionBlock& block : program.motions) {
    if (block.motion == Motion::line && block.target.z() < -15) {
      holes.emplace(std::lround(block.target.x() * 100), std::lround(block.target.y() * 100));
    }
    deepest = std::min(deepest, block.target.z());
  }
  EXPECT_EQ(holes.size(), 10U);
  EXPECT_DOUBLE_EQ(deepest, -16);
}

TEST(SinumerikSamples, PlateIsFinishedWithinATenthOfTheRoughingTolerance) {
  const ReadProgram program = read_sample("sinumerik_plate.mpf");
  std::set<double> tolerances;
  for (const MotionBlock& block : program.motions) {
    if (const auto tolerance = program.path_controls.at(block.path_control).contour_tolerance) {
      tolerances.insert(*tolerance);
    }
  }
  EXPECT_EQ(tolerances, (std::set<double>{0.005, 0.05}));
}

TEST(SinumerikSamples, WaveIsTheSameByLinesAndBySplines) {
  const ReadProgram program = read_sample("sinumerik_wave.mpf");
  constexpr double degree = std::numbers::pi / 180;
  int lines = 0;
  double spline_error = 0;
  for (const MotionBlock& block : program.motions) {
    const Vec3& p = block.target;
    const double wave = 6 * std::sin(6 * p.x() * degree);
    if (block.motion == Motion::line && p.y() <= 30) {
      EXPECT_NEAR(p.z(), wave, 1e-9);
      ++lines;
    } else if (block.motion != Motion::rapid && std::abs(p.y() - 40) < 1e-9) {
      spline_error = std::max(spline_error, std::abs(p.z() - wave));
    } else if (block.motion == Motion::arc && std::abs(p.y() - 60) < 1e-9) {
      const double u = p.x() <= 30 ? p.x() / 30 : (p.x() - 30) / 30;
      EXPECT_NEAR(p.z(), (p.x() <= 30 ? 24 : -24) * u * (1 - u), 0.0013);
    }
  }
  EXPECT_EQ(lines, 3 * 61);
  // Seven points of a wave, parameter by chords: close, not equal.
  EXPECT_LT(spline_error, 0.3);
  EXPECT_GT(spline_error, 0.001);
}

}  // namespace
}  // namespace feedscope
