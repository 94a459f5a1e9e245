#pragma once

#include <QString>

namespace feedscope::ui {

/// Text, or HTML, in which units behind numbers are not broken at their slash: "9 m/min" stays on one line.
QString with_whole_units(QString text);

}  // namespace feedscope::ui
