#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/identification/fit_case.h"
#include "core/identification/fit_parameter.h"

namespace feedscope {

/// Share of a search's progress reported by one simulation: it is cancelled with the search, which counts
/// simulations, not their progress.
inline constexpr double unseen_share = 1e-9;
/// Larger residuals count by their absolute value in ParameterSearch::cost().
inline constexpr double robust_from = 3;
/// Weight of a residual in a least-squares step that lowers ParameterSearch::cost().
double weight_of(double residual);

/// Residuals of all cases as a function of the logarithms of some parameters.
class ParameterSearch {
 public:
  ParameterSearch(const FitCases& cases, Setup start, std::vector<FitParameter> parameters,
                  Progress* progress);

  std::size_t size() const { return parameters_.size(); }
  const std::vector<FitParameter>& parameters() const { return parameters_; }
  Eigen::VectorXd logarithms() const { return at_; }  ///< present point of the search
  void move_to(const Eigen::VectorXd& at);
  Setup setup() const { return setup_at(at_); }
  std::size_t simulations() const { return simulations_; }
  std::size_t stretches() const { return stretches_; }  ///< short stretches of all cases
  /// Share of the following calls in the total work, for the progress.
  void stage(double begin, double end, std::size_t evaluations);

  Eigen::VectorXd evaluate(const Eigen::VectorXd& at);
  /// Residuals at several points, on several threads.
  std::vector<Eigen::VectorXd> evaluate_all(const std::vector<Eigen::VectorXd>& places);
  /// Robust sum: squares of small residuals, absolute values of large ones.
  static double cost(const Eigen::VectorXd& residuals);
  /// Derivatives of the residuals by the logarithms, by central differences.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& at);
  /// Derivatives by the parameters with `of`, using only simulations for these; the others are 0.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& at, const std::vector<bool>& of);

  /// Searches a better value of each parameter alone within a factor of `reach` either way, in steps of a
  /// factor of `ratio`.
  void scan(double reach, double ratio);
  void scan(double reach, double ratio, const std::vector<bool>& of);  ///< only of these
  void scan_one(std::size_t parameter, double reach, double ratio);
  /// CovarianceSearch over the parameters with `free`, with the initial spread `spread` of their logarithms.
  void search_widely(const std::vector<bool>& free, double spread, std::size_t most);
  /// BOBYQA of NLopt over the parameters with `free`.
  void search_together(const std::vector<bool>& free, double reach, std::size_t most);
  /// Gauss-Newton steps with step halving over the parameters with `free`.
  void refine(const std::vector<bool>& free, int most);
  /// Largest change of each logarithm to an evaluated point with a cost of at most `cost`: the range of
  /// equally good explanations along the search.
  Eigen::VectorXd reach_of_places(double cost) const;
  /// Index of the twelfth of its trace for each residual.
  const std::vector<std::size_t>& blocks() const { return blocks_; }
  bool is_short(std::size_t residual) const { return short_[residual]; }  ///< FitCase::is_short()
  static constexpr std::size_t block_count = 12;

 private:
  struct Place {
    Eigen::VectorXd at;
    double cost = 0;
  };

  Setup setup_at(const Eigen::VectorXd& at) const;
  Eigen::VectorXd clamped(const Eigen::VectorXd& at) const;
  void report(std::size_t evaluations);

  const FitCases& cases_;
  Setup start_;
  std::vector<FitParameter> parameters_;
  Progress* progress_;
  Eigen::VectorXd at_;
  std::size_t count_ = 0;
  std::size_t stretches_ = 0;
  std::size_t simulations_ = 0;
  std::vector<Place> places_;  ///< all evaluated ones
  std::vector<std::size_t> blocks_;
  std::vector<bool> short_;
  double begin_ = 0;
  double end_ = 1;
  std::size_t expected_ = 1;
  std::size_t done_ = 0;
};

}  // namespace feedscope
