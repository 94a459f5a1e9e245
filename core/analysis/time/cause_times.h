#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/time/rapid_times.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Time that each limiting cause takes in any stretch of a trajectory.
///
/// Stores the time of each cause from the start up to every 64th piece: an eighth of a byte per piece for
/// each cause that occurs. A query costs a walk over the pieces from its ends to the marks before them,
/// whatever its length.
class CauseTimes {
 public:
  CauseTimes() = default;
  explicit CauseTimes(std::shared_ptr<const Trajectory> trajectory);

  /// Time of every cause between two instants [s], in the order of all_causes(). The instants are clamped to
  /// the run; all zero unless `to` is after `from`.
  std::vector<double> between(double from, double to) const;
  /// The cause kind with the most time between each pair of neighbours in `times` [s], ascending; none where
  /// there is no time.
  std::vector<std::optional<CauseKind>> dominating(std::span<const double> times) const;
  /// As above for `count` columns, of which only these stretches count.
  std::vector<std::optional<CauseKind>> dominating(std::span<const ColumnStretch> stretches,
                                                   std::size_t count) const;
  /// Time of every cause within these stretches, in the order of between() [s].
  std::vector<double> within(std::span<const ColumnStretch> stretches) const;

 private:
  std::vector<double> until(double time) const;
  void add_piece(std::vector<double>& sums, std::size_t piece, double duration) const;

  std::shared_ptr<const Trajectory> trajectory_;
  std::vector<std::uint8_t> seen_;      ///< cause_index() of every cause that occurs
  std::vector<std::uint8_t> place_of_;  ///< index into seen_ for each of all_causes()
  std::vector<double> marks_;           ///< a row of seen_.size() for each 64 pieces: times before them [s]
};

}  // namespace feedscope
