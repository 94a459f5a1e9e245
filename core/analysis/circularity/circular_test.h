#pragma once

#include <array>
#include <vector>

#include "core/analysis/circularity/circle_plane.h"
#include "core/analysis/circularity/circularity.h"
#include "core/analysis/run.h"

namespace feedscope {

/// A circular test: one circle in both directions.
struct CircularRequest {
  double radius = 0;  ///< > 0 [mm]
  double feed = 0;    ///< > 0 [mm/s]
  CirclePlane plane = CirclePlane::xy;
  double start = 0;  ///< angle from the first axis of the plane [rad]
  double sweep = 0;  ///< > 0, up to a full turn [rad]
  /// Of the quarter circles that lead into the circle and out of it; 0: from rest to rest [mm].
  double entry_radius = 0;
};

/// One direction of a test.
struct CirclePass {
  bool counter_clockwise = true;  ///< from the first axis of the plane to the second
  double reached_feed = 0;        ///< largest of the set path [mm/s]
  double time = 0;                ///< of the circle [s]
  /// At equal steps of the set path, from the programmed centre [mm].
  std::vector<Eigen::Vector2d> places;
  Circularity circularity;

  const char* direction() const { return counter_clockwise ? "ccw" : "cw"; }
};

/// What came out of a circular test.
struct CircularTest {
  CircularRequest request;
  std::array<CirclePass, 2> passes;  ///< counter-clockwise, clockwise
  Circularity both;                  ///< of the places of both
  bool actual = false;               ///< of the actual path; else of the set path: the machine has no drives

  double g_b() const { return both.zone; }                        ///< G(b) [mm]
  double d() const { return both.mean_radius - request.radius; }  ///< D [mm]
};

/// Number of places of one pass.
inline constexpr std::size_t circle_places = 3600;

/// Simulates the test. Throws InputError naming value and bound, and as simulate_run().
CircularTest run_circular_test(const CircularRequest& request, const Setup& setup,
                               Progress* progress = nullptr);

}  // namespace feedscope
