#pragma once

#include <vector>

#include "core/models/optimal/law_cells.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// The fastest law s(t) under velocity and acceleration limits of every axis, from standstill to standstill
/// (README.md in this folder): backward-forward reachability, as TOPP-RA.
///
///   x = v^2 ^   ___ceiling___             Backwards K, the largest x from which standstill at the end is
///           |  /   K  \__    \            still reachable within every constraint; then forwards the
///           | /          \    \           largest x below K. u = x'/2 is linear on a cell, so that x at its
///           +------------------- s        end is x + length (u_begin + u_end): a linear problem in (x, u).
///
/// On lines, where the limits of a cell are constant, the law is exact: constant acceleration, ceiling,
/// constant deceleration. The limits hold at both ends of every cell of a curve; where they are exceeded in
/// between, those of the cell are lowered and the reachability is looked at again.
class AccelerationLaw {
 public:
  /// `builder` contains the path and takes the motion; `fineness` as in CellRule.
  AccelerationLaw(const AxisVectors& axes, int fineness, TrajectoryBuilder& builder);

  /// Lays the motion over elements [first, last).
  void run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps);

 private:
  std::size_t plan_window(bool to_rest, double x);
  double highest_at(std::size_t node, double next) const;
  void reach_back(double end);
  void run_on(double x);
  void lower_exceeded();
  std::size_t reach_back_from(std::size_t lowered, std::size_t done);
  std::size_t settled_cells() const;
  double add_motion(std::size_t count, double x);
  std::size_t joinable(std::size_t i, std::size_t count, Cause cause) const;
  std::size_t add_curved(std::size_t i, std::size_t count, double x);
  void add_phases(std::size_t i, double x0, double x1, const Phases& phases);
  Cause cause_of(std::size_t i, double x0, const CellRun& run) const;

  TrajectoryBuilder& builder_;
  LawCells cells_;                      ///< of the window, planned together
  std::vector<double> highest_;         ///< K at the ends of the cells [mm2/s2]
  std::vector<CellRun> runs_;           ///< of the cells
  std::vector<std::uint8_t> changed_;   ///< cells to run again
  std::vector<std::uint32_t> lowered_;  ///< cells, in order
  double end_ = 0;                      ///< x allowed at the end of the window [mm2/s2]
  double excess_ = 1;                   ///< largest load of a cell
  std::size_t tried_ = 1;               ///< number of cells tried for the next piece of a curve
};

}  // namespace feedscope
