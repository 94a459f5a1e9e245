#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/analysis/circularity/circular_test.h"
#include "core/program/dialect.h"

namespace feedscope {

/// ISO program of one simulated test, and the lines of its circles.
struct SimulatedCircles {
  std::string text;
  std::array<std::uint32_t, 2> lines{};  ///< counter-clockwise, clockwise
};

/// Both directions, with a pause of half a second before and after each. Throws InputError with value and
/// bound.
SimulatedCircles simulated_circles(const CircularRequest& request);

/// Program of several tests for a real machine with a control of `dialect`, readable for operators: the
/// centre of the circles is the zero point, feeds and radii are in comments, with a pause before and after
/// every circle and no motion across the plane. Throws as simulated_circles() does.
std::string test_program(std::span<const CircularRequest> requests, Dialect dialect);

}  // namespace feedscope
