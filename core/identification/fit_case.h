#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/analysis/agreement/agreement.h"
#include "core/identification/trace_limits.h"

namespace feedscope {

/// Time of a section of a program, as a control took it and as a run has it.
struct SectionAgreement {
  std::string section;        ///< as the table names it
  double measured_time = 0;   ///< [s]
  double simulated_time = 0;  ///< [s]
};

/// How well a run says what was recorded.
struct FitResult {
  Agreement agreement;     ///< of section times only the times
  bool time_known = true;  ///< false where samples are missing without a gap in the times
  double resolution = 0;   ///< of these times [s]
  double feed_error = 0;   ///< root mean square, as a share of the mean feed, less what jittering times make
  std::vector<SectionAgreement> sections;  ///< of section times
};

/// What a machine recorded of a program, prepared for many simulations. Residuals are in units of what noise,
/// sampling and rounding make of them.
class FitCase {
 public:
  virtual ~FitCase() = default;

  virtual const std::string& name() const = 0;  ///< of the file
  virtual const LoadedProgram& program() const = 0;
  virtual std::size_t size() const = 0;  ///< residuals
  /// Simulated less measured, of a setup; a run that leaves the path altogether gets large ones. Throws
  /// Cancelled when stopped.
  virtual std::vector<double> residuals(const Setup& setup, Progress* progress) const = 0;
  /// Number of the short stretch that a residual belongs to, of `stretches()`; blocks of them are left out to
  /// see how much a value depends on a part of what was recorded.
  virtual std::size_t stretch_of(std::size_t residual) const = 0;
  virtual bool is_short(std::size_t residual) const = 0;  ///< the time of one short stretch
  virtual std::size_t stretches() const = 0;
  virtual AxisVector<AxisReach> reach() const = 0;  ///< what the axes reach, in mm; zeros: not known
  virtual FitResult result(const Run& run, Progress* progress) const = 0;
};

using FitCases = std::vector<std::shared_ptr<const FitCase>>;

}  // namespace feedscope
