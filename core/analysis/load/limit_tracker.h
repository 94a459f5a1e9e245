#pragma once

#include <optional>

#include "core/analysis/load/load_figures.h"

namespace feedscope {

/// Collects the places of a run where the load is beyond one bound.
class LimitTracker {
 public:
  explicit LimitTracker(LoadLimit limit) { figures_.limit = limit; }

  /// A sample of the load, in order of time.
  struct Look {
    double time = 0;  ///< [s]
    std::uint32_t line = 0;
    double predicted = 0;
    double programmed = 0;
  };
  /// Adds the time between two samples of one motion, between which the load is linear. `bound`: of
  /// `operation`.
  void add(const Look& from, const Look& to, int operation, double bound);
  LimitFigures finish();

 private:
  void extend(double from, double to, const Look& a, const Look& b, int operation);
  void close();
  void keep_longest();

  LimitFigures figures_;
  std::optional<LoadPlace> open_;
};

/// Bound of an operation, if it has one, in the unit of its quantity.
std::optional<double> bound_of(LoadLimit limit, const Engagement& operation);

}  // namespace feedscope
