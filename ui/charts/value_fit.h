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

/// Range of one curve, for the choice of an ordinate.
struct CurveReach {
  Extent values;  ///< in the chart's unit; may be empty
  bool may_be_cut = false;
};

/// The ordinate that shows all curves, and zero. Curves that may be cut, and `limits` (magnitudes), extend it
/// at most to 1.75 times the largest value of the others.
Interval fit_values(std::span<const CurveReach> curves, std::span<const double> limits);

/// Cutting feeds, or accelerations or jerks while cutting, in the chart's unit.
struct CuttingFeed {
  double achieved = 0;         ///< the largest; with `without_peaks` the largest lasting one
  double programmed = 0;       ///< the largest
  bool without_peaks = false;  ///< faster cutting is thin in the chart, and far above the rest
};

/// The largest value that a few neighbouring columns of a chart have: thin peaks do not count. 0 for fewer
/// columns.
double largest_that_lasts(std::span<const double> columns);

/// Whether `fastest` is so large that it leaves no room for `slower` in a chart.
bool is_far_beyond(double fastest, double slower);

/// `values` made narrower if `fastest`, the largest value of all, exceeds those while cutting by more than a
/// quarter: rapids do not determine the scale of a chart. None if it does not.
std::optional<Interval> without_rapids(const Interval& values, double fastest, const CuttingFeed& cutting);

}  // namespace feedscope::ui
