#pragma once

#include <QIcon>
#include <QPalette>

namespace feedscope::ui {

enum class MediaIcon { play, pause, back, on };

/// Drawn in the colour of button texts: the style's own icons are black in every theme.
QIcon media_icon(MediaIcon kind, const QPalette& palette);

/// On the title of a dock: to close it, to take it out of the window or put it back; at the end of a tool
/// bar: that there is more.
enum class DockIcon { close, detach, more, more_below };

/// Always in the colour that texts of the application have at the time.
QIcon dock_icon(DockIcon kind);

enum class EditIcon { undo, redo };

/// An arrow that turns back, or on again; in the colour of texts as dock_icon().
QIcon edit_icon(EditIcon kind);

}  // namespace feedscope::ui
