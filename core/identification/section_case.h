#pragma once

#include <string>
#include <vector>

#include "core/identification/fit_case.h"
#include "core/identification/section_times.h"

namespace feedscope {

/// Times of sections of a program, without a trace. Each is compared separately, in units of the clock's
/// resolution at both ends and 0.05 % of the time.
class SectionCase : public FitCase {
 public:
  /// `name`: of the table. Throws InputError for sections missing in the program.
  SectionCase(std::vector<SectionTime> times, std::string name, const LoadedProgram& program);

  /// Throws InputError if the times are far from those of the program on `start`, with a likely explanation:
  /// a search would find a machine that is a thousand times as slow.
  void check_times(const Setup& start) const;

  const std::string& name() const override { return name_; }
  const LoadedProgram& program() const override { return program_; }
  std::size_t size() const override { return times_.size(); }
  std::vector<double> residuals(const Setup& setup, Progress* progress) const override;
  /// Sections are measured independently: each is its own stretch.
  std::size_t stretch_of(std::size_t residual) const override;
  bool is_short(std::size_t) const override { return true; }
  std::size_t stretches() const override { return times_.size(); }
  AxisVector<AxisReach> reach() const override { return {}; }
  /// Errors below the resolution of the clock do not count.
  FitResult result(const Run& run, Progress* progress) const override;

 private:
  std::vector<double> simulated(const Trajectory& run) const;

  std::vector<SectionTime> times_;
  std::vector<SectionLines> lines_;
  std::string name_;
  LoadedProgram program_;
};

}  // namespace feedscope
