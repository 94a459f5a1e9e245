#pragma once

#include <QString>
#include <string>

#include "core/analysis/notes/slower_tolerance.h"

namespace feedscope::ui {

/// A time for people, as short_time(): "12.3 ms", "48.5 s", from a minute on "1:48.5", from an hour on
/// "1:02:05"; decimal sign by the locale.
QString clock_text(double seconds);
/// A share in whole percent, below one with its first non-zero digit: "8 %", "0.3 %".
QString share_text(double share);

/// Title of a swept quantity in the user's language: "X Jerk" for "X.jerk", "Contour tolerance" for
/// "tolerance"; the key itself if unknown.
QString setting_title(const std::string& key);
/// The same with the unit in which values of the key are written: "X Jerk [m/s³]".
QString setting_title_with_unit(const std::string& key);
/// That unit: "m/s³"; "" for a quantity without one.
QString setting_unit(const std::string& key);

/// States that a wider contour tolerance takes longer than a narrower one, and why.
QString slower_tolerance_text(const SlowerTolerance& slower);

}  // namespace feedscope::ui
