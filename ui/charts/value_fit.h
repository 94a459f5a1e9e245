#pragma once

#include <span>

#include "ui/charts/envelope.h"

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

}  // namespace feedscope::ui
