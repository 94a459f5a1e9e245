#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace feedscope {

/// How a search for the least value of a function goes that is rugged, has several hollows, and in which the
/// numbers depend on each other.
struct CovarianceSearch {
  /// Values at several places, all of a generation at once.
  using Values = std::function<std::vector<double>(const std::vector<Eigen::VectorXd>&)>;

  Values values;
  std::size_t most = 1000;  ///< evaluations
  double settled = 2e-3;    ///< ends where no number is spread by more

  /// The best place that was seen, `begin` if none is better. `spread`: standard deviation of each number to
  /// begin with; one of 0 stays as it is. The same every time.
  ///
  /// CMA-ES with rank-one and rank-mu updates, Hansen, "The CMA Evolution Strategy: A Tutorial",
  /// arXiv:1604.00772, equations (5) to (48) with its default constants, without negative weights.
  Eigen::VectorXd best_from(const Eigen::VectorXd& begin, const Eigen::VectorXd& spread) const;
};

}  // namespace feedscope
