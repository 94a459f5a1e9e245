#pragma once

#include <QString>
#include <string>

#include "core/analysis/slower_tolerance.h"

namespace feedscope::ui {

/// A time for people, as short_time(): "12.3 ms", "48.5 s", from a minute on "1:48.5", from an hour on
/// "1:02:05"; decimals by the locale.
QString clock_text(double seconds);
/// A share to a whole percent, below one to a figure that is not 0: "8 %", "0.3 %".
QString share_text(double share);

/// Title of what changes from run to run in the user's language: "X Jerk" for "X.jerk", "Contour tolerance"
/// for "tolerance"; the key itself if nothing has it.
QString setting_title(const std::string& key);

/// That a wider contour tolerance takes longer than a narrower one, and why.
QString slower_tolerance_text(const SlowerTolerance& slower);

}  // namespace feedscope::ui
