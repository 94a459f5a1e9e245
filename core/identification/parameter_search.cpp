#include "core/identification/parameter_search.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/identification/covariance_search.h"

namespace feedscope {
namespace {

constexpr double difference = 0.01;  // of a logarithm, for derivatives

}  // namespace

double weight_of(double residual) {
  const double share = residual / robust_from;
  return 1 / std::sqrt(1 + share * share);
}

ParameterSearch::ParameterSearch(const FitCases& cases, Setup start, std::vector<FitParameter> parameters,
                                 Progress* progress)
    : cases_(cases), start_(std::move(start)), parameters_(std::move(parameters)), progress_(progress) {
  at_.resize(static_cast<Eigen::Index>(parameters_.size()));
  for (std::size_t p = 0; p < parameters_.size(); ++p) {
    const double value = fit_value(start_, parameters_[p]);
    at_[static_cast<Eigen::Index>(p)] =
        std::log(std::clamp(value, parameters_[p].least, parameters_[p].most));
  }
  for (const auto& one : cases_) {
    for (std::size_t i = 0; i < one->size(); ++i) {
      short_.push_back(one->is_short(i));
      blocks_.push_back(std::min(block_count - 1, one->stretch_of(i) * block_count / one->stretches()));
    }
    count_ += one->size();
    stretches_ += one->stretches();
  }
}

void ParameterSearch::stage(double begin, double end, std::size_t evaluations) {
  begin_ = begin;
  end_ = end;
  expected_ = std::max<std::size_t>(1, evaluations);
  done_ = 0;
}

void ParameterSearch::report(std::size_t evaluations) {
  done_ += evaluations;
  simulations_ += evaluations * cases_.size();
  if (progress_ != nullptr) {
    progress_->report(begin_ + (end_ - begin_) * std::min(1.0, static_cast<double>(done_) /
                                                                   static_cast<double>(expected_)));
  }
}

Eigen::VectorXd ParameterSearch::clamped(const Eigen::VectorXd& at) const {
  Eigen::VectorXd inside = at;
  for (std::size_t p = 0; p < parameters_.size(); ++p) {
    auto& value = inside[static_cast<Eigen::Index>(p)];
    value = std::clamp(value, std::log(parameters_[p].least), std::log(parameters_[p].most));
  }
  return inside;
}

void ParameterSearch::move_to(const Eigen::VectorXd& at) {
  at_ = clamped(at);
}

namespace {

/// Rounds to ten digits: 75 remains 75 through its logarithm.
double without_dirt(double value) {
  return std::stod(fmt::format("{:.10g}", value));
}

}  // namespace

Setup ParameterSearch::setup_at(const Eigen::VectorXd& at) const {
  Setup setup = start_;
  for (std::size_t p = 0; p < parameters_.size(); ++p) {
    set_fit_value(setup, parameters_[p], without_dirt(std::exp(at[static_cast<Eigen::Index>(p)])));
  }
  return setup;
}

std::vector<Eigen::VectorXd> ParameterSearch::evaluate_all(const std::vector<Eigen::VectorXd>& places) {
  std::vector<Eigen::VectorXd> all(places.size());
  in_parallel(places.size(), [&](std::size_t i) {
    const Setup setup = setup_at(clamped(places[i]));
    Eigen::VectorXd residuals(static_cast<Eigen::Index>(count_));
    Eigen::Index next = 0;
    Progress unwatched;
    Progress part(progress_ != nullptr ? *progress_ : unwatched, unseen_share);
    for (const auto& one : cases_) {
      for (const double residual : one->residuals(setup, &part)) {
        residuals[next++] = residual;
      }
    }
    all[i] = std::move(residuals);
  });
  for (std::size_t i = 0; i < places.size(); ++i) {
    places_.push_back({clamped(places[i]), cost(all[i])});
  }
  report(places.size());
  return all;
}

Eigen::VectorXd ParameterSearch::evaluate(const Eigen::VectorXd& at) {
  return evaluate_all({at}).front();
}

double ParameterSearch::cost(const Eigen::VectorXd& residuals) {
  double sum = 0;
  for (const double residual : residuals) {
    const double share = residual / robust_from;
    sum += 2 * robust_from * robust_from * (std::sqrt(1 + share * share) - 1);
  }
  return sum / static_cast<double>(std::max<Eigen::Index>(1, residuals.size()));
}

Eigen::VectorXd ParameterSearch::reach_of_places(double cost) const {
  Eigen::VectorXd reach = Eigen::VectorXd::Zero(at_.size());
  for (const Place& place : places_) {
    if (place.cost <= cost) {
      reach = reach.cwiseMax((place.at - at_).cwiseAbs());
    }
  }
  return reach;
}

Eigen::MatrixXd ParameterSearch::jacobian(const Eigen::VectorXd& at) {
  return jacobian(at, std::vector<bool>(size(), true));
}

Eigen::MatrixXd ParameterSearch::jacobian(const Eigen::VectorXd& at, const std::vector<bool>& of) {
  std::vector<Eigen::Index> columns;
  std::vector<Eigen::VectorXd> places;
  for (std::size_t p = 0; p < size(); ++p) {
    if (!of[p]) {
      continue;
    }
    columns.push_back(static_cast<Eigen::Index>(p));
    for (const double sign : {1.0, -1.0}) {
      places.push_back(at);
      places.back()[columns.back()] += sign * difference;
    }
  }
  const std::vector<Eigen::VectorXd> all = evaluate_all(places);
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count_), at.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    derivatives.col(columns[i]) = (all[2 * i] - all[2 * i + 1]) / (2 * difference);
  }
  return derivatives;
}

void ParameterSearch::scan(double reach, double ratio) {
  scan(reach, ratio, std::vector<bool>(size(), true));
}

void ParameterSearch::scan(double reach, double ratio, const std::vector<bool>& of) {
  for (std::size_t p = 0; p < size(); ++p) {
    if (of[p]) {
      scan_one(p, reach, ratio);
    }
  }
}

void ParameterSearch::scan_one(std::size_t parameter, double reach, double ratio) {
  const auto p = static_cast<Eigen::Index>(parameter);
  std::vector<Eigen::VectorXd> places{at_};
  for (double factor = ratio; factor <= reach * 1.0001; factor *= ratio) {
    for (const double step : {std::log(factor), -std::log(factor)}) {
      places.push_back(at_);
      places.back()[p] += step;
    }
  }
  const std::vector<Eigen::VectorXd> all = evaluate_all(places);
  std::size_t best = 0;
  double least = cost(all[0]);
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (cost(all[i]) < least * (1 - 1e-6)) {  // values without effect do not change
      least = cost(all[i]);
      best = i;
    }
  }
  at_ = clamped(places[best]);
}

void ParameterSearch::search_widely(const std::vector<bool>& free, double spread, std::size_t most) {
  Eigen::VectorXd spreads = Eigen::VectorXd::Zero(at_.size());
  for (std::size_t p = 0; p < free.size(); ++p) {
    spreads[static_cast<Eigen::Index>(p)] = free[p] ? spread : 0;
  }
  CovarianceSearch wide;
  wide.most = most;
  wide.values = [this](const std::vector<Eigen::VectorXd>& places) {
    std::vector<double> costs;
    for (const Eigen::VectorXd& residuals : evaluate_all(places)) {
      costs.push_back(cost(residuals));
    }
    return costs;
  };
  move_to(wide.best_from(at_, spreads));
}

namespace {

struct Together {
  ParameterSearch* search = nullptr;
  const std::vector<Eigen::Index>* free = nullptr;
  Eigen::VectorXd at;
  std::exception_ptr error;
  nlopt_opt handle = nullptr;
};

double together_cost(unsigned count, const double* x, double* /*gradient*/, void* data) {
  auto& together = *static_cast<Together*>(data);
  try {  // no exceptions through the C library
    Eigen::VectorXd at = together.at;
    for (unsigned i = 0; i < count; ++i) {
      at[(*together.free)[i]] = x[i];
    }
    return ParameterSearch::cost(together.search->evaluate(at));
  } catch (...) {
    together.error = std::current_exception();
    nlopt_force_stop(together.handle);
    return std::numeric_limits<double>::max();
  }
}

}  // namespace

void ParameterSearch::search_together(const std::vector<bool>& free, double reach, std::size_t most) {
  std::vector<Eigen::Index> indices;
  for (std::size_t p = 0; p < free.size(); ++p) {
    if (free[p]) {
      indices.push_back(static_cast<Eigen::Index>(p));
    }
  }
  if (indices.size() < 2) {  // BOBYQA needs two; for one the following steps suffice
    return;
  }
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> handle(
      nlopt_create(NLOPT_LN_BOBYQA, static_cast<unsigned>(indices.size())), nlopt_destroy);
  std::vector<double> x;
  std::vector<double> lower;
  std::vector<double> upper;
  for (const Eigen::Index p : indices) {
    const FitParameter& parameter = parameters_[static_cast<std::size_t>(p)];
    x.push_back(at_[p]);
    lower.push_back(std::max(at_[p] - std::log(reach), std::log(parameter.least)));
    upper.push_back(std::min(at_[p] + std::log(reach), std::log(parameter.most)));
  }
  Together together{this, &indices, at_, nullptr, handle.get()};
  nlopt_set_min_objective(handle.get(), together_cost, &together);
  nlopt_set_lower_bounds(handle.get(), lower.data());
  nlopt_set_upper_bounds(handle.get(), upper.data());
  nlopt_set_initial_step1(handle.get(), std::log(reach) / 4);
  nlopt_set_xtol_abs1(handle.get(), 1e-3);
  nlopt_set_maxeval(handle.get(), static_cast<int>(most));
  const double before = cost(evaluate(at_));
  double least = before;
  nlopt_optimize(handle.get(), x.data(), &least);
  if (together.error) {
    std::rethrow_exception(together.error);
  }
  if (least < before) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      at_[indices[i]] = x[i];
    }
  }
}

void ParameterSearch::refine(const std::vector<bool>& free, int most) {
  constexpr double longest = 0.3;  // of a logarithm
  constexpr double settled = 1e-4;
  for (int step = 0; step < most; ++step) {
    const Eigen::VectorXd residuals = evaluate(at_);
    const Eigen::MatrixXd derivatives = jacobian(at_, free);
    const Eigen::VectorXd weights = residuals.unaryExpr(&weight_of);
    Eigen::MatrixXd square = derivatives.transpose() * weights.asDiagonal() * derivatives;
    square.diagonal().array() += 1e-6 * square.diagonal().maxCoeff() + 1e-12;
    Eigen::VectorXd change = -square.ldlt().solve(derivatives.transpose() * weights.asDiagonal() * residuals);
    if (change.cwiseAbs().maxCoeff() > longest) {
      change *= longest / change.cwiseAbs().maxCoeff();
    }
    std::vector<Eigen::VectorXd> places;
    for (const double share : {1.0, 0.5, 0.25, 0.06}) {
      places.push_back(clamped(at_ + share * change));
    }
    const std::vector<Eigen::VectorXd> all = evaluate_all(places);
    const double before = cost(residuals);
    std::size_t best = places.size();
    double least = before;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (cost(all[i]) < least) {
        least = cost(all[i]);
        best = i;
      }
    }
    if (best == places.size()) {
      return;
    }
    const double moved = (places[best] - at_).cwiseAbs().maxCoeff();
    at_ = places[best];
    if (moved < settled) {
      return;
    }
  }
}

}  // namespace feedscope
