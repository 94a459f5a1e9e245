#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/models/linuxcnc/linuxcnc_canon.h"
#include "core/models/linuxcnc/linuxcnc_planner.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

/// Sends the canon's messages to the planner, one message a period at most, and lays the motion that it runs.
class LinuxCncRun {
 public:
  LinuxCncRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
              const LinuxCncSettings& settings);

  Trajectory run(Progress* progress);

 private:
  /// Part of one segment that runs alone.
  struct Stretch {
    bool open = false;
    LinuxCncSegment segment;
    double from = 0;  ///< progress [mm]
    double to = 0;
    std::vector<LinuxCncStep> steps;
  };

  bool take_message();
  bool takes_moves() const;
  void wait_for(const LinuxCncMessage& dwell);
  void lay(const std::vector<LinuxCncStep>& steps);
  void extend(const LinuxCncStep& step);
  void close();
  void lay_overlap(const LinuxCncStep& first, const LinuxCncStep& second);
  void stand(double time);
  void lay_standing(bool counts);
  void stand_on_last(double time);
  void lay_pause(std::uint32_t block, double time);
  void round(const LinuxCncJoint& joint, std::uint32_t first);
  std::uint32_t lay_course();
  bool is_circle_from(double from) const;
  std::uint32_t add_arc(double from, double to);
  void lay_step(const LinuxCncStep& step, std::uint32_t element, double length);
  std::uint32_t add_line(const Vec3& to, const LinuxCncSegment& of);

  const Toolpath& toolpath_;
  LinuxCncSettings settings_;
  std::shared_ptr<ExecutedPath> executed_;
  TrajectoryBuilder builder_;
  LinuxCncPlanner planner_;
  LinuxCncCanon canon_;
  std::optional<LinuxCncMessage> message_;  ///< that waits to be taken
  Stretch stretch_;
  Vec3 place_ = Vec3::Zero();  ///< end of the laid motion [mm]
  /// Time without motion, of a pause or between moves.
  struct Standing {
    std::optional<std::uint32_t> pause;  ///< block of it
    double time = 0;                     ///< [s]
  };
  std::vector<Standing> standing_;  ///< since the last motion
  double last_of_period_ = 0;       ///< after the last motion, to the end of its period [s]
};

}  // namespace feedscope
