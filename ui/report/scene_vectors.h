#pragma once

class QPainter;
class vtkRenderWindow;

namespace feedscope::ui {

/// Paints the window's last frame as vectors: flat shapes and lines as such, text as outlines of the same
/// glyphs. One unit of the painter is a pixel of the window, from its upper left corner; the background is
/// omitted. `scale`: size of text and lines of the scene. The same frame gives the same calls.
///
/// Returns false and paints nothing if the frame contains surfaces (a tool), or too many lines for
/// LinePieces.
bool paint_vectors(QPainter& painter, vtkRenderWindow& window, double scale);

}  // namespace feedscope::ui
