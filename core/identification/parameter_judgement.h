#pragma once

#include <vector>

#include "core/identification/identify.h"
#include "core/identification/parameter_search.h"

namespace feedscope {

/// Judges of each parameter where a search stands whether the traces tell it, and how well: uncertainty,
/// reason, bound. `start`: values that were begun with, in the units of the keys.
/// `without`: by parameter the cost of the best explanation in which another one stands for it.
std::vector<IdentifiedParameter> judge_parameters(ParameterSearch& search, const std::vector<double>& start,
                                                  const std::vector<double>& without);

/// Values of what is not told become those that were begun with, as long as the traces do not show it; else,
/// where they show only what a value is at least, the smallest one that explains them no worse. Moves the
/// search there.
void take_back(ParameterSearch& search, std::vector<IdentifiedParameter>& parameters);

/// Of velocities of axes without influence that no trace asks for more: they are at least what the axes
/// reach.
void add_reached_velocities(std::vector<IdentifiedParameter>& parameters, const FitCases& cases);

/// Which parameters change the residuals by more than noise where they are half as large again or as small.
std::vector<bool> influences(ParameterSearch& search);

/// Which parameters act by steps, as a tolerance does that a number of chords follows from: half as much
/// again and as little show, but a little more or a little less changes nothing at all.
std::vector<bool> acting_by_steps(ParameterSearch& search);

/// Whether the residuals at the present place of a search can be noise alone: they are not larger than noise,
/// and those of long stretches are not larger than those of short ones. A wrong number makes them grow with
/// the length of the stretch, noise does not.
bool leaves_noise_alone(ParameterSearch& search);

}  // namespace feedscope
