#pragma once

#include <array>
#include <vector>

#include "core/models/optimal/acceleration_range.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// The fastest law s(t) under velocity and acceleration limits of every axis, from standstill to standstill
/// (MODELS section 8 a): backward-forward reachability, as TOPP-RA.
///
///   x = v^2 ^   ___ceiling___             Backwards K, the largest x from which standstill at the end is
///           |  /   K  \__    \            still reached, every constraint kept on the way; then forwards the
///           | /          \    \           largest x below K. u = x'/2 is linear on a cell, so that x at its
///           +------------------- s        end is x + length (u_begin + u_end): a linear problem in (x, u).
///
/// On lines, where the limits of a cell are constant, the law is exact: constant acceleration, ceiling,
/// constant deceleration. The limits hold at both ends of every cell of a curve; where they are exceeded in
/// between, those of the cell are lowered and the reachability is looked at again.
class AccelerationLaw {
 public:
  /// `builder` holds the path and takes the motion; `fineness` as of CellRule.
  AccelerationLaw(const Toolpath& toolpath, const AxisVectors& axes, int fineness,
                  TrajectoryBuilder& builder);

  /// Lays the motion over elements [first, last).
  void run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps);

 private:
  struct Cell {
    double length;
    double offset;
    std::uint32_t element;
    bool straight;
    SpeedBound ceiling;  ///< of x [mm2/s2]
    AccelerationRange from;
    AccelerationRange middle;
    AccelerationRange to;
    std::array<PathPoint, 3> course;  ///< of a curve: beginning, middle, end
    bool guarded = false;
    double share = 1;  ///< of their limits that `from` and `to` use
  };
  /// Motion through a cell of a curve: one piece of constant jerk.
  struct CurvedMotion {
    double x;      ///< at its end [mm2/s2]
    double begin;  ///< acceleration along the path at its beginning [mm/s2]
    double jerk;
    double time;
    bool may_be_faster;  ///< the axes would allow more, but for what follows
  };

  /// Constant accelerations between which a cell keeps its speed.
  struct Phases {
    double ceiling;  ///< of x [mm2/s2]
    double gain;     ///< [mm/s2]
    double loss;     ///< [mm/s2]
  };

  void add_element(std::uint32_t index);
  std::size_t plan_window(bool to_rest, double x);
  void reach_back(double end, std::vector<double>& highest) const;
  bool lower_exceeded(double x);
  std::size_t settled_cells() const;
  double run_cells(std::size_t count, double x);
  double run_straight(const Cell& cell, double x0, double highest);
  double run_curved(const Cell& cell, double x0, double highest);
  void add_phases(const Cell& cell, double x0, double x1, const Phases& phases);
  Cause cause_of(const Cell& cell, double x0, const CurvedMotion& motion) const;

  static double straight_end(const Cell& cell, double x0, double highest);
  static Phases curved_phases(const Cell& cell, double x0, double x1);
  static CurvedMotion curved_motion(const Cell& cell, double x0, double highest);
  static void guard(Cell& cell, double loaded);
  double load(const Cell& cell, double x0, const CurvedMotion& motion) const;

  const Toolpath& toolpath_;
  const AxisVectors& axes_;
  TrajectoryBuilder& builder_;
  CellRule rule_;
  std::vector<PathCell> path_cells_;
  std::vector<Cell> cells_;  ///< of the window: looked at together, up to element next_
  std::uint32_t next_ = 0;
  std::vector<double> highest_;          ///< K at the ends of the cells [mm2/s2]
  std::vector<double> highest_to_rest_;  ///< the same with standstill at the end of the window
  double excess_ = 1;                    ///< largest load of a cell
};

}  // namespace feedscope
