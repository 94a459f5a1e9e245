#pragma once

#include <QColor>
#include <QPalette>

namespace feedscope::ui {

/// Colours of a program's text. Axes and feed have the hues that they have in the charts; every colour of
/// text stands out from its ground by at least 4.5 to 1.
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
  QColor caret_line;  ///< frame of the line that the keyboard is in
  QColor found;       ///< behind what a search found
  QColor found_mark;  ///< of the same in the strip over the whole program
  QColor slow;        ///< of the slowest line in a strip of times
};

const ProgramColours& program_colours(const QPalette& palette);

/// Colour of a `heat` from 0 (as `ground`) to 1 (as `slow`).
QColor heat_colour(double heat, const QColor& ground, const QPalette& palette);

}  // namespace feedscope::ui
