#pragma once

#include <QString>

namespace feedscope::ui {

/// A number with `digits` significant ones, none behind the point for large numbers, no exponent but for tiny
/// ones.
QString significant_number(double value, int digits);

}  // namespace feedscope::ui
