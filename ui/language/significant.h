#pragma once

#include <QString>

namespace feedscope::ui {

/// A number with `digits` significant digits, without decimals for large numbers, with an exponent only for
/// tiny and huge ones, where people would write one.
QString significant_number(double value, int digits);

}  // namespace feedscope::ui
