#pragma once

namespace feedscope {

/// The unit that a key of machine files and --set carries, against the one inside.
struct KeyConversion {
  double (*to_internal)(double);
  double (*to_unit)(double);
};

/// The shortest decimal number in the unit that converts to exactly `internal`: 20, not 20.000000000000004.
double shortest_in_unit(double internal, const KeyConversion& conversion);

}  // namespace feedscope
