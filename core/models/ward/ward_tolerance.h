#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/models/ward/block_distances.h"

namespace feedscope {

/// Keeps the contour tolerance of a stretch: measures the distance of its pulses' path from the programmed
/// points, and lowers corner speeds, and feeds on arcs, where it is too large. Uses several threads, with the
/// same result for any number of them.
class WardTolerance {
 public:
  /// All outlive this. `progress` may be null; cancelling it makes this throw Cancelled.
  WardTolerance(WardPulses& pulses, const PathRules& rules, const Progress* progress);

  /// Repeats until every corner and every arc keeps the tolerance; the pulses must be laid for their speeds.
  void enforce(ProgressSteps& steps);
  /// Only measures.
  void measure();
  /// Largest distance at the last check of every block [mm].
  double largest() const;

 private:
  /// Measures the blocks whose state in check_ is `wanted`.
  void look(char wanted);
  /// Lowers the blocks that are due for a check and too far from the path; unless `every`, only those that
  /// the previous pass lowered. True if any was lowered.
  bool lower_blocks(int pass, bool every, ProgressSteps& steps);
  bool lower_corner(std::size_t block, double distance, int pass);
  bool lower_arc(std::size_t block, double distance, int pass);
  void mark_neighbours();

  WardPulses& pulses_;
  PulseTrain& train_;
  const PathRules& rules_;
  const Progress* progress_;
  std::vector<BlockDistance> distances_;  ///< by block, at its last check
  std::vector<char> check_;               ///< by block: due for a check, or lowered at the last one
  std::vector<char> slowed_;              ///< arcs whose feed this pass has lowered
};

}  // namespace feedscope
