#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/models/klipper/klipper_moves.h"
#include "core/program/controls/klipper_limits.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Lays the motion of Klipper over a toolpath, whose arcs become chords.
class KlipperRun {
 public:
  KlipperRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
             const KlipperSettings& settings);

  Trajectory run(Progress* progress);

 private:
  void queue_line(std::size_t block, const Vec3& start, const Vec3& end);
  void queue_arc(std::size_t block);
  void flush();
  void lay(const KlipperMove& move, std::uint32_t element, Cause ahead);

  const Toolpath& toolpath_;
  KlipperSettings settings_;
  KlipperLimits limits_;
  std::shared_ptr<ExecutedPath> executed_;  ///< null: the programmed path is run unchanged
  TrajectoryBuilder builder_;
  KlipperMoves moves_;
  std::vector<std::uint32_t> elements_;  ///< of the moves
};

}  // namespace feedscope
