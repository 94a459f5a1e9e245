#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/models/grbl/grbl_steps.h"
#include "core/program/controls/grbl_arc.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Feeds a toolpath to a grbl that never has to wait for it, and lays the motion of its step generator
/// (README.md, "What happens when").
class GrblRun {
 public:
  GrblRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine, const GrblSettings& settings);

  Trajectory run(Progress* progress);

 private:
  void feed_line(const Segment& segment);
  void feed_arc(const Segment& segment, const Arc& arc);
  void queue_line(const std::array<float, 3>& target, const Segment& segment);
  void run_out();
  void prepare();
  /// Part of a block that becomes one piece.
  struct Ramp {
    double before = 0;  ///< speed [mm/s]
    double after = 0;   ///< speed [mm/s]
    double way = 0;     ///< [mm]
    double time = 0;    ///< [s]
    GrblPhase phase = GrblPhase::cruises;
    Cause cause, ahead;
  };

  void lay(const GrblBlock& block, const GrblSegment& segment);
  Ramp ramp_of(const GrblSpan& span) const;
  void collect(const Ramp& ramp);
  void lay_collected();
  void add(const Ramp& ramp);
  void name_causes();
  Cause level_cause(const GrblBlock& block) const;
  void pause(const Segment& segment);
  Vec3 place_of(const GrblPlace& place) const;

  const Toolpath& toolpath_;
  Progress* progress_ = nullptr;
  GrblSettings settings_;
  std::shared_ptr<ExecutedPath> executed_;
  TrajectoryBuilder builder_;
  GrblPlanner planner_;
  GrblSteps steps_;
  std::uint32_t block_ = 0;      ///< being fed
  std::size_t ready_ = 0;        ///< segments prepared but not yet run
  bool running_ = false;         ///< the step generator runs
  bool draining_ = false;        ///< all queued motion is to end
  bool moved_ = false;           ///< since all motion last ended
  std::size_t last_motion_ = 0;  ///< of the toolpath
  std::uint32_t element_ = 0;    ///< of the current block
  std::uint32_t begun_ = 0;      ///< segments of the executed path that are laid
  double laid_ = 0;              ///< of the current block [mm]
  double scale_ = 1;             ///< length of its element over that of the block
  double acceleration_ = 0;      ///< of the current block [mm/s2]
  std::vector<Ramp> ramps_;      ///< of the current block, with planned times
  Cause up_, level_, ahead_;     ///< of the current block
};

}  // namespace feedscope
