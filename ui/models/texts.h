#pragma once

#include <QString>

namespace feedscope::ui {

/// A time for people: "12.345 s", from a minute on "3:05.2", from an hour on "4:39:01.0"; decimals by the
/// locale.
QString clock_text(double seconds);

}  // namespace feedscope::ui
