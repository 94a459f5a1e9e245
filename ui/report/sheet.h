#pragma once

#include <QSizeF>

#include "ui/report/report_input.h"

class QPainter;

namespace feedscope::ui {

/// Smallest sheet, longer and shorter side [1/96 inch].
inline constexpr QSizeF min_sheet{880, 600};

struct SheetLook {
  double pixel_ratio = 1;  ///< of rasters
  ThemeKind theme = ThemeKind::light;
  bool transparent = false;
};

/// A handout of one page: title, main figures, 3D view with annotations, charts with causes, facts and the
/// comparison of the runs; portrait or landscape by `size`. Throws InputError if the size is too small.
void paint_sheet(QPainter& painter, const QSizeF& size, const ReportInput& input, const SheetLook& look);

}  // namespace feedscope::ui
