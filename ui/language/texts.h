#pragma once

#include <QString>
#include <string>

#include "core/analysis/slower_tolerance.h"

namespace feedscope::ui {

/// A time for people: "12.345 s", from a minute on "3:05.2", from an hour on "4:39:01.0"; decimals by the
/// locale.
QString clock_text(double seconds);

/// The same in as few digits as a comparison needs: "48.5 s", "1:48.5", "1:02:05".
QString short_time_text(double seconds);
/// A share to a whole percent, below one to a figure that is not 0: "8 %", "0.3 %".
QString share_text(double share);

/// Title of what changes from run to run in the user's language: "X Jerk" for "X.jerk", "Contour tolerance"
/// for "tolerance"; the key itself if nothing has it.
QString setting_title(const std::string& key);

/// That a wider contour tolerance takes longer than a narrower one, and why.
QString slower_tolerance_text(const SlowerTolerance& slower);

}  // namespace feedscope::ui
