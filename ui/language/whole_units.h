#pragma once

#include <QString>

namespace feedscope::ui {

/// Text, or HTML, in which units stay in one line with their number and
/// do not break at their slash: "0.01 mm", "m/min", "[m/s³]", "(m/min)/mm".
QString with_whole_units(QString text);

}  // namespace feedscope::ui
