#pragma once

#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Law of a part run by path length or by its parameter, `tau` from its start [s].
LawPoint law_at(const Part& part, double tau);
/// Motion at a place of a curve, given with derivatives by the q of `law`.
Kinematics kinematics_of(const CurvePoint& at, const LawPoint& law);

/// Limiting cause of the speed on a part: its cause or, where it slows down, the cause of the speed at the
/// place ahead.
Cause limiting_cause(const Trajectory& trajectory, const Part& part);

/// Position and its derivatives on one part, for many times.
class PartMotion {
 public:
  /// `filters`: evaluates filtered parts, shared between neighbouring ones; null: their direct sum.
  PartMotion(const Trajectory& trajectory, const Part& part, FilterWalk* filters = nullptr);
  /// `tau` from the start of the part [s].
  State state(double tau) const;
  /// The same with a path length of 0, which avoids its quadrature on curves.
  State state_without_length(double tau) const;
  /// Motion without the path length, which costs a quadrature on curves.
  Kinematics kinematics(double tau) const;
  const ElementCurve& curve() const { return curve_; }

 private:
  CurvePoint curve_point(double q) const;
  double length_at(double tau) const;
  State filtered_state(State state, double tau) const;
  Kinematics filtered_kinematics(double tau) const;

  const Trajectory& trajectory_;
  Part part_;
  ElementCurve curve_;
  FilterWalk* filters_;
};

/// Parts of a trajectory one after the other: of all its pieces, or from a given time on.
///
///   for (PartWalk walk(trajectory); !walk.done(); walk.next()) { ... walk.part() ... }
class PartWalk {
 public:
  /// Starts at the beginning of piece `piece`.
  explicit PartWalk(const Trajectory& trajectory, std::size_t piece = 0);
  /// Starts at `tau` after the beginning of `piece`; the first part begins there [s].
  PartWalk(const Trajectory& trajectory, std::size_t piece, double tau);

  bool done() const { return piece_ >= trajectory_.pieces().size(); }
  const Part& part() const { return part_; }
  /// Motion of the part; valid as long as the walk.
  PartMotion motion();
  void next();

 private:
  void step();
  void enter_piece(double tau);
  void find_part();

  const Trajectory& trajectory_;
  std::size_t piece_;
  double duration_ = 0;  ///< of the piece [s]
  PiecePhases phases_;
  int phase_ = 0;
  double tau_ = 0;  ///< start of the part in the piece [s]
  std::uint32_t last_element_ = 0;
  Part part_;
  FilterWalk filters_;
};

}  // namespace feedscope
