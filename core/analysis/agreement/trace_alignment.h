#pragma once

#include "core/analysis/agreement/agreement.h"

namespace feedscope {

/// Which instant of a trace stands for an instant of a run of the same program.
class TraceAlignment {
 public:
  TraceAlignment() = default;
  /// Both outlive this.
  TraceAlignment(const TraceOnProgram& trace, const Agreement& agreement);

  /// When the trace is at the place where the run is at `time` [s]; during a pause of both at the same share
  /// of it. Not a number where the trace is not on the path of the program: before its start, beyond its end
  /// and in stretches of two samples or more that are too far from it.
  double at_place(double time) const;
  /// As long after the trace's first motion as `time` after the run's [s]; not a number outside the trace.
  double at_time(double time) const;
  /// When the trace ends on the time of the run, as at_time(): with its last motion along the program [s]; 0
  /// where it has none.
  double end_time() const;
  /// When the run first comes to a place of the programmed path [s]; `s`: programmed path length [mm].
  double run_time(double s) const { return agreement_->simulated.at(s); }

 private:
  const TraceOnProgram* trace_ = nullptr;
  const Agreement* agreement_ = nullptr;
  double shift_ = 0;  ///< of the trace's time against the run's [s]
};

}  // namespace feedscope
