#pragma once

#include <QIcon>
#include <QPalette>

namespace feedscope::ui {

enum class MediaIcon { play, pause, back, on };

/// Drawn in the colour of button texts: the style's own icons are black in every theme.
QIcon media_icon(MediaIcon kind, const QPalette& palette);

/// Icons on the title of a dock: close it, detach it from the window or return it; and at the end of a
/// toolbar: more commands.
enum class DockIcon { close, detach, more, more_below };

/// Always in the current colour of the application's texts.
QIcon dock_icon(DockIcon kind);

enum class EditIcon { undo, redo };

/// An arrow back or forward; in the colour of texts as dock_icon().
QIcon edit_icon(EditIcon kind);

}  // namespace feedscope::ui
