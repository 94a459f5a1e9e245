#pragma once

#include "core/analysis/contour/contour_errors.h"

namespace feedscope {

/// Fills a histogram whose edges are derived from the largest error [mm].
class HistogramCounter {
 public:
  HistogramCounter(ContourBins bins, double largest);
  /// Adds a path of `length` on which the error changes from one value to the other [mm].
  void add(double from, double to, double length);
  ContourHistogram result() const { return histogram_; }

 private:
  std::size_t bin_of(double value) const;

  ContourHistogram histogram_;
};

/// Fills a spread whose step is derived from the largest error [mm].
class SpreadCounter {
 public:
  explicit SpreadCounter(double largest);
  /// Adds a path of `length` on which distance and side change from one value to the other [mm].
  void add(double from, double to, double side_from, double side_to, double length);
  ContourSpread result() const;

 private:
  /// Length by value in equal bins: an even spread costs the same over many bins as over one.
  class Line {
   public:
    Line(double first, double step, std::size_t bins);
    void add(double from, double to, double length);
    std::vector<double> lengths() const;

   private:
    double first_;
    double step_;
    std::vector<double> single_;  ///< [mm]
    std::vector<double> change_;  ///< change of the length per bin from one bin to the next [mm]
  };

  SpreadCounter(double step, std::size_t bins);

  double step_;
  Line amount_;
  Line side_;
  double deviation_ = 0;        ///< sum of distance times length [mm2]
  double deviation_in_xy_ = 0;  ///< [mm2]
};

/// Histogram with the equal bins of `bins` and edges for errors up to `largest` [mm], which is that of the
/// spread's run or at least 200 of its steps. Larger errors count in the outermost bins.
ContourHistogram histogram_of(const ContourSpread& spread, ContourBins bins, double largest);

}  // namespace feedscope
