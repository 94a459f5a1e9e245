#pragma once

#include <QColor>
#include <QPalette>

namespace feedscope::ui {

/// Colours of a program's text. Axes and feed have the hues of the charts; every text colour has a contrast
/// of at least 4.5 to 1 to its background.
struct ProgramColours {
  QColor comment;
  QColor label;
  QColor block_delete;
  QColor g_code;
  QColor m_code;
  QColor axis_x;
  QColor axis_y;
  QColor axis_z;
  QColor other_axis;
  QColor argument;
  QColor feed;
  QColor tool;
  QColor keyword;
  QColor variable;
  QColor literal;
  QColor caret_line;  ///< frame of the caret's line
  QColor found;       ///< background of search hits
  QColor found_mark;  ///< search hits in the overview strip
  QColor slow;        ///< of the slowest line in a heat strip
};

const ProgramColours& program_colours(const QPalette& palette);

/// Colour of a `heat` from 0 (as `ground`) to 1 (as `slow`).
QColor heat_colour(double heat, const QColor& ground, const QPalette& palette);

}  // namespace feedscope::ui
