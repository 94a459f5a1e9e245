#pragma once

#include <QDateTime>
#include <QString>

#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

/// `value` with this number of decimals, in the current language like all numbers of reports.
QString fixed(double value, int decimals);
/// A core value with decimals, in the shown unit system, without its unit.
QString fixed(double value, Dimension dimension, int metric_decimals = -1);
/// A share in percent without the sign; "–" for NaN.
QString percent(double share, int decimals);
/// A contour error [mm] as in the window, without its unit.
QString error_number(double millimetres);
/// A change in percent with one decimal and its sign, "−1.2" or "+3.4"; "0.0" if it rounds to zero.
QString signed_percent(double share);
/// A date in the format of the language; empty for an invalid one.
QString date_text(const QDateTime& date);

}  // namespace feedscope::ui
