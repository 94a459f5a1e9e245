#pragma once

#include <string>
#include <vector>

#include "core/analysis/circularity/circular_test.h"
#include "core/analysis/circularity/full_circles.h"

namespace feedscope {

/// The full circles of a program as its run makes them.
struct ProgramCircles {
  /// In order of the program; a circle that is run in both directions at one feed is one test of two passes.
  std::vector<CircularTest> tests;
  std::size_t found = 0;      ///< circles
  std::size_t evaluated = 0;  ///< the first ones
  std::size_t helices = 0;    ///< as FullCircles
  std::size_t tilted = 0;
  bool actual = false;  ///< as CircularTest
};

/// Circles that are evaluated of one program, the first ones.
inline constexpr std::size_t max_program_circles = 200;

/// Evaluates every circle from where the control has reached it to where it leaves it: corners that it rounds
/// at both ends by curves of their own are not judged, CirclePass::evaluated says what is. Filters that
/// smooth the motion have no such curves: what they draw within the turn is judged. Throws Cancelled.
ProgramCircles program_circles(const Run& run, Progress* progress = nullptr);

/// What of the program is not evaluated and why, or that it has no full circle; a sentence each, in English.
std::vector<Message> program_circle_notes(const ProgramCircles& circles);

}  // namespace feedscope
