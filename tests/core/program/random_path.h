#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "core/program/program.h"

namespace feedscope {

/// Toolpaths to write down in a dialect and read back.
struct Move {
  Motion motion = Motion::line;
  Vec3 target;
  Vec3 center;   ///< arcs
  int axis = 2;  ///< arcs: normal of the plane
  bool ccw = true;
  double sweep = 0;
};

/// `helices`: arcs that rise.
inline std::vector<Move> random_path(std::mt19937& random, bool helices = true) {
  std::uniform_real_distribution<double> number(-100, 100);
  std::uniform_real_distribution<double> angle(0.05, 2 * std::numbers::pi - 0.05);
  std::vector<Move> path;
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 40; ++i) {
    Move move;
    const int kind = static_cast<int>(random() % 3);
    if (kind < 2) {
      move.motion = kind == 0 ? Motion::rapid : Motion::line;
      move.target = {number(random), number(random), number(random)};
    } else {
      move.motion = Motion::arc;
      move.axis = static_cast<int>(random() % 3);
      move.ccw = random() % 2 == 0;
      move.sweep = angle(random);
      const Vec3 normal = Vec3::Unit(move.axis);
      Vec3 offset(number(random), number(random), number(random));
      offset[move.axis] = 0;
      move.center = position + offset;
      const double turn = move.ccw ? move.sweep : -move.sweep;
      move.target = move.center - std::cos(turn) * offset - std::sin(turn) * normal.cross(offset);
      move.target[move.axis] += helices ? number(random) : 0;
    }
    path.push_back(move);
    position = move.target;
  }
  return path;
}

/// One motion a move, at 10 mm/s; in line `first_line` and those behind it, 0 for any.
inline void expect_same(const std::vector<Move>& path, const ReadProgram& program, std::uint32_t first_line) {
  ASSERT_EQ(program.motions.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const MotionBlock& block = program.motions[i];
    ASSERT_EQ(block.motion, path[i].motion);
    ASSERT_LT((block.target - path[i].target).norm(), 1e-5);
    if (first_line > 0) {
      ASSERT_EQ(block.line, first_line + i);
    }
    if (block.motion == Motion::rapid) {
      continue;
    }
    ASSERT_NEAR(block.feed, 10, 1e-9);
    if (block.motion == Motion::arc) {
      const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
      // Nearly half and nearly full turns magnify the rounding of the text.
      ASSERT_LT((arc.center - path[i].center).norm(), 1e-2);
      const Vec3 axis = (path[i].ccw ? 1 : -1) * Vec3(Vec3::Unit(path[i].axis));
      ASSERT_LT((arc.axis - axis).norm(), 1e-6);
      ASSERT_EQ(arc.turns, 0);
    }
  }
}

}  // namespace feedscope
