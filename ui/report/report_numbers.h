#pragma once

#include <QDateTime>
#include <QString>

#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

/// `value` with so many decimals; as all numbers of reports by the language in force.
QString fixed(double value, int decimals);
/// `value` with at most so many significant digits, without an exponent where people would not write one.
QString significant(double value, int digits);
/// The same of a value in the core's unit, shown in that of the unit system: a number without its unit.
QString fixed(double value, Dimension dimension, int metric_decimals = -1);
QString significant(double value, Dimension dimension, int digits);
/// A share in percent without its sign; "–" for one that is not a number.
QString percent(double share, int decimals);
/// A contour error [mm] as the window shows it, without its unit.
QString error_number(double millimetres);
/// A change in percent with one decimal and its sign, "−1.2" or "+3.4"; what rounds to nothing is "0.0".
QString signed_percent(double share);
/// A day as the language writes it; empty for an invalid one.
QString date_text(const QDateTime& date);

}  // namespace feedscope::ui
