#pragma once

#include <string>
#include <vector>

namespace feedscope {

/// Round values of a scale.
struct Ticks {
  double step = 0;
  std::vector<double> values;       ///< multiples of step, ascending
  std::vector<std::string> labels;  ///< as many decimals as the step needs, decimal point
  double count = 0;                 ///< number of multiples of step in the whole scale
};

/// Smallest 1, 2 or 5 times a power of ten that is at least `step`; step > 0.
double round_up_125(double step);

/// Largest round step with at least two multiples between `low` and `high` > `low`.
double step_of_two(double low, double high);
/// Number of decimals of the multiples of `step` > 0, at most 12.
int step_decimals(double step);

/// Multiples of a round step in [minimum, maximum], at most `most` of them, but at least two, since one
/// number alone is no scale; none if the range is empty or not finite.
Ticks round_ticks(double minimum, double maximum, int most);
/// As round_ticks() for times in seconds: from a minute on, the steps are round on a clock, such as 15 s, 30
/// s and 5 min.
Ticks clock_ticks(double minimum, double maximum, int most);
/// Same scale with only the values from `low` to `high`, for a scale of which a small part is shown. At most
/// 1000 values; beyond that the step is larger.
Ticks round_ticks_between(double minimum, double maximum, double most, double low, double high);

/// Multiples of `step` from `low` to `high`, ascending; with a larger round step if there are more than 1000.
/// None unless the step is above 0.
std::vector<double> multiples(double step, double low, double high);

/// Label of a multiple of `step`.
std::string tick_label(double value, double step);

}  // namespace feedscope
