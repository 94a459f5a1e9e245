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
  QTransform place;  ///< from the start of the base line of the letters to [pixels]
};

/// Of a text in a window of `height` pixels. Letters that the font of VTK has not are those of DejaVu Sans.
/// The shape is empty for a text without letters. Needs a QApplication.
TextOutline text_outline(vtkTextActor& actor, int height);

/// The letters over the shape, invisible: they can be found and copied in PDF and SVG files.
void paint_letters(QPainter& painter, const TextOutline& outline);

}  // namespace feedscope::ui
