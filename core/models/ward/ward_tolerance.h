#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/models/ward/block_distances.h"

namespace feedscope {

/// Keeps the contour tolerance of a stretch: looks how far the path that its pulses make is from the
/// programmed points, and lowers corner speeds, and feeds on arcs, where it is too far. On several threads,
/// with the same result on any number of them.
class WardTolerance {
 public:
  /// All outlive this. `progress` may be null; cancelling it ends what this does, with Cancelled.
  WardTolerance(WardPulses& pulses, const PathRules& rules, const Progress* progress);

  /// Until every corner and every arc keeps the tolerance; the pulses have been laid for the speeds they
  /// have.
  void enforce(ProgressSteps& steps);
  /// Looks only.
  void measure();
  /// The largest distance when every block was looked at last [mm].
  double largest() const;

 private:
  /// Distances of the blocks of which check_ says what is `wanted`.
  void look(char wanted);
  /// Lowers those that are due for a look and too far from the path; unless `every`, only those that the pass
  /// before lowered. True if any was.
  bool lower_blocks(int pass, bool every, ProgressSteps& steps);
  bool lower_corner(std::size_t block, double distance, int pass);
  bool lower_arc(std::size_t block, double distance, int pass);
  void mark_neighbours();

  WardPulses& pulses_;
  PulseTrain& train_;
  const PathRules& rules_;
  const Progress* progress_;
  std::vector<BlockDistance> distances_;  ///< a block, when it was last looked at
  std::vector<char> check_;               ///< a block: due for a look, or lowered at the last one
  std::vector<char> slowed_;              ///< arcs whose feed this pass has lowered
};

}  // namespace feedscope
