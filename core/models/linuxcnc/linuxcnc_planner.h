#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/models/linuxcnc/linuxcnc_blend.h"

namespace feedscope {

/// Motion of one servo period, or a part of it.
struct LinuxCncStep {
  LinuxCncSegment* segment = nullptr;  ///< valid until the next period
  double from = 0;                     ///< progress before [mm]
  double to = 0;                       ///< and after [mm]
  double before = 0;                   ///< speed before [mm/s]
  double after = 0;                    ///< and after [mm/s]
  double time = 0;                     ///< [s]
  bool overlaps = false;               ///< at the same time as the previous step
  Cause cause;                         ///< of its speed
  Cause ahead;                         ///< cause of slowing down
};

/// The trapezoidal planner of LinuxCNC: queue of segments, their joints, and one servo period after the other
/// (README.md).
class LinuxCncPlanner {
 public:
  explicit LinuxCncPlanner(const LinuxCncSettings& settings) : settings_(settings) {}

  bool empty() const { return queue_.empty(); }
  std::size_t size() const { return queue_.size(); }
  /// Appends a segment with course, block, rapid, requested, largest, acceleration, tolerance and end set;
  /// skips one of length zero.
  void add(LinuxCncSegment segment);
  /// Runs one period and returns its motion. With `nothing_comes`, if nothing is added before the first
  /// segment ends, includes all further equal periods in one step.
  const std::vector<LinuxCncStep>& run_period(bool nothing_comes = false);

 private:
  void join(LinuxCncSegment& t);
  bool join_tangentially(LinuxCncSegment& p, LinuxCncSegment& t) const;
  /// Position of the blend arc of a joint.
  enum class Blended : std::uint8_t { no, behind_it, in_place_of_it };
  Blended join_by_blend(LinuxCncSegment& t);
  void optimise();
  double final_speed(const LinuxCncSegment& t, const LinuxCncSegment* n) const;
  Cause final_cause(const LinuxCncSegment& t, const LinuxCncSegment* n) const;
  void give_causes(LinuxCncStep& step, const LinuxCncSegment* n) const;
  void activate(LinuxCncSegment& t);
  void update(LinuxCncSegment& t, const LinuxCncSegment* n, double time, bool overlaps);
  void go_on(LinuxCncSegment& t, const LinuxCncSegment* n);
  bool check_end(LinuxCncSegment& t, const LinuxCncSegment* n) const;
  void run_split(LinuxCncSegment& t, LinuxCncSegment* n, LinuxCncSegment* after);
  bool only_in_overlap() const { return settings_.master; }

  LinuxCncSettings settings_;
  std::deque<LinuxCncSegment> queue_;
  std::vector<LinuxCncStep> steps_;
  bool first_leaves_ = false;
  LinuxCncSegment gone_;  ///< the last one that left, for its steps
};

}  // namespace feedscope
