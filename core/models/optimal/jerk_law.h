#pragma once

#include <vector>

#include "core/models/optimal/jerk_solver.h"
#include "core/models/optimal/static_law.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// A law close to the fastest under velocity, acceleration and jerk limits of every axis, from standstill to
/// standstill (README.md in this folder):
///
///   |T_j s''' + 3 c_j v v' + d_j v^3| <= J_j
///
/// on lines and arcs of the program with J, on corner blends with Jtb. It begins with StaticLaw, lowered
/// around the places where it does not keep all limits strictly, and is improved by JerkSolver in windows
/// that overlap, again on finer cells. Two pieces of constant jerk a cell. Curvature may jump between
/// elements: v and v' are continuous there, the acceleration across the path is not.
class JerkLaw {
 public:
  /// `builder` contains the path and takes the motion.
  JerkLaw(const AxisVectors& axes, TrajectoryBuilder& builder);

  /// Lays the motion over elements [first, last).
  void run(std::uint32_t first, std::uint32_t last, ProgressSteps& steps);

 private:
  /// Elements [first, last) with common cells: the pieces of a line, or a curve with a tiny element made by
  /// rounding next to it.
  struct Span {
    std::uint32_t first;
    std::uint32_t last;
    double begin;   ///< from the start of the stretch [mm]
    double length;  ///< [mm]
    SpeedBound feed;
    double time;  ///< at the speeds of StaticLaw [s]
    bool straight;
    Vec3 tangent;  ///< at its beginning
  };
  struct Cell {
    double length;
    double offset;  ///< in the span [mm]
    std::uint32_t span;
    double slower;  ///< factor of times by which it is slower than its limits allow at the checked places
  };
  static constexpr std::uint32_t none = 0xffffffff;

  void join_elements(std::uint32_t first, std::uint32_t last);
  Span span_of(std::uint32_t element, double begin);
  bool join(Span& span, const Span& next) const;
  void append_element(std::uint32_t element);
  void load_span(std::uint32_t index);
  void plan();
  void cut_cells();
  double cut_part(std::uint32_t index, double begin, double from, double to, std::size_t part);
  void fill_places(std::size_t first, std::size_t last);
  void add_places(std::size_t index);
  void start_strictly();
  bool lower_exceeded();
  void slow_nodes(double factor);
  void slow_strictly();
  void improve(double mu, ProgressSteps& steps);
  bool refine();
  bool is_coarse(const Cell& cell, const CellMotion& motion);
  double excess_of(const Cell& cell, const CellMotion& motion);
  double excess_of(const Cell& cell, const Motion1d& from, double jerk, double time);
  CellMotion motion_of(std::size_t cell) const;
  double time() const;
  void add_planned(std::uint32_t last);
  void add_piece(const Motion1d& from, double jerk, double time, Cause cause, std::uint32_t last);
  Cause planned_cause(const PlanElement& element, double jerk, const Motion1d& at) const;
  void add_pieces(std::size_t first, std::size_t last, std::uint32_t last_element);
  Cause cause_of(std::size_t cell, const CellMotion& motion) const;
  PathPoint point_at(double s);
  PlaceLimits limits_at(double s, double slower = 1);
  const Vec3& jerk_of(std::uint32_t index) const;

  const AxisVectors& axes_;
  TrajectoryBuilder& builder_;
  CellRule rule_;

  StaticLaw static_law_;
  double min_time_ = 0;  ///< of a cell [s]
  std::vector<Span> spans_;
  std::vector<Cell> cells_;
  std::vector<LawNode> nodes_;
  std::vector<Cell> finer_cells_;
  std::vector<LawNode> finer_nodes_;

  std::vector<SolverCell> solver_cells_;
  std::vector<CellPlace> places_;
  JerkSolver solver_;

  std::vector<PathCell> geometry_;  ///< of span loaded_
  std::uint32_t loaded_ = none;
  bool straight_ = true;  ///< true if span loaded_ is
  SpeedBound feed_;       ///< of that span
  std::size_t at_ = 0;    ///< last geometry cell used
  double excess_ = 1;
  std::uint32_t element_ = 0;  ///< on which the last piece begins
  double element_begin_ = 0;   ///< from the start of the stretch [mm]
};

}  // namespace feedscope
