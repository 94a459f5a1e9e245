#pragma once

#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "ui/runs/comparison_bars.h"

class QPainter;

namespace feedscope::ui {

/// Fills with the colour of a kind of causes; hatched grey for several with little time.
void fill_cause(QPainter& painter, const QRectF& area, const std::optional<CauseKind>& kind);
/// Hatches a bar: its control refuses lines of the program.
void hatch_refused(QPainter& painter, const QRectF& area);
/// Legend texts for the parts of bars, in the order of ComparisonBars::kinds, then the rest if there is one.
std::vector<QString> cause_legend(const ComparisonBars& bars);

/// Layout of a comparison's bar, divided by limiting cause.
struct CauseBar {
  QRectF place;  ///< its height and left end
  double pixels_per_second = 0;
  std::optional<double> line;  ///< x that texts do not cross
  /// The text of a part of this width [pixels]; empty if it does not fit.
  std::function<QString(const BarPart&, double width)> text;
};
/// Texts in the painter's font. Returns the end of the bar.
double paint_cause_bar(QPainter& painter, const ComparisonBar& bar, const CauseBar& how);

}  // namespace feedscope::ui
