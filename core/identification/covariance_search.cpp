#include "core/identification/covariance_search.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace feedscope {
namespace {

constexpr unsigned draws_seed = 20261127;  // arbitrary: the same search gives the same result

/// Constants of the tutorial, table 1.
struct Rates {
  explicit Rates(std::size_t parents, double n) : weights(static_cast<Eigen::Index>(parents)) {
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      weights[i] = std::log(static_cast<double>(parents) + 0.5) - std::log(static_cast<double>(i + 1));
    }
    weights /= weights.sum();
    effective = 1 / weights.squaredNorm();
    path = (4 + effective / n) / (n + 4 + 2 * effective / n);
    step_path = (effective + 2) / (n + effective + 5);
    one = 2 / ((n + 1.3) * (n + 1.3) + effective);
    mu = std::min(1 - one, 2 * (effective - 2 + 1 / effective) / ((n + 2) * (n + 2) + effective));
    damping = 1 + 2 * std::max(0.0, std::sqrt((effective - 1) / (n + 1)) - 1) + step_path;
    expected = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  }

  Eigen::VectorXd weights;
  double effective = 0;
  double path = 0;
  double step_path = 0;
  double one = 0;
  double mu = 0;
  double damping = 0;
  double expected = 0;  ///< expected length of a normal vector
};

}  // namespace

Eigen::VectorXd CovarianceSearch::best_from(const Eigen::VectorXd& begin,
                                            const Eigen::VectorXd& spread) const {
  std::vector<Eigen::Index> used;
  for (Eigen::Index i = 0; i < begin.size(); ++i) {
    if (spread[i] > 0) {
      used.push_back(i);
    }
  }
  Eigen::VectorXd best = begin;
  const auto n = static_cast<Eigen::Index>(used.size());
  if (n == 0) {
    return best;
  }
  const double dimensions = static_cast<double>(n);
  const std::size_t size = 10 + 2 * static_cast<std::size_t>(std::floor(1.5 * std::log(dimensions)));
  const Rates rates(size / 2, dimensions);
  Eigen::VectorXd scale(n);  // numbers are scaled by their spread
  for (Eigen::Index k = 0; k < n; ++k) {
    scale[k] = spread[used[static_cast<std::size_t>(k)]];
  }
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd path = mean;
  Eigen::VectorXd step_path = mean;
  double step = 1;
  double least = values({begin}).front();
  std::mt19937_64 random(draws_seed);
  std::normal_distribution<double> normal;
  const auto place_of = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd place = begin;
    for (Eigen::Index k = 0; k < n; ++k) {
      place[used[static_cast<std::size_t>(k)]] += scale[k] * at[k];
    }
    return place;
  };
  std::size_t done = 1;
  for (std::size_t turn = 1; done + size <= most; ++turn) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(covariance);
    const Eigen::VectorXd lengths = axes.eigenvalues().cwiseMax(1e-20).cwiseSqrt();
    if (step * (covariance.diagonal().cwiseSqrt().cwiseProduct(scale)).maxCoeff() < settled) {
      break;
    }
    std::vector<Eigen::VectorXd> steps;
    std::vector<Eigen::VectorXd> places;
    for (std::size_t i = 0; i < size; ++i) {
      const Eigen::VectorXd drawn = Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
      steps.push_back(axes.eigenvectors() * lengths.cwiseProduct(drawn));
      places.push_back(place_of(mean + step * steps.back()));
    }
    const std::vector<double> found = values(places);
    done += size;
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return found[i]; });
    if (found[order.front()] < least) {
      least = found[order.front()];
      best = places[order.front()];
    }
    Eigen::VectorXd move = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd spread_of_best = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < rates.weights.size(); ++i) {
      const Eigen::VectorXd& one = steps[order[static_cast<std::size_t>(i)]];
      move += rates.weights[i] * one;
      spread_of_best += rates.weights[i] * one * one.transpose();
    }
    mean += step * move;
    const Eigen::VectorXd straight =
        axes.eigenvectors() * (axes.eigenvectors().transpose() * move).cwiseQuotient(lengths);
    step_path = (1 - rates.step_path) * step_path +
                std::sqrt(rates.step_path * (2 - rates.step_path) * rates.effective) * straight;
    const double grown = 1 - std::pow(1 - rates.step_path, 2 * static_cast<double>(turn));
    const bool is_steady =
        step_path.norm() / std::sqrt(grown) < (1.4 + 2 / (dimensions + 1)) * rates.expected;
    path = (1 - rates.path) * path;
    if (is_steady) {
      path += std::sqrt(rates.path * (2 - rates.path) * rates.effective) * move;
    }
    const double kept = is_steady ? 0 : rates.path * (2 - rates.path);
    covariance = (1 - rates.one - rates.mu) * covariance +
                 rates.one * (path * path.transpose() + kept * covariance) + rates.mu * spread_of_best;
    covariance = (covariance + covariance.transpose().eval()) / 2;
    step *=
        std::exp(std::min(1.0, rates.step_path / rates.damping * (step_path.norm() / rates.expected - 1)));
  }
  return best;
}

}  // namespace feedscope
