#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/models/linuxcnc/linuxcnc_canon.h"
#include "core/models/linuxcnc/linuxcnc_planner.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Sends what the canon says to the planner, one message a period at most, and lays what it runs.
class LinuxCncRun {
 public:
  LinuxCncRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
              const LinuxCncSettings& settings);

  Trajectory run(Progress* progress);

 private:
  /// A part of one segment that is run alone.
  struct Stretch {
    bool open = false;
    LinuxCncSegment segment;
    double from = 0;  ///< progress [mm]
    double to = 0;
    std::vector<LinuxCncStep> steps;
  };

  bool take_message();
  void lay(const std::vector<LinuxCncStep>& steps);
  void extend(const LinuxCncStep& step);
  void close();
  void lay_overlap(const LinuxCncStep& first, const LinuxCncStep& second);
  void lay_pause(std::uint32_t block);
  void stand(double time);
  void lay_standing(double time);
  Cause cause_of(const LinuxCncStep& step, const LinuxCncSegment& segment) const;
  std::uint32_t add_line(const Vec3& to, const LinuxCncSegment& of);

  const Toolpath& toolpath_;
  LinuxCncSettings settings_;
  std::shared_ptr<ExecutedPath> executed_;
  TrajectoryBuilder builder_;
  LinuxCncPlanner planner_;
  std::vector<LinuxCncMessage> messages_;
  std::size_t next_ = 0;
  double dwell_left_ = -1;  ///< of the message under way [s]; < 0: none
  Stretch stretch_;
  Vec3 place_ = Vec3::Zero();  ///< at the end of what is laid [mm]
  double standing_ = 0;        ///< since the last motion [s]
  double last_of_period_ = 0;  ///< after the last motion, to the end of its period [s]
};

}  // namespace feedscope
