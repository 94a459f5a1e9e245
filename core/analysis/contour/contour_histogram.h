#pragma once

#include "core/analysis/contour/contour_errors.h"

namespace feedscope {

/// Fills a histogram whose edges follow from the largest error [mm].
class HistogramCounter {
 public:
  HistogramCounter(ContourBins bins, double largest);
  /// Path of `length` on which the error goes from one value to the other [mm].
  void add(double from, double to, double length);
  ContourHistogram result() const { return histogram_; }

 private:
  std::size_t bin_of(double value) const;

  ContourHistogram histogram_;
};

}  // namespace feedscope
