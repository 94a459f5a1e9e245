#pragma once

#include <QString>

#include "ui/circular/circular_job.h"
#include "ui/circular/circular_state.h"

namespace feedscope::ui {

/// Which path was judged, and what of a program was not, for the user.
QString circular_message(const CircularResult& result);

/// Headline of a picture of tests, and below it machine, model and which path was judged.
QString circular_picture_title();
QString circular_picture_details(const Setup& setup, bool actual);

/// The tests of these radii [mm] and feeds [mm/min] in one table. Throws InputError naming value and bound,
/// also where they are too many.
std::vector<CircularRequest> requests_of(const CircularState& state);

}  // namespace feedscope::ui
