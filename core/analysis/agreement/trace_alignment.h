#pragma once

#include "core/analysis/agreement/agreement.h"

namespace feedscope {

/// Instants of a trace that correspond to instants of a run of the same program.
class TraceAlignment {
 public:
  TraceAlignment() = default;
  /// Both outlive this.
  TraceAlignment(const TraceOnProgram& trace, const Agreement& agreement);

  /// Time at which the trace passes the place of the run at `time` [s]; during a pause of both, at the same
  /// share of it. NaN where the trace is not on the path of the program: before its start, beyond its end,
  /// and in stretches of two or more samples that are too far from it.
  double at_place(double time) const;
  /// Time of the trace as long after its first motion as `time` is after that of the run [s]; NaN outside the
  /// trace.
  double at_time(double time) const;
  /// End of the trace on the time of the run, as at_time(): its last motion along the program [s]; 0 without
  /// one.
  double end_time() const;
  /// Time at which the run first reaches a place of the programmed path [s]; `s`: programmed path length
  /// [mm].
  double run_time(double s) const { return agreement_->simulated.at(s); }

 private:
  const TraceOnProgram* trace_ = nullptr;
  const Agreement* agreement_ = nullptr;
  double shift_ = 0;  ///< trace time minus run time [s]
};

}  // namespace feedscope
