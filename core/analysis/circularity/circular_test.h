#pragma once

#include <optional>
#include <vector>

#include "core/analysis/circularity/circle_pass.h"

namespace feedscope {

/// A circular test: one circle in both directions.
struct CircularRequest {
  double radius = 0;  ///< > 0 [mm]
  double feed = 0;    ///< > 0 [mm/s]
  CirclePlane plane = CirclePlane::xy;
  double start = 0;  ///< angle from the first axis of the plane [rad]
  double sweep = 0;  ///< > 0, up to a full turn [rad]
  /// Radius of the quarter circles that lead into and out of the circle [mm]; 0: from rest to rest.
  double entry_radius = 0;
};

/// Result of a circular test, or of a circle of a program.
struct CircularTest {
  CircularRequest request;
  Vec3 center = Vec3::Zero();       ///< programmed [mm]
  std::vector<CirclePass> passes;   ///< counter-clockwise, clockwise; for a program, in its order
  std::optional<Circularity> both;  ///< for the places of both directions; none with only one
  bool actual = false;              ///< on the actual path; else on the set path: the machine has no drives

  /// G(b) [mm]
  std::optional<double> g_b() const { return both ? std::optional(both->zone) : std::nullopt; }
  /// D [mm]
  std::optional<double> d() const {
    return both ? std::optional(both->mean_radius - request.radius) : std::nullopt;
  }
  /// Mean radial deviation of one direction [mm].
  double mean_deviation(const CirclePass& pass) const {
    return pass.circularity.mean_radius - request.radius;
  }
  bool of_program() const { return !passes.empty() && passes.front().first_line > 0; }
  const char* path() const { return actual ? "actual" : "set"; }
  /// Evaluates the places of all passes together if there are several.
  void join();
};

/// Simulates the test. Throws InputError with value and bound, and as simulate_run().
CircularTest run_circular_test(const CircularRequest& request, const Setup& setup,
                               Progress* progress = nullptr);

}  // namespace feedscope
