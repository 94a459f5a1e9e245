#pragma once

#include <memory>

#include "core/analysis/envelope/band.h"
#include "core/analysis/envelope/pyramid.h"
#include "core/analysis/time/cause_times.h"
#include "core/analysis/time/rapid_times.h"
#include "core/base/progress.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {

/// Level of detail of a trajectory for charts: minimum and maximum in every pixel column.
///
/// A pyramid of extents over groups of motion pieces, about 37 bytes per piece, built once in linear time. A
/// column costs a logarithmic walk of the pyramid plus the pieces of the two groups cut by its borders,
/// whatever the length of the program. A cut group shorter than 1/8 of the column counts as a whole: a column
/// may include that much beyond its borders, and never less than its own content. Extremes on straight
/// elements are exact; arcs are sampled every 5 degrees, blends more densely the sharper they turn: within 2
/// % of the largest value for turns up to 150 degrees.
class MotionEnvelope {
 public:
  MotionEnvelope() = default;
  /// Throws Cancelled if `progress` is cancelled.
  explicit MotionEnvelope(std::shared_ptr<const Trajectory> trajectory, Progress* progress = nullptr);

  /// Band from one time to another [s]; empty outside the trajectory.
  MotionBand column(double from, double to) const { return column(from, to, whole_group_share); }
  /// As column(), without anything beyond its borders.
  MotionBand exact_column(double from, double to) const { return column(from, to, 0); }
  /// Band of the whole trajectory; empty for an empty trajectory.
  MotionBand overall() const { return pyramid_.overall(); }
  /// Band of everything except rapids.
  const MotionBand& cutting() const { return cutting_; }
  const CauseTimes& causes() const { return causes_; }
  const RapidTimes& rapids() const { return rapids_; }

 private:
  static constexpr double whole_group_share = 1.0 / 8;  ///< of a column

  MotionBand column(double from, double to, double whole_share) const;
  double group_duration(std::size_t group) const;
  void add_piece(MotionBand& band, std::size_t piece, double from, double to) const;
  void add_pieces(MotionBand& band, std::size_t first, std::size_t last, double from, double to) const;
  void add_part(MotionBand& band, const Part& part, const PartMotion& motion, double duration) const;

  std::shared_ptr<const Trajectory> trajectory_;
  CauseTimes causes_;
  MotionBand cutting_;
  RapidTimes rapids_;
  Pyramid<MotionBand> pyramid_;  ///< by group of pieces
};

}  // namespace feedscope
