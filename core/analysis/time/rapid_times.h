#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace feedscope {

/// A stretch within one of several columns of time.
struct ColumnStretch {
  std::size_t column = 0;
  double from = 0;  ///< [s]
  double to = 0;    ///< [s]
};

/// Times at which a run moves at rapid traverse.
class RapidTimes {
 public:
  /// Adds a rapid from one time to another [s]; in order.
  void add(double from, double to);
  bool empty() const { return from_.empty(); }
  /// Stretches between rapids within each pair of neighbours in `times` [s], ascending; they keep a
  /// nanosecond away from the rapids, so that rounding includes no instant of a rapid. One walk over the
  /// rapids between the times.
  std::vector<ColumnStretch> outside(std::span<const double> times) const;

 private:
  std::vector<double> from_;  ///< of each stretch without a pause [s]
  std::vector<double> to_;
};

}  // namespace feedscope
