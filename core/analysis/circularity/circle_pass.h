#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/circularity/circle_plane.h"
#include "core/analysis/circularity/circularity.h"
#include "core/analysis/run/run.h"
#include "core/base/roots.h"

namespace feedscope {

/// One direction of a circular test.
struct CirclePass {
  bool counter_clockwise = true;  ///< from the first axis of the plane to the second
  double start = 0;               ///< programmed angle from the first axis [rad]
  double reached_feed = 0;        ///< largest on the set path [mm/s]
  double time = 0;                ///< of the circle [s]
  double evaluated = 0;           ///< angle covered by `places` [rad]
  std::uint32_t first_line = 0;   ///< blocks of a program's circle; else 0
  std::uint32_t last_line = 0;
  /// At equal time steps, relative to the programmed centre [mm].
  std::vector<Eigen::Vector2d> places;
  Circularity circularity;

  const char* direction() const { return counter_clockwise ? "ccw" : "cw"; }
};

/// Number of places of one pass.
inline constexpr std::size_t circle_places = 3600;

/// Position and size of a circle.
struct CircleFrame {
  CirclePlane plane = CirclePlane::xy;
  Vec3 center = Vec3::Zero();  ///< [mm]
  double radius = 0;           ///< nominal [mm]
};

/// Evaluates a run between two times [s], on its actual path if the machine has drives. Direction, start and
/// lines keep the defaults of CirclePass.
CirclePass pass_between(const Run& run, const Bracket& time, const CircleFrame& frame);

}  // namespace feedscope
