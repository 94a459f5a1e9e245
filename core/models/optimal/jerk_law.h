#pragma once

#include <vector>

#include "core/models/optimal/jerk_solver.h"
#include "core/models/optimal/static_law.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// A law close to the fastest under velocity, acceleration and jerk limits of every axis, from standstill to
/// standstill (README.md beside this file):
///
///   |T_j s''' + 3 c_j v v' + d_j v^3| <= J_j
///
/// on lines and arcs of the program with J, on corner blends with Jtb. It begins with StaticLaw, lowered
/// around the places where it does not keep all limits strictly, and is improved by JerkSolver in windows
/// that overlap. Two pieces of constant jerk a cell. Curvature may jump between elements: v and v' are
/// continuous there, the acceleration across the path is not.
class JerkLaw {
 public:
  /// `builder` holds the path and takes the motion.
  JerkLaw(const AxisVectors& axes, TrajectoryBuilder& builder);

  /// Lays the motion over elements [first, last).
  void run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps);

 private:
  struct Cell {
    double length;
    double offset;  ///< in the element [mm]
    std::uint32_t element;
  };

  void plan(std::uint32_t first, std::uint32_t last);
  void cut_cells(std::uint32_t first, std::uint32_t last);
  double cut_part(std::uint32_t index, double begin, double from, double to, std::size_t part);
  void fill_places(std::size_t first, std::size_t last);
  void add_places(const Cell& cell);
  void start_strictly(std::uint32_t first, std::uint32_t last);
  bool lower_exceeded();
  void slow_nodes(double factor);
  void improve(ProgressSteps& steps);
  double time() const;
  void add_planned(std::uint32_t first, std::uint32_t last);
  Cause planned_cause(const PlanElement& element, double jerk, const Motion1d& at) const;
  void add_pieces(std::size_t first, std::size_t last);
  void add_half(const Cell& cell, const Motion1d& from, double jerk, double time, Cause cause);
  Cause cause_of(std::size_t cell, const CellMotion& motion) const;
  void load_element(std::uint32_t index, int fineness = 1);
  PathPoint point_at(double s);
  PlaceLimits limits_at(double s);
  const Vec3& jerk_of(std::uint32_t index) const;

  const AxisVectors& axes_;
  TrajectoryBuilder& builder_;
  CellRule rule_;

  StaticLaw static_law_;
  double min_time_ = 0;  ///< of a cell [s]
  std::vector<Cell> cells_;
  std::vector<LawNode> nodes_;

  std::vector<SolverCell> solver_cells_;
  std::vector<CellPlace> places_;
  JerkSolver solver_;

  std::vector<PathCell> geometry_;  ///< of element loaded_
  std::uint32_t loaded_ = 0;
  bool straight_ = true;  ///< element loaded_ is
  SpeedBound feed_;       ///< of that element
  std::size_t at_ = 0;    ///< last geometry cell looked at
  double excess_ = 1;
};

}  // namespace feedscope
