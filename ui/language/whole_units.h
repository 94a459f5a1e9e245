#pragma once

#include <QString>

namespace feedscope::ui {

/// Text, or HTML, in which units do not break at their slash: "m/min", "[m/s³]", "(m/min)/mm".
QString with_whole_units(QString text);

}  // namespace feedscope::ui
