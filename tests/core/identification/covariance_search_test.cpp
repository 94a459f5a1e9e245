#include "core/identification/covariance_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feedscope {
namespace {

using Eigen::VectorXd;

CovarianceSearch search_of(double (*cost)(const VectorXd&)) {
  CovarianceSearch search;
  search.settled = 1e-6;
  search.values = [cost](const std::vector<VectorXd>& places) {
    std::vector<double> values;
    for (const VectorXd& place : places) {
      values.push_back(cost(place));
    }
    return values;
  };
  return search;
}

/// Rosenbrock's valley: numbers that depend on each other; its bottom is (1, 1, 1, 1).
double valley(const VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
  }
  return sum;
}

/// A bowl with its bottom at (1, 1, 1, 1) whose hollows, 0.1 apart, hold every search of one number after the
/// other and every step down a slope.
double hollows(const VectorXd& x) {
  double sum = 0;
  for (const double value : x) {
    const double off = value - 1;
    sum += off * off + 0.005 * (1 - std::cos(20 * 3.141592653589793 * off));
  }
  return sum;
}

TEST(CovarianceSearch, GoesAlongAValley) {
  CovarianceSearch search = search_of(&valley);
  search.most = 6000;
  const VectorXd best = search.best_from(VectorXd::Constant(4, -0.5), VectorXd::Constant(4, 0.4));
  EXPECT_LT((best - VectorXd::Ones(4)).norm(), 1e-2) << best.transpose();
}

TEST(CovarianceSearch, LeavesHollowsForTheDeepest) {
  const VectorXd best = search_of(&hollows).best_from(VectorXd::Zero(4), VectorXd::Constant(4, 0.4));
  EXPECT_LT((best - VectorXd::Ones(4)).norm(), 1e-2) << best.transpose();
}

TEST(CovarianceSearch, KeepsNumbersWithoutSpreadAndGivesTheSameEveryTime) {
  VectorXd spread = VectorXd::Constant(4, 0.4);
  spread[2] = 0;
  const VectorXd begin = VectorXd::Constant(4, 0.3);
  const CovarianceSearch search = search_of(&hollows);
  const VectorXd best = search.best_from(begin, spread);
  EXPECT_EQ(best[2], 0.3);
  EXPECT_EQ(best, search.best_from(begin, spread));
  EXPECT_EQ(search.best_from(begin, VectorXd::Zero(4)), begin);
}

TEST(CovarianceSearch, EvaluatesNoMoreThanItMayAndIsNeverWorseThanItsBegin) {
  std::size_t evaluated = 0;
  CovarianceSearch search;
  search.most = 50;
  search.values = [&](const std::vector<VectorXd>& places) {
    evaluated += places.size();
    return std::vector<double>(places.size(), evaluated == 1 ? 0 : 1);
  };
  EXPECT_EQ(search.best_from(VectorXd::Zero(3), VectorXd::Ones(3)), VectorXd::Zero(3));
  EXPECT_LE(evaluated, 50U);
  EXPECT_GT(evaluated, 1U);
}

}  // namespace
}  // namespace feedscope
