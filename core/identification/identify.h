#pragma once

// Room `identification`: limits and settings of a machine from recordings. Traces or section times become
// cases to fit; parameter_search.h searches, parameter_judgement.h says which values are determined and how
// well, drive_fit.h finds the drives.

#include <optional>
#include <string>
#include <vector>

#include "core/identification/drive_fit.h"
#include "core/identification/fit_case.h"
#include "core/identification/fit_parameter.h"
#include "core/identification/identified_parameter.h"

namespace feedscope {

/// A model fitted to traces.
struct Identification {
  Setup setup;  ///< with the identified values; their sources in the machine
  std::vector<IdentifiedParameter> parameters;
  std::vector<Run> runs;              ///< of the programs, one per trace
  std::vector<Agreement> agreements;  ///< one per trace; for section times only their times
  std::vector<std::vector<SectionAgreement>>
      sections;           ///< by trace; empty for those without a table of section times
  double residual = 0;    ///< root mean square of the residuals, in units of noise and sampling
  double feed_error = 0;  ///< largest FitResult::feed_error
  bool explains = false;  ///< the model agrees with the traces: within 5 % of the feed and 1 % of the time,
                          ///< where known
  std::vector<DriveFit> drives;  ///< of the searched axes; also part of `parameters`
  std::size_t simulations = 0;
};

/// Options of the search.
struct IdentifyOptions {
  std::string date;                  ///< for the sources of the numbers; "" omits it
  std::size_t most_searched = 2000;  ///< simulations of all programs per joint search; fewer of long ones
};

/// Finds the `parameters` of `start` with which its model explains the traces of `cases` best.
///
/// Stages: velocities and accelerations start from the reach of the traces. Each parameter is searched alone
/// over a wide range, twice; those without influence are set aside. The others are searched together
/// (CovarianceSearch, on a robust sum of residuals), from there and from the reach of the traces; NLopt
/// (BOBYQA) and Gauss-Newton steps refine the result. The uncertainty is twice the standard deviation, the
/// larger one from the residuals at the optimum and from omitting each twelfth of the traces in turn, and at
/// least the range of points that explain the traces as well; more if long stretches have residuals above
/// noise. A parameter with an uncertainty above a fifth, or that can be halved or doubled without effect, is
/// not determined. If the model does not explain the traces, none is. Without `parameters` the start is
/// compared with the traces as it is. Uses several threads. Throws InputError, Cancelled.
Identification identify(const FitCases& cases, const Setup& start,
                        const std::vector<FitParameter>& parameters, const IdentifyOptions& options = {},
                        Progress* progress = nullptr);

/// Current stage of identify(), for display: "each number alone".
std::string identification_stage(double fraction);

}  // namespace feedscope
