#pragma once

#include <QString>

namespace feedscope::ui {

/// `value` with so many decimals.
QString fixed(double value, int decimals);
/// `value` with at most so many significant digits, without an exponent where people would not write one.
QString significant(double value, int digits);
/// "m/s³" for "m/s3".
QString unit_text(const std::string& unit);

}  // namespace feedscope::ui
