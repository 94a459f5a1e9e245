#pragma once

#include <QString>

#include "core/analysis/run/tolerance_in_force.h"

namespace feedscope::ui {

/// "0.02", "0.01 … 0.05": [mm], by the locale; "–" for none.
QString tolerance_range(const std::optional<ToleranceInForce>& tolerance);

/// "0.02 mm".
QString tolerance_text(const ToleranceInForce& tolerance);

/// Origin of the tolerance, as a sentence.
QString tolerance_origin(const ToleranceInForce& tolerance);

}  // namespace feedscope::ui
