#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/machine/machine.h"

namespace feedscope::contract {

/// One run to be checked: NC text, a machine whose settings hold those of the run, a model.
struct Case {
  std::vector<std::string> lines;
  Machine machine;
  std::string model;
};

/// A program of 1 to some hundred blocks on a shipped machine, one with changed limits, or one made up, and
/// settings of `model` within their bounds. The same for the same arguments, whatever was made before.
///
/// Programs mix blocks of 1e-6 mm to 1 m, feeds of 1 to 60 000 mm/min, corners of all angles, collinear
/// blocks, reversals, repeated points, arcs and helices in all planes, tangent or not, full circles, dwells
/// and rapids.
Case random_case(const std::string& model, std::uint64_t seed, std::uint64_t number);

}  // namespace feedscope::contract
