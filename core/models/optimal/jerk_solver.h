#pragma once

#include <vector>

#include "core/models/optimal/jerk_cell.h"

namespace feedscope {

/// Speed and acceleration along the path where two cells meet.
struct LawNode {
  double v = 0;  ///< [mm/s]
  double a = 0;  ///< [mm/s2]
};

/// A cell with the places where its limits are checked: [first, last) of the places.
struct SolverCell {
  double length = 0;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Lowers the time of a law by Newton steps on time and barriers (an interior point method). Only speeds and
/// accelerations of neighbouring nodes are coupled, so that the cost of a step is proportional to the number
/// of cells. Every iterate keeps all limits.
class JerkSolver {
 public:
  static constexpr double first_mu = 0.1;  ///< for nodes far from the fastest

  /// `nodes`: one more than cells; must keep the limits strictly. The first and the last are fixed. `mu`:
  /// initial weight of the barriers, smaller for nodes closer to the fastest.
  void improve(const std::vector<SolverCell>& cells, const std::vector<CellPlace>& places, LawNode* nodes,
               double mu);

  /// True if a law keeps all limits of a cell strictly; `nodes`: at its beginning and end.
  static bool keeps_limits(const SolverCell& cell, const std::vector<CellPlace>& places,
                           const LawNode* nodes);

 private:
  using Vector2 = Eigen::Vector2d;
  using Matrix2 = Eigen::Matrix2d;

  double barrier(std::size_t cell, double mu) const;
  double value(const LawNode* nodes, double mu) const;
  void assemble(const LawNode* nodes, double mu);
  double solve();
  /// A Newton step: share of it that was taken, and gain of the whole step [s].
  struct Step {
    double share;
    double gain;
  };
  Step step(LawNode* nodes, double mu);

  const std::vector<SolverCell>* cells_ = nullptr;
  const std::vector<CellPlace>* places_ = nullptr;
  std::vector<double> weight_;  ///< of a cell's barriers: its initial time [s]
  double time_ = 0;             ///< their sum
  std::vector<Matrix2> diagonal_;
  std::vector<Matrix2> beside_;  ///< couples a node with the next
  std::vector<Vector2> slope_;
  std::vector<Vector2> move_;
  std::vector<LawNode> trial_;
};

}  // namespace feedscope
