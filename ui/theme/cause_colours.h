#pragma once

#include <QColor>

#include "core/limits/cause.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

/// Colour of a limiting cause on the ground of this theme, as cause_colour() in the scene.
QColor colour_of_cause(CauseKind kind, ThemeKind theme = ThemeKind::light);

}  // namespace feedscope::ui
