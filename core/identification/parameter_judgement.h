#pragma once

#include <vector>

#include "core/identification/identify.h"
#include "core/identification/parameter_search.h"

namespace feedscope {

/// Judges for each parameter at the present point of a search whether the traces determine it, and how well:
/// uncertainty, reason, bound. `start`: start values, in the units of the keys. `without`: cost of the best
/// explanation without each parameter.
std::vector<IdentifiedParameter> judge_parameters(ParameterSearch& search, const std::vector<double>& start,
                                                  const std::vector<double>& without);

/// Resets values that are not determined to their start values, as long as the traces show no effect; if the
/// traces give only a lower bound, to the smallest value that explains them no worse. Moves the search there.
void take_back(ParameterSearch& search, std::vector<IdentifiedParameter>& parameters);

/// Adds lower bounds to velocities without influence: at least the reach of the axes.
void add_reached_velocities(std::vector<IdentifiedParameter>& parameters, const FitCases& cases);

/// Which parameters change the residuals by more than noise when multiplied or divided by 1.5.
std::vector<bool> influences(ParameterSearch& search);

/// Which parameters act in steps, like a tolerance that determines a number of chords: a factor of 1.5 has an
/// effect, a small change has none at all.
std::vector<bool> acting_by_steps(ParameterSearch& search);

/// Whether the residuals at the present point of a search can be noise alone: no larger than noise, and no
/// larger for long stretches than for short ones. The effect of a wrong number grows with the length of the
/// stretch, noise does not.
bool leaves_noise_alone(ParameterSearch& search);

}  // namespace feedscope
