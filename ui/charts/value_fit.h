#pragma once

#include <optional>
#include <span>

#include "core/analysis/envelope/envelope.h"

namespace feedscope::ui {

/// A closed interval along an axis.
struct Interval {
  double lower = 0;
  double upper = 0;

  double width() const { return upper - lower; }
  bool operator==(const Interval&) const = default;
};

/// What one curve covers, for the choice of an ordinate.
struct CurveReach {
  Extent values;  ///< in the chart's unit; may be empty
  bool may_be_cut = false;
};

/// The ordinate that shows all curves, and zero. Curves that may be cut, and `limits` (magnitudes), widen it
/// up to 1.75 times the largest value of the others only.
Interval fit_values(std::span<const CurveReach> curves, std::span<const double> limits);

/// What is cut at, in the chart's unit.
struct CuttingFeed {
  double achieved = 0;         ///< the largest, or where `without_peaks` the largest that lasts
  double programmed = 0;       ///< the largest
  bool without_peaks = false;  ///< what is cut faster is thin in the chart, and far above all else
};

/// The largest value that columns of a chart have side by side, a few of them: thin peaks do not count. 0 for
/// fewer columns.
double largest_that_lasts(std::span<const double> columns);

/// Whether what is `fastest` leaves something slower no room in a chart.
bool is_far_beyond(double fastest, double slower);

/// `values` made narrower where `fastest`, the largest feed of all, is more than a quarter above that of the
/// cutting: rapids do not set the scale of a feed chart. None where it is not.
std::optional<Interval> without_rapids(const Interval& values, double fastest, const CuttingFeed& cutting);

}  // namespace feedscope::ui
