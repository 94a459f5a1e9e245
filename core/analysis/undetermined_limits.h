#pragma once

#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// A number of a machine that the recordings it was identified from do not determine (is_undetermined()), and
/// that limits a run: a part of the cycle time rests on a guess.
struct UndeterminedLimit {
  std::string key;   ///< as --set takes it: "Z.acceleration"
  double time = 0;   ///< of the limiting causes that it sets; braking counts for the slower place ahead [s]
  double share = 0;  ///< of the cycle time
};

/// Those that limit more than a thousandth of the cycle time, the longest time first. Linear in pieces; a
/// machine without such numbers costs nothing.
std::vector<UndeterminedLimit> undetermined_limits(const Run& run);
/// As one sentence.
Message describe(const UndeterminedLimit& limit);

}  // namespace feedscope
