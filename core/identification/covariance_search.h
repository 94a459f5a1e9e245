#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace feedscope {

/// Searches the minimum of a rugged function with several local minima, in which the numbers depend on each
/// other.
struct CovarianceSearch {
  /// Values at several points, those of a whole generation at once.
  using Values = std::function<std::vector<double>(const std::vector<Eigen::VectorXd>&)>;

  Values values;
  std::size_t most = 1000;  ///< evaluations
  double settled = 2e-3;    ///< ends once no number is spread by more

  /// Returns the best point evaluated, `begin` if none is better. `spread`: initial standard deviation of
  /// each number; a number with 0 does not change. Deterministic.
  ///
  /// CMA-ES with rank-one and rank-mu updates, Hansen, "The CMA Evolution Strategy: A Tutorial",
  /// arXiv:1604.00772, equations (5) to (48) with its default constants, without negative weights.
  Eigen::VectorXd best_from(const Eigen::VectorXd& begin, const Eigen::VectorXd& spread) const;
};

}  // namespace feedscope
