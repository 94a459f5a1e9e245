#pragma once

#include <QString>

namespace feedscope::ui {

/// Text, or HTML, in which units after numbers do not break at their slash: "9 m/min" remains on one line.
QString with_whole_units(QString text);

}  // namespace feedscope::ui
