#include "core/identification/parameter_judgement.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/roots.h"
#include "core/base/translatable.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double seen = 12;  // significant change of the sum of squares
// Certain rise over the optimum: a part of the trace that is off by chance affects the times of its stretch
// and of those of eight and 64 together, and all numbers that depend on it.
constexpr double certain = 50;
constexpr double coarsest = 0.2;  // uncertainty as a share of the value from which it is no result
// Rise of the sum of squares, in units of the residual, of equally good explanations: neighbours contribute
// to several residuals.
constexpr double no_worse = 45;
constexpr double beyond_tried = 2;   // the search has not visited all equally good points
constexpr double least_cost = 0.25;  // units of noise and sampling are rather too large
constexpr double most_excess = 5;    // from here on a search may have ended in a wrong local minimum
constexpr double most_in_one_block = 0.85;
constexpr double model_error = 1e-3;  // smallest share claimed as uncertainty
constexpr double sureness = 2;        // standard deviations
constexpr double least_slope = 1e-3;  // of all residuals together, per logarithm

constexpr const char* without_influence =
    QT_TRANSLATE_NOOP("core", "It changes nothing that these traces show.");
constexpr const char* only_bound =
    QT_TRANSLATE_NOOP("core", "These traces never reach it: larger values show the same.");
constexpr const char* only_upper_bound =
    QT_TRANSLATE_NOOP("core", "These traces show the same with smaller values.");
constexpr const char* one_place = QT_TRANSLATE_NOOP(
    "core", "One place of these traces alone speaks for it, where something else may limit.");
constexpr const char* more_than_noise =
    QT_TRANSLATE_NOOP("core",
                      "The model leaves over more than noise and sampling of these traces make: another "
                      "value may explain them.");
constexpr const char* not_apart =
    QT_TRANSLATE_NOOP("core", "It cannot be told apart from the others by these traces.");

/// Excess over the optimum, in units of its own mean square.
double rise(const Eigen::VectorXd& there, double cost_here, Eigen::Index stretches) {
  return (ParameterSearch::cost(there) - cost_here) * static_cast<double>(stretches) /
         std::max(cost_here, 1.0);
}

/// Standard deviations of the logarithms from the residuals, and from omitting each twelfth in turn; infinite
/// for parameters without slope.
std::vector<double> deviations(const ParameterSearch& search, const Eigen::MatrixXd& derivatives,
                               const Eigen::VectorXd& residuals) {
  std::vector<Eigen::Index> used;
  for (Eigen::Index p = 0; p < derivatives.cols(); ++p) {
    if (derivatives.col(p).norm() > least_slope) {
      used.push_back(p);
    }
  }
  std::vector<double> found(static_cast<std::size_t>(derivatives.cols()),
                            std::numeric_limits<double>::infinity());
  if (used.empty()) {
    return found;
  }
  const auto count = static_cast<Eigen::Index>(used.size());
  const Eigen::VectorXd weights = residuals.unaryExpr(&weight_of);
  Eigen::MatrixXd slopes(derivatives.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    slopes.col(k) = derivatives.col(used[static_cast<std::size_t>(k)]);
  }
  const Eigen::MatrixXd weighted = weights.asDiagonal() * slopes;
  const Eigen::MatrixXd square = slopes.transpose() * weighted;
  const double noise =
      std::max(1.0, residuals.cwiseAbs2().dot(weights) /
                        static_cast<double>(std::max<Eigen::Index>(1, residuals.size() - count)));
  const Eigen::MatrixXd inverse = (square + 1e-12 * square.trace() * Eigen::MatrixXd::Identity(count, count))
                                      .ldlt()
                                      .solve(Eigen::MatrixXd::Identity(count, count));
  Eigen::MatrixXd shifts(count, static_cast<Eigen::Index>(ParameterSearch::block_count));
  for (std::size_t block = 0; block < ParameterSearch::block_count; ++block) {
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(count);
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
      if (search.blocks()[static_cast<std::size_t>(i)] != block) {
        part += weights[i] * slopes.row(i).transpose() * slopes.row(i);
        pull += weights[i] * residuals[i] * slopes.row(i).transpose();
      }
    }
    part += 1e-9 * square.trace() * Eigen::MatrixXd::Identity(count, count);
    shifts.col(static_cast<Eigen::Index>(block)) = -part.ldlt().solve(pull);
  }
  const Eigen::VectorXd mean = shifts.rowwise().mean();
  constexpr auto blocks = static_cast<double>(ParameterSearch::block_count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double formal = std::sqrt(std::max(0.0, noise * inverse(k, k)));
    const double left_out =
        std::sqrt((blocks - 1) / blocks * (shifts.row(k).array() - mean[k]).square().sum());
    found[static_cast<std::size_t>(used[static_cast<std::size_t>(k)])] = std::max(formal, left_out);
  }
  return found;
}

/// Lower bound visible in the traces: a smaller value makes them worse. `low`: logarithm of such a value.
double bound_below(ParameterSearch& search, Eigen::Index parameter, double low, double cost_here,
                   Eigen::Index stretches) {
  constexpr int halvings = 7;
  const Eigen::VectorXd at = search.logarithms();
  const Bracket bracket = halve({low, at[parameter]}, halvings, [&](double logarithm) {
    Eigen::VectorXd there = at;
    there[parameter] = logarithm;
    return rise(search.evaluate(there), cost_here, stretches) > certain;
  });
  return std::exp(bracket.low);
}

/// Largest share of a parameter's effect in one twelfth of the traces.
double share_of_one_block(const ParameterSearch& search, const Eigen::VectorXd& slopes) {
  std::array<double, ParameterSearch::block_count> sums{};
  double all = 0;
  for (Eigen::Index i = 0; i < slopes.size(); ++i) {
    if (!search.is_short(static_cast<std::size_t>(i))) {
      continue;
    }
    sums[search.blocks()[static_cast<std::size_t>(i)]] += slopes[i] * slopes[i];
    all += slopes[i] * slopes[i];
  }
  return all > 0 ? *std::ranges::max_element(sums) / all : 1;
}

Eigen::Index stretches_of(const ParameterSearch& search) {
  return static_cast<Eigen::Index>(search.stretches());
}

/// 90 % quantiles of the residuals, of short stretches and of the others: single places where a stop falls on
/// different sides of a border do not count.
struct LeftOver {
  double of_short = 0;
  double of_others = 0;

  /// Residual of long stretches relative to noise: noise does not add up there, the effect of a wrong number
  /// does.
  double excess() const {
    constexpr double as_much = 1.2;
    constexpr double little = 0.5;
    return of_others / std::max(little, as_much * of_short);
  }
};

LeftOver left_over(const ParameterSearch& search, const Eigen::VectorXd& residuals) {
  std::array<std::vector<double>, 2> sizes;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    sizes[search.is_short(static_cast<std::size_t>(i)) ? 0 : 1].push_back(std::abs(residuals[i]));
  }
  const auto most = [](std::vector<double>& some) {
    if (some.empty()) {
      return 0.0;
    }
    const auto at = some.begin() + static_cast<std::ptrdiff_t>(some.size() * 9 / 10);
    std::ranges::nth_element(some, at);
    return *at;
  };
  return {most(sizes[0]), most(sizes[1])};
}

}  // namespace

bool leaves_noise_alone(ParameterSearch& search) {
  constexpr double noise = 1.2;
  const LeftOver left = left_over(search, search.evaluate(search.logarithms()));
  return left.of_short < noise && left.excess() <= 1;
}

std::vector<bool> acting_by_steps(ParameterSearch& search) {
  const std::array steps{1e-3, -1e-3, std::log(1.5), -std::log(1.5)};
  const Eigen::VectorXd at = search.logarithms();
  std::vector<Eigen::VectorXd> places{at};
  for (Eigen::Index p = 0; p < at.size(); ++p) {
    for (const double step : steps) {
      places.push_back(at);
      places.back()[p] += step;
    }
  }
  const std::vector<Eigen::VectorXd> all = search.evaluate_all(places);
  std::vector<bool> by_steps;
  for (std::size_t p = 0; p < search.size(); ++p) {
    const auto change = [&](std::size_t step) { return (all[1 + steps.size() * p + step] - all[0]).norm(); };
    by_steps.push_back(std::min(change(0), change(1)) == 0 && std::min(change(2), change(3)) > 0);
  }
  return by_steps;
}

std::vector<bool> influences(ParameterSearch& search) {
  const Eigen::VectorXd at = search.logarithms();
  std::vector<Eigen::VectorXd> places{at};
  for (Eigen::Index p = 0; p < at.size(); ++p) {
    for (const double step : {std::log(1.5), -std::log(1.5)}) {
      places.push_back(at);
      places.back()[p] += step;
    }
  }
  const std::vector<Eigen::VectorXd> all = search.evaluate_all(places);
  std::vector<bool> influence(search.size());
  for (std::size_t p = 0; p < search.size(); ++p) {
    influence[p] =
        (all[1 + 2 * p] - all[0]).squaredNorm() > seen || (all[2 + 2 * p] - all[0]).squaredNorm() > seen;
  }
  return influence;
}

std::vector<IdentifiedParameter> judge_parameters(ParameterSearch& search, const std::vector<double>& start,
                                                  const std::vector<double>& without) {
  const Eigen::VectorXd at = search.logarithms();
  const Eigen::VectorXd residuals = search.evaluate(at);
  const double here = ParameterSearch::cost(residuals);
  const Eigen::MatrixXd derivatives = search.jacobian(at);
  const std::vector<double> deviation = deviations(search, derivatives, residuals);
  const double excess = std::max(1.0, left_over(search, residuals).excess());
  const bool is_systematic = excess > most_excess;
  const Eigen::VectorXd as_well = search.reach_of_places(here + no_worse * std::max(here, least_cost) /
                                                                    static_cast<double>(search.stretches()));
  std::vector<Eigen::VectorXd> places;
  for (Eigen::Index p = 0; p < at.size(); ++p) {
    for (const double step : {std::log(2.0), -std::log(2.0)}) {
      places.push_back(at);
      places.back()[p] += step;
    }
  }
  const std::vector<Eigen::VectorXd> all = search.evaluate_all(places);
  std::vector<IdentifiedParameter> judged;
  for (std::size_t p = 0; p < search.size(); ++p) {
    IdentifiedParameter one;
    one.parameter = search.parameters()[p];
    one.start = start[p];
    one.value = std::exp(at[static_cast<Eigen::Index>(p)]);
    const bool above = rise(all[2 * p], here, stretches_of(search)) > certain;
    const bool below = rise(all[2 * p + 1], here, stretches_of(search)) > certain;
    const double share = excess * std::hypot(std::max(sureness * deviation[p],
                                                      beyond_tried * as_well[static_cast<Eigen::Index>(p)]),
                                             model_error);
    const auto stretches = static_cast<double>(search.stretches());
    const bool needed = (without[p] - here) * stretches / std::max(here, 1.0) > certain;
    const bool alone =
        search.parameters()[p].unit == "m/min" &&
        share_of_one_block(search, derivatives.col(static_cast<Eigen::Index>(p))) > most_in_one_block;
    one.told = above && below && needed && !alone && !is_systematic && share <= coarsest;
    if (one.told) {
      one.uncertainty = share * one.value;
    } else if (!above && !below) {
      // Its half has no effect, but the start value may.
      Eigen::VectorXd begun = at;
      begun[static_cast<Eigen::Index>(p)] =
          one.start > 0 ? std::log(one.start) : begun[static_cast<Eigen::Index>(p)];
      if (rise(search.evaluate(begun), here, stretches_of(search)) <= certain) {
        one.reason = without_influence;
      } else if (one.start < one.value) {
        one.reason = only_bound;
        one.at_least = bound_below(search, static_cast<Eigen::Index>(p), std::log(one.start), here,
                                   stretches_of(search));
      } else {
        one.reason = only_upper_bound;
      }
    } else if (!above || (!needed && one.parameter.unit != "m/min")) {
      one.reason = only_bound;
      one.at_least =
          bound_below(search, static_cast<Eigen::Index>(p), at[static_cast<Eigen::Index>(p)] - std::log(2.0),
                      here, stretches_of(search));
    } else if (!below) {
      one.reason = only_upper_bound;
    } else if (is_systematic) {
      one.reason = more_than_noise;
    } else if (alone) {
      one.reason = one_place;
    } else {
      one.reason = not_apart;
    }
    judged.push_back(std::move(one));
  }
  return judged;
}

void take_back(ParameterSearch& search, std::vector<IdentifiedParameter>& parameters) {
  constexpr int halvings = 7;
  constexpr double shown = 1;  // rise of the sum of squares, in units of noise
  const double here = ParameterSearch::cost(search.evaluate(search.logarithms()));
  const auto rise_at = [&](std::size_t p, double logarithm) {
    Eigen::VectorXd at = search.logarithms();
    at[static_cast<Eigen::Index>(p)] = logarithm;
    return rise(search.evaluate(at), here, stretches_of(search));
  };
  const auto take = [&](std::size_t p, double logarithm) {
    Eigen::VectorXd at = search.logarithms();
    at[static_cast<Eigen::Index>(p)] = logarithm;
    search.move_to(at);
    parameters[p].value = std::exp(logarithm);
  };
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    IdentifiedParameter& one = parameters[p];
    if (one.told) {
      continue;
    }
    if (one.start > 0 && rise_at(p, std::log(one.start)) <= seen) {
      take(p, std::log(one.start));
      one.value = one.start;
    } else if (one.at_least && *one.at_least < one.value) {
      const double stays = std::max(shown, rise_at(p, std::log(one.value)));
      const Bracket bracket = halve({std::log(one.value), std::log(*one.at_least)}, halvings,
                                    [&](double logarithm) { return rise_at(p, logarithm) <= stays; });
      take(p, bracket.low);
    }
  }
}

void add_reached_velocities(std::vector<IdentifiedParameter>& parameters, const FitCases& cases) {
  for (IdentifiedParameter& one : parameters) {
    if (one.told || one.reason != without_influence || !one.parameter.key.ends_with(".velocity")) {
      continue;
    }
    double reached = 0;
    for (const auto& fit : cases) {
      const AxisVector<AxisReach> reach = fit->reach();
      const AxisReach* axis = reach.find(one.parameter.key.front());
      reached = axis == nullptr ? reached : std::max(reached, units::to_m_min(axis->velocity));
    }
    if (reached > 0 && reached <= one.value) {
      one.reason = only_bound;
      one.at_least = reached;
    }
  }
}

}  // namespace feedscope
