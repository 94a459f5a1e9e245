#pragma once

#include <QString>

namespace feedscope::ui {

/// A time for people: "12.345 s", from a minute on "3:05.2"; decimals by the locale.
QString clock_text(double seconds);

}  // namespace feedscope::ui
