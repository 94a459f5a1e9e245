#pragma once

#include <QString>

#include "ui/circular/circular_job.h"
#include "ui/circular/circular_state.h"

namespace feedscope::ui {

/// The evaluated path and, of a program, the circles that were not evaluated, for the user.
QString circular_message(const CircularResult& result);

/// Headline of a picture of tests; the line below it has machine, model and evaluated path.
QString circular_picture_title();
QString circular_picture_details(const Setup& setup, bool actual);

/// The tests of these radii [mm] and feeds [mm/min] in one table. Throws InputError with value and bound,
/// also for too many tests.
std::vector<CircularRequest> requests_of(const CircularState& state);

}  // namespace feedscope::ui
