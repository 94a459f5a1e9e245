#pragma once

#include <QIcon>
#include <QPalette>

namespace feedscope::ui {

enum class MediaIcon { play, pause, back, on };

/// Drawn in the colour of button texts: the style's own icons are black in every theme.
QIcon media_icon(MediaIcon kind, const QPalette& palette);

}  // namespace feedscope::ui
