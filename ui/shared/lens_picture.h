#pragma once

#include <QColor>
#include <QCoreApplication>
#include <QList>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <vector>

#include "core/analysis/contour/lens.h"

class QPainter;

namespace feedscope::ui {

/// Appearance of a run in the lens.
struct LensLook {
  QString name;
  QColor colour;
  QList<qreal> dashes;  ///< of a pen, in line widths; empty: solid
};

/// Draws a lens: the programmed path thin and grey, the tolerance in force as two pale lines, the runs over
/// each other with a dot for each at the cursor; the magnifications, a scale in either direction, and if
/// there is room, a table of errors and feeds.
class LensPicture {
  Q_DECLARE_TR_FUNCTIONS(LensPicture)

 public:
  /// `looks`: of the runs. `scale`: size of text and lines, 1 on screen.
  LensPicture(const Lens& lens, std::vector<LensLook> looks, double scale = 1);

  /// Fills `area`, a square with a title above it, in the colours of `palette`; a transparent window colour
  /// is possible.
  void paint(QPainter& painter, const QRectF& area, const QPalette& palette) const;

 private:
  struct View;

  void draw_title(QPainter& painter, const View& view) const;
  void draw_paths(QPainter& painter, const View& view) const;
  void draw_tolerance(QPainter& painter, const View& view) const;
  void draw_scales(QPainter& painter, const View& view) const;
  void draw_table(QPainter& painter, const View& view) const;

  const Lens& lens_;
  std::vector<LensLook> looks_;
  double scale_;
};

}  // namespace feedscope::ui
