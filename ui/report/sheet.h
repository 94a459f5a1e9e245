#pragma once

#include <QSizeF>

#include "ui/report/report_input.h"

class QPainter;

namespace feedscope::ui {

/// Smallest sheet, on its longer and its shorter side [1/96 inch].
inline constexpr QSizeF min_sheet{880, 600};

struct SheetLook {
  double pixel_ratio = 1;  ///< of rasters
  ThemeKind theme = ThemeKind::light;
  bool transparent = false;
};

/// One page to hand out: title, main figures, 3D view with annotations, charts with causes, facts and the
/// comparison of the runs; portrait or landscape as `size` is. Throws InputError if the size is too small.
void paint_sheet(QPainter& painter, const QSizeF& size, const ReportInput& input, const SheetLook& look);

}  // namespace feedscope::ui
