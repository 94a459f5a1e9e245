#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "core/analysis/circularity/circular_test.h"
#include "core/program/dialect.h"

namespace feedscope {

/// The ISO program of one test that is simulated, and the lines of its circles.
struct SimulatedCircles {
  std::string text;
  std::array<std::uint32_t, 2> lines{};  ///< counter-clockwise, clockwise
};

/// Both directions, with a pause of half a second before and behind each. Throws InputError naming value and
/// bound.
SimulatedCircles simulated_circles(const CircularRequest& request);

/// The program of several tests for a real machine with a control of `dialect`, to be read by people: the
/// centre of the circles is the zero point, feeds and radii in comments, a pause before and behind every
/// circle, and no motion across the plane. Throws as simulated_circles().
std::string test_program(std::span<const CircularRequest> requests, Dialect dialect);

}  // namespace feedscope
