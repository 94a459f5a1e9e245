#pragma once

#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "ui/runs/comparison_bars.h"

class QPainter;

namespace feedscope::ui {

/// The colour of a kind of causes; hatched grey: several that take little time.
void fill_cause(QPainter& painter, const QRectF& area, const std::optional<CauseKind>& kind);
/// Over a bar: its control refuses lines of the program.
void hatch_refused(QPainter& painter, const QRectF& area);
/// What a legend calls the parts of bars, in the order of ComparisonBars::kinds, then the rest if there is
/// one.
std::vector<QString> cause_legend(const ComparisonBars& bars);

/// A bar of a comparison, cut by what limits the feed.
struct CauseBar {
  QRectF place;  ///< its height, and where it begins
  double pixels_per_second = 0;
  std::optional<double> line;  ///< x that texts keep clear of
  /// The text of a part that is this wide [pixels]; empty where it has no room.
  std::function<QString(const BarPart&, double width)> text;
};
/// Texts in the painter's font. Returns where the bar ends.
double paint_cause_bar(QPainter& painter, const ComparisonBar& bar, const CauseBar& how);

}  // namespace feedscope::ui
