#pragma once

#include <vector>

#include "core/machine/settings.h"
#include "core/toolpath/toolpath.h"

namespace feedscope {

/// Contour tolerance of the motions with one path control.
struct MotionTolerance {
  double tolerance = 0;     ///< [mm]; 0: no corner is blended
  bool by_program = false;  ///< else by the setting contour_tolerance_mm
};

/// Contour tolerance of the program, else its blend distance, which exceeds the distance of a blend from the
/// corner, else the setting; always the setting if program_tolerance is off.
MotionTolerance tolerance_of(const PathControl& control, const Settings& settings);

/// Rules for the corners of a path: the path control of the program, and the settings of the run where it has
/// none. Exact stops of the program are not included: they are JunctionKind::stop for every model.
class PathRules {
 public:
  /// Reads contour_tolerance_mm, and program_tolerance, which enables the program's own tolerances and blend
  /// distances (default: on). `toolpath` outlives this.
  PathRules(const Toolpath& toolpath, const Settings& settings);
  /// Rules with an exact stop at every corner, whatever the program requests.
  static PathRules exact_corners(const Toolpath& toolpath);

  /// Contour tolerance [mm]; 0: no corner is blended.
  double tolerance(std::size_t segment) const { return rule(segment).tolerance; }
  /// Tolerance of the corner at the end of `segment`: the smaller one of the two segments.
  double corner_tolerance(std::size_t segment) const;
  /// Largest distance from that corner at which its blend may begin [mm]; infinite without a limit.
  double longest_blend(std::size_t segment) const;
  /// Whether the acceleration along the path may jump on the segment: for BRISK, whatever program_tolerance
  /// is. Not for SOFT, nor for DRIVE, whose decreasing acceleration is in the machine data of the control.
  bool acceleration_jumps(std::size_t segment) const { return rule(segment).acceleration_jumps; }
  /// Whether it may jump on any segment.
  bool has_acceleration_jumps() const;
  /// Whether the tip stops at the end of the segment because rotary axes cannot pass it in motion
  /// (TurnJoint::stops).
  bool stops_at_joint(std::size_t segment) const;
  /// For a control that does not stop at such places.
  void pass_joints() { passes_joints_ = true; }
  /// Whether the segment may be merged with `next`.
  bool may_compact(std::size_t segment, std::size_t next) const;
  /// Whether a compressor may smooth the junction between them: if the program requests one, or with
  /// `everywhere` unless it requests exact stops.
  bool may_compress(std::size_t segment, std::size_t next, bool everywhere) const;

 private:
  struct Rule {
    double tolerance = 0;
    double longest_blend = 0;
    bool compacts = true;
    bool asks_for_curves = false;
    bool acceleration_jumps = false;
  };

  explicit PathRules(const Toolpath& toolpath) : toolpath_(&toolpath) {}
  static Rule rule_of(const PathControl& control);
  const Rule& rule(std::size_t segment) const { return rules_[toolpath_->segments[segment].path_control]; }

  const Toolpath* toolpath_;
  bool passes_joints_ = false;
  std::vector<Rule> rules_;  ///< in the order of Toolpath::path_controls
};

}  // namespace feedscope
