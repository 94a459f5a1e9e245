#pragma once

#include <QString>
#include <string>

#include "core/analysis/slower_tolerance.h"

namespace feedscope::ui {

/// A time for people: "12.345 s", from a minute on "3:05.2", from an hour on "4:39:01.0"; decimals by the
/// locale.
QString clock_text(double seconds);

/// Title of what changes from run to run in the user's language: "X Jerk" for "X.jerk", "Contour tolerance"
/// for "tolerance"; the key itself if nothing has it.
QString setting_title(const std::string& key);

/// That a wider contour tolerance takes longer than a narrower one, and why.
QString slower_tolerance_text(const SlowerTolerance& slower);

}  // namespace feedscope::ui
