#pragma once

#include <optional>

#include "core/analysis/load/load_figures.h"

namespace feedscope {

/// Collects where the load is beyond one bound, along a run.
class LimitTracker {
 public:
  explicit LimitTracker(LoadLimit limit) { figures_.limit = limit; }

  /// A look at the load, in the order of time.
  struct Look {
    double time = 0;  ///< [s]
    std::uint32_t line = 0;
    double predicted = 0;
    double programmed = 0;
  };
  /// Between two looks of one motion, between which the load goes linearly. `bound`: that of `operation`.
  void add(const Look& from, const Look& to, int operation, double bound);
  LimitFigures finish();

 private:
  void extend(double from, double to, const Look& a, const Look& b, int operation);
  void close();
  void keep_longest();

  LimitFigures figures_;
  std::optional<LoadPlace> open_;
};

/// The bound of an operation, if it has one, in the unit of its quantity.
std::optional<double> bound_of(LoadLimit limit, const Engagement& operation);

}  // namespace feedscope
