#include "core/models/optimal/jerk_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

/// About the share by which the resulting time is too long, for every active limit in a cell.
constexpr double last_mu = 4e-5;
constexpr double less_mu = 0.25;
/// Share of the time: the last steps continue until they gain less.
constexpr double settled = 1e-9;
constexpr int max_steps = 200;
constexpr int max_halvings = 30;

}  // namespace

bool JerkSolver::keeps_limits(const SolverCell& cell, const std::vector<CellPlace>& places,
                              const LawNode* nodes) {
  const CellMotion motion = CellMotion::through(cell.length, nodes[0].v, nodes[0].a, nodes[1].v, nodes[1].a);
  return std::isfinite(cell_value(motion, places.data() + cell.first, places.data() + cell.last, 1));
}

/// Weight of the barriers of a cell: by its time, but at least as much as others have where that is tiny,
/// until `mu` is small. Otherwise its limits would shorten every step of the whole window.
double JerkSolver::barrier(std::size_t cell, double mu) const {
  return mu * std::max(weight_[cell], mu * time_);
}

double JerkSolver::value(const LawNode* nodes, double mu) const {
  double sum = 0;
  for (std::size_t i = 0; i < cells_->size(); ++i) {
    const SolverCell& cell = (*cells_)[i];
    const CellMotion motion =
        CellMotion::through(cell.length, nodes[i].v, nodes[i].a, nodes[i + 1].v, nodes[i + 1].a);
    sum += cell_value(motion, places_->data() + cell.first, places_->data() + cell.last, barrier(i, mu));
    if (!std::isfinite(sum)) {
      break;
    }
  }
  return sum;
}

void JerkSolver::assemble(const LawNode* nodes, double mu) {
  const std::size_t count = cells_->size();
  diagonal_.assign(count + 1, Matrix2::Zero());
  beside_.assign(count, Matrix2::Zero());
  slope_.assign(count + 1, Vector2::Zero());
  for (std::size_t i = 0; i < count; ++i) {
    const SolverCell& cell = (*cells_)[i];
    const CellMotion motion =
        CellMotion::through(cell.length, nodes[i].v, nodes[i].a, nodes[i + 1].v, nodes[i + 1].a);
    const CellCost cost = cell_cost(motion, cell.length, places_->data() + cell.first,
                                    places_->data() + cell.last, barrier(i, mu));
    diagonal_[i] += cost.curvature.topLeftCorner<2, 2>();
    beside_[i] += cost.curvature.topRightCorner<2, 2>();
    diagonal_[i + 1] += cost.curvature.bottomRightCorner<2, 2>();
    slope_[i] += cost.slope.head<2>();
    slope_[i + 1] += cost.slope.tail<2>();
  }
}

/// Block elimination over the inner nodes; returns the slope along the step.
double JerkSolver::solve() {
  const std::size_t count = cells_->size();
  constexpr double slight = 1e-12;
  move_.assign(count + 1, Vector2::Zero());
  std::vector<Matrix2>& inverse = diagonal_;
  for (std::size_t i = 1; i < count; ++i) {
    Matrix2 pivot = diagonal_[i];
    Vector2 right = -slope_[i];
    if (i > 1) {
      const Matrix2 factor = beside_[i - 1].transpose() * inverse[i - 1];
      pivot -= factor * beside_[i - 1];
      right -= factor * move_[i - 1];
    }
    pivot.diagonal() += slight * diagonal_[i].diagonal();
    inverse[i] = pivot.inverse();
    move_[i] = right;
  }
  double along = 0;
  for (std::size_t i = count; i-- > 1;) {
    Vector2 right = move_[i];
    if (i + 1 < count) {
      right -= beside_[i] * move_[i + 1];
    }
    move_[i] = inverse[i] * right;
    along += move_[i].dot(slope_[i]);
  }
  return along;
}

/// One Newton step, shortened until it lowers the value.
JerkSolver::Step JerkSolver::step(LawNode* nodes, double mu) {
  assemble(nodes, mu);
  const double along = solve();
  const double before = value(nodes, mu);
  if (!std::isfinite(before)) {  // rounding: no step can be judged
    return {0, 0};
  }
  const std::size_t count = cells_->size();
  trial_.resize(count + 1);
  double share = 1;
  for (int i = 0; i < max_halvings; ++i, share /= 2) {
    for (std::size_t n = 0; n <= count; ++n) {
      const double square = nodes[n].v * nodes[n].v + share * move_[n][0];
      trial_[n] = {std::sqrt(std::max(square, 0.0)), nodes[n].a + share * move_[n][1]};
    }
    if (value(trial_.data(), mu) <= before + 0.1 * share * along) {
      std::copy(trial_.begin(), trial_.end(), nodes);
      return {share, -along};
    }
  }
  return {0, -along};
}

void JerkSolver::improve(const std::vector<SolverCell>& cells, const std::vector<CellPlace>& places,
                         LawNode* nodes, double mu) {
  cells_ = &cells;
  places_ = &places;
  weight_.clear();
  time_ = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    weight_.push_back(
        CellMotion::through(cells[i].length, nodes[i].v, nodes[i].a, nodes[i + 1].v, nodes[i + 1].a).time);
    time_ += weight_.back();
  }
  for (int i = 0; i < max_steps; ++i) {
    const Step taken = step(nodes, mu);
    if (mu <= last_mu) {
      if (taken.share == 0 || taken.gain < settled * time_) {
        break;
      }
    } else if (taken.share == 0 || taken.share >= 0.5) {
      mu = std::max(mu * less_mu, last_mu);
    }
  }
}

}  // namespace feedscope
