#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace feedscope {

/// A part of one of several columns of time.
struct ColumnStretch {
  std::size_t column = 0;
  double from = 0;  ///< [s]
  double to = 0;    ///< [s]
};

/// When a run moves at rapid traverse.
class RapidTimes {
 public:
  /// From one time to another [s]; in order.
  void add(double from, double to);
  bool empty() const { return from_.empty(); }
  /// What lies between rapids of each pair of neighbours in `times` [s], ascending; a nanosecond away from
  /// them, so that rounding lets no instant of a rapid in. One walk over the rapids between the times.
  std::vector<ColumnStretch> outside(std::span<const double> times) const;

 private:
  std::vector<double> from_;  ///< of each stretch without a pause [s]
  std::vector<double> to_;
};

}  // namespace feedscope
