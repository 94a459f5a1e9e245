#pragma once

#include <memory>
#include <vector>

#include "core/analysis/agreement/held_stretches.h"
#include "core/identification/fit_case.h"

namespace feedscope {

/// A trace and its program.
///
/// Compares the times over stretches of the programmed path, each ending at a sample of the trace: short
/// ones, eight and 64 together, and the whole; also the distance from the path in each, where it is clearly
/// above the noise. Where the trace stops and a run of `start` does not, as in a feed hold, nothing is
/// compared, and the time is subtracted; found().remarks report it. Residuals are in units of noise and
/// sampling.
class TraceCase : public FitCase {
 public:
  /// `start`: a setup of the model. Throws InputError if no part of the trace is on the path or its rate is
  /// wrong (wrong_rate_of()).
  TraceCase(std::shared_ptr<const Trace> trace, const LoadedProgram& program, const Setup& start,
            Progress* progress = nullptr);

  const std::string& name() const override { return trace_->name; }
  const LoadedProgram& program() const override { return program_; }
  std::size_t size() const override { return scale_.size(); }
  std::vector<double> residuals(const Setup& setup, Progress* progress) const override;
  std::size_t stretch_of(std::size_t residual) const override { return stretch_[residual]; }
  bool is_short(std::size_t residual) const override { return residual < short_; }
  std::size_t stretches() const override { return borders_.empty() ? 0 : borders_.size() - 1; }
  AxisVector<AxisReach> reach() const override;
  FitResult result(const Run& run, Progress* progress) const override;

  const ProgrammedCourse& course() const { return *course_; }
  const TraceOnProgram& found() const { return found_; }
  /// Share of the programmed feed from feed_share(); none without one.
  std::optional<double> feed_share() const { return feed_share_; }

 private:
  struct Span {
    std::size_t first = 0;  ///< borders
    std::size_t last = 0;
  };
  void add_span(std::size_t first, std::size_t last);
  TimeLaw law_of(const Trajectory& run, Progress* progress) const;
  void leave_out_holds(const TimeLaw& run);

  std::shared_ptr<const Trace> trace_;
  LoadedProgram program_;
  std::shared_ptr<const ProgrammedCourse> course_;
  TraceOnProgram found_;
  std::optional<double> feed_share_;
  std::vector<HeldStretch> held_;  ///< where the trace stops longer than the program does
  double step_ = 1e-3;             ///< of sampling a run [s]
  std::vector<double> borders_;    ///< programmed path length [mm]
  std::vector<double> times_;      ///< measured there [s]
  std::vector<double> time_noise_;
  std::vector<Span> spans_;  ///< without those in which the trace has left the path
  std::size_t short_ = 0;    ///< number of short ones, which come first
  /// Largest distance of the trace from the path, for short stretches whose distance counts. A run is
  /// compared at the same places: between its samples a trace may have been farther away than recorded.
  std::vector<TimeLaw::Farthest> farthest_;
  std::vector<double> scale_;  ///< unit of each residual [s], [mm]
  std::vector<std::size_t> stretch_;
};

}  // namespace feedscope
