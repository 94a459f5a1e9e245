#pragma once

#include <string>
#include <vector>

namespace feedscope::ui {

/// Round values of a scale.
struct Ticks {
  double step = 0;
  std::vector<double> values;       ///< multiples of step, rising
  std::vector<std::string> labels;  ///< as many decimals as the step needs, decimal point
};

/// The smallest of 1, 2 and 5 times a power of ten that is at least `step`; step > 0.
double round_up_125(double step);

/// Multiples of a round step in [minimum, maximum], at most `most` of them; none if the range is empty or not
/// finite or `most` is 0.
Ticks round_ticks(double minimum, double maximum, int most);

}  // namespace feedscope::ui
