#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// Round values of a scale.
struct Ticks {
  double step = 0;
  std::vector<double> values;       ///< multiples of step, rising
  std::vector<std::string> labels;  ///< as many decimals as the step needs, decimal point
  double count = 0;                 ///< multiples of step in all of the scale
};

/// The smallest of 1, 2 and 5 times a power of ten that is at least `step`; step > 0.
double round_up_125(double step);

/// The largest round step of which at least two multiples lie between `low` and `high` > `low`: as far apart
/// as round numbers allow.
double step_of_two(double low, double high);
/// How many decimals the multiples of `step` > 0 have, 12 at most.
int step_decimals(double step);

/// Multiples of a round step in [minimum, maximum], at most `most` of them; none if the range is empty or not
/// finite or `most` is 0.
Ticks round_ticks(double minimum, double maximum, int most);
/// The same scale, its values from `low` to `high` alone: for a scale of which a small part is shown. At most
/// 1000 values; beyond, the step is larger.
Ticks round_ticks_between(double minimum, double maximum, double most, double low, double high);

/// Multiples of `step` from `low` to `high`, rising; where they are more than 1000, of a larger round step.
/// None of a step that is not above 0.
std::vector<double> multiples(double step, double low, double high);

/// A multiple of `step`, as labels have it.
std::string tick_label(double value, double step);

}  // namespace feedscope
