#pragma once

#include <QColor>
#include <QPalette>
#include <array>

namespace feedscope::ui {

enum class ThemeKind { light, dark };

/// Colours without a role in QPalette. Curves and axes keep Okabe and Ito's hues (distinct for every kind of
/// colour vision), lightened on dark.
struct ThemeColours {
  QColor plot;    ///< background of curves and paths
  QColor grid;    ///< lines of a plot's grid
  QColor frame;   ///< axes and borders of a plot
  QColor text;    ///< on `plot`
  QColor muted;   ///< line numbers, less important text
  QColor gutter;  ///< background of line numbers
  QColor current_line;
  QColor path;        ///< quantities along the path: achieved feed, tangential acceleration
  QColor programmed;  ///< programmed values
  QColor across;      ///< quantities across the path
  QColor shared;      ///< shared by several axes
  std::array<QColor, 3> axes;
  QColor cursor;         ///< common place of all views
  QColor second_cursor;  ///< the other end of a measured range
  QColor error;
  QColor warning;
  QColor info;
};

/// Fusion style with a neutral palette, equal on every desktop and off screen. Needs a QApplication; visible
/// widgets receive QEvent::PaletteChange.
void apply_theme(ThemeKind kind = ThemeKind::light);

/// Decides by the lightness of the window's colour.
ThemeKind theme_of(const QPalette& palette);
const ThemeColours& theme_colours(const QPalette& palette);

}  // namespace feedscope::ui
