#pragma once

#include <QFont>
#include <QPainterPath>
#include <QString>
#include <QTransform>

class QPainter;
class vtkTextActor;

namespace feedscope::ui {

/// A text of a VTK window as a shape, and its letters at the same place.
struct TextOutline {
  QPainterPath shape;  ///< to be filled; [pixels] from the upper left corner of the window
  QString text;
  QFont font;        ///< of the letters: DejaVu Sans
  QTransform place;  ///< from the start of the letters' baseline to [pixels]
};

/// Outline of a text in a window of `height` pixels. DejaVu Sans replaces letters that VTK's font lacks. The
/// shape is empty for a text without letters. Needs a QApplication.
TextOutline text_outline(vtkTextActor& actor, int height);

/// Paints invisible letters over the shape, so that text in PDF and SVG files can be searched and copied.
void paint_letters(QPainter& painter, const TextOutline& outline);

}  // namespace feedscope::ui
