#pragma once

#include <memory>
#include <vector>

#include "core/analysis/agreement/held_stretches.h"
#include "core/identification/fit_case.h"

namespace feedscope {

/// A trace and the program that it is of.
///
/// What is compared are the times over stretches of the programmed path, each ending where a sample of the
/// trace lies: short ones, eight, and 64 together, and the whole; and the distance from the path in each,
/// where it is clearly above the noise. Where the trace stands still and a run of `start` does not, as in a
/// feed hold, nothing is compared, and the time is taken off; found().remarks say so. Residuals are in units
/// of what noise and sampling make of them.
class TraceCase : public FitCase {
 public:
  /// `start`: a setup of the model. Throws InputError if the trace is nowhere on the path or its rate is
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
  /// At which share of the programmed feed it runs, feed_share(); none where that says nothing.
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
  std::vector<HeldStretch> held_;  ///< where the trace stands longer than the program has it stand
  double step_ = 1e-3;             ///< of sampling a run [s]
  std::vector<double> borders_;    ///< programmed path length [mm]
  std::vector<double> times_;      ///< measured there [s]
  std::vector<double> time_noise_;
  std::vector<Span> spans_;  ///< without those that the trace has left the path in
  std::size_t short_ = 0;    ///< of them, short ones, which come first
  /// Where the trace is farthest from the path, by short stretches whose distance counts. A run is compared
  /// at the same places: between its samples a trace has been farther away than it says.
  std::vector<TimeLaw::Farthest> farthest_;
  std::vector<double> scale_;  ///< one unit of each residual [s], [mm]
  std::vector<std::size_t> stretch_;
};

}  // namespace feedscope
