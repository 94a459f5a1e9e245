#pragma once

class QPainter;
class vtkRenderWindow;

namespace feedscope::ui {

/// Paints what the window's last frame showed as vectors: flat shapes and lines as such, text as outlines of
/// the same glyphs. One unit of the painter is a pixel of the window, from its upper left corner; the
/// background is omitted. `scale`: size of text and lines of the scene. The same frame gives the same calls.
///
/// False: nothing has been painted, because the frame holds surfaces (a tool), or so many lines that
/// LinePieces refuses them.
bool paint_vectors(QPainter& painter, vtkRenderWindow& window, double scale);

}  // namespace feedscope::ui
