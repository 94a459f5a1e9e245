#pragma once

#include <QString>

namespace feedscope::ui {

/// `value` with so many decimals.
QString fixed(double value, int decimals);
/// `value` with at most so many significant digits, without an exponent where people would not write one.
QString significant(double value, int digits);
/// A change in percent with one decimal and its sign, "−1.2" or "+3.4"; what rounds to nothing is "0.0".
QString signed_percent(double share);

}  // namespace feedscope::ui
