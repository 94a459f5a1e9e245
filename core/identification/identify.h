#pragma once

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
  Setup setup;  ///< with the values that were found, their sources in the machine
  std::vector<IdentifiedParameter> parameters;
  std::vector<Run> runs;              ///< of the programs, one a trace
  std::vector<Agreement> agreements;  ///< one a trace; of a table of section times their times alone
  std::vector<std::vector<SectionAgreement>>
      sections;           ///< by trace; empty for those that are no table of them
  double residual = 0;    ///< root mean square of the residuals, in units of noise and sampling
  double feed_error = 0;  ///< largest FitResult::feed_error
  bool explains = false;  ///< the model says what the traces show: within 5 % of the feed and 1 % of the
                          ///< time, where that is known
  std::vector<DriveFit> drives;  ///< by axis, of those that were looked for; also part of `parameters`
  std::size_t simulations = 0;
};

/// How long and how the search is done.
struct IdentifyOptions {
  std::string date;                  ///< for the sources of the numbers; "" omits it
  std::size_t most_searched = 2000;  ///< simulations of all programs by each joint search; fewer of long ones
};

/// Finds the `parameters` of `start` with which its model explains the traces of `cases` best.
///
/// In stages: velocities and accelerations are begun with what the traces reach; each parameter is then
/// searched alone over a wide range, twice; those without influence are set aside; the others are searched
/// together (CovarianceSearch, on a robust sum of residuals), from there and from what the traces reach;
/// NLopt (BOBYQA) and Gauss-Newton steps refine what is found. The uncertainty is twice the standard
/// deviation, the larger one of what the residuals at the optimum and what leaving out each twelfth of the
/// traces in turn say, and at least as far as places of the search explain the traces as well; more where
/// long stretches leave more than noise. A parameter whose uncertainty exceeds a fifth of it, or that can be
/// half or double without showing, is not told. If the model does not explain the traces, none is. Without
/// `parameters` the start is laid beside the traces as it is. On several threads. Throws InputError,
/// Cancelled.
Identification identify(const FitCases& cases, const Setup& start,
                        const std::vector<FitParameter>& parameters, const IdentifyOptions& options = {},
                        Progress* progress = nullptr);

/// What identify() does where its progress stands, for people: "each number alone".
std::string identification_stage(double fraction);

}  // namespace feedscope
