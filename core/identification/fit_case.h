#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/analysis/agreement/agreement.h"
#include "core/identification/trace_limits.h"

namespace feedscope {

/// Time of a section of a program, measured and simulated.
struct SectionAgreement {
  std::string section;        ///< name in the table
  double measured_time = 0;   ///< [s]
  double simulated_time = 0;  ///< [s]
};

/// Agreement of a run with a recording.
struct FitResult {
  Agreement agreement;     ///< of section times only their times
  bool time_known = true;  ///< false if samples are missing without a gap in the times
  double resolution = 0;   ///< of the times [s]
  double feed_error = 0;   ///< root mean square, as a share of the mean feed, less the effect of jitter
  std::vector<SectionAgreement> sections;  ///< if section times were recorded
};

/// Recording of a program on a machine, prepared for many simulations. Residuals are in units of noise,
/// sampling and rounding.
class FitCase {
 public:
  virtual ~FitCase() = default;

  virtual const std::string& name() const = 0;  ///< of the file
  virtual const LoadedProgram& program() const = 0;
  virtual std::size_t size() const = 0;  ///< residuals
  /// Simulated minus measured values for a setup; large ones for a run that leaves the path altogether.
  /// Throws Cancelled when stopped.
  virtual std::vector<double> residuals(const Setup& setup, Progress* progress) const = 0;
  /// Index of the short stretch of a residual, of `stretches()`; blocks of them are omitted to find how much
  /// a value depends on a part of the recording.
  virtual std::size_t stretch_of(std::size_t residual) const = 0;
  virtual bool is_short(std::size_t residual) const = 0;  ///< time of one short stretch
  virtual std::size_t stretches() const = 0;
  virtual AxisVector<AxisReach> reach() const = 0;  ///< reach of the axes, in mm; zeros: unknown
  virtual FitResult result(const Run& run, Progress* progress) const = 0;
};

using FitCases = std::vector<std::shared_ptr<const FitCase>>;

}  // namespace feedscope
