#pragma once

#include <string>
#include <vector>

#include "core/analysis/circularity/circular_test.h"
#include "core/analysis/circularity/full_circles.h"

namespace feedscope {

/// Full circles of a program as executed in its run.
struct ProgramCircles {
  /// In order of the program; a circle that is run in both directions at one feed is one test with two
  /// passes.
  std::vector<CircularTest> tests;
  std::size_t found = 0;      ///< number of circles
  std::size_t evaluated = 0;  ///< number of circles evaluated, the first ones
  std::size_t helices = 0;    ///< as in FullCircles
  std::size_t tilted = 0;
  bool actual = false;  ///< as in CircularTest
};

/// Largest number of circles evaluated per program, the first ones.
inline constexpr std::size_t max_program_circles = 200;

/// Evaluates every circle from the place where the control reaches it to the place where it leaves it.
/// Corners at both ends that the control rounds by its own curves are excluded, see CirclePass::evaluated.
/// Filters that smooth the motion have no such curves: their effect within the turn is included. Throws
/// Cancelled.
ProgramCircles program_circles(const Run& run, Progress* progress = nullptr);

/// Parts of the program that are not evaluated, with the reason, or that it has no full circle; one sentence
/// each, in English.
std::vector<Message> program_circle_notes(const ProgramCircles& circles);

}  // namespace feedscope
