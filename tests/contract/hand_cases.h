#pragma once

#include <string>
#include <vector>

namespace feedscope::contract {

/// A program that somebody thought of, by name.
struct HandCase {
  std::string name;
  std::vector<std::string> lines;
};

/// One block and none, corners of every angle, reversals, collinear blocks, circles, helices, tangent and
/// other junctions of lines and arcs, dwells, rapids, blocks of 1e-6 mm and 1 m, slow and fast feeds, points
/// that repeat.
std::vector<HandCase> hand_cases();

}  // namespace feedscope::contract
