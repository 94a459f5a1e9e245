#pragma once

#include <QColor>
#include <QPalette>
#include <array>

namespace feedscope::ui {

enum class ThemeKind { light, dark };

/// Colours that a QPalette has no role for. Curves and axes keep Okabe and Ito's hues (told apart with every
/// kind of colour vision), lightened on dark.
struct ThemeColours {
  QColor plot;    ///< behind curves and paths
  QColor grid;    ///< lines of a plot's grid
  QColor frame;   ///< axes and borders of a plot
  QColor text;    ///< on `plot`
  QColor muted;   ///< line numbers, what matters less
  QColor gutter;  ///< behind line numbers
  QColor current_line;
  QColor path;        ///< what is along the path: achieved feed, tangential acceleration
  QColor programmed;  ///< what the program asks for
  QColor across;      ///< what is square to the path
  QColor shared;      ///< what several axes have in common
  std::array<QColor, 3> axes;
  QColor cursor;         ///< where all views point
  QColor second_cursor;  ///< the other end of a measured range
  QColor error;
  QColor warning;
  QColor info;
};

/// Fusion style with a neutral palette, the same on every desktop and off screen. Needs a QApplication;
/// widgets that are shown get QEvent::PaletteChange.
void apply_theme(ThemeKind kind = ThemeKind::light);

/// By the lightness of the window's colour.
ThemeKind theme_of(const QPalette& palette);
const ThemeColours& theme_colours(const QPalette& palette);

}  // namespace feedscope::ui
