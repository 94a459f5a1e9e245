#pragma once

#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/message.h"

namespace feedscope {

/// A number of a machine that limits a run but is not determined by the recordings it was identified from
/// (is_undetermined()): part of the cycle time is based on a guess.
struct UndeterminedLimit {
  std::string key;   ///< as for --set: "Z.acceleration"
  double time = 0;   ///< of the causes that it determines; braking counts for the slower place ahead [s]
  double share = 0;  ///< of the cycle time
};

/// Limits active for more than a thousandth of the cycle time, longest first. Linear in pieces; free of cost
/// for a machine without such numbers.
std::vector<UndeterminedLimit> undetermined_limits(const Run& run);
/// As one sentence.
Message describe(const UndeterminedLimit& limit);

}  // namespace feedscope
