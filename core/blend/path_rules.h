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

/// The program's contour tolerance, else its blend distance, which a blend strays from the corner by less
/// than, else the setting; the setting always where program_tolerance is off.
MotionTolerance tolerance_of(const PathControl& control, const Settings& settings);

/// What rules the corners of a path: the path control that the program itself asks for, and the settings of
/// the run where it says nothing. Exact stops that the program asks for are not here: they are
/// JunctionKind::stop for every model.
class PathRules {
 public:
  /// Reads contour_tolerance_mm, and program_tolerance: whether the program's own tolerances and blend
  /// distances count, which they do if nothing is set. `toolpath` outlives it.
  PathRules(const Toolpath& toolpath, const Settings& settings);
  /// Every corner is an exact stop, whatever the program says.
  static PathRules exact_corners(const Toolpath& toolpath);

  /// Contour tolerance [mm]; 0: no corner is blended.
  double tolerance(std::size_t segment) const { return rule(segment).tolerance; }
  /// Of the corner where `segment` ends: the smaller one of the two that meet there.
  double corner_tolerance(std::size_t segment) const;
  /// Distance from that corner at which its blend may begin at the earliest [mm]; infinite if nobody says.
  double longest_blend(std::size_t segment) const;
  /// Whether the acceleration along the path may jump on the segment: BRISK, whatever program_tolerance says.
  /// SOFT, and DRIVE whose falling acceleration is in the machine data of the control, may not.
  bool acceleration_jumps(std::size_t segment) const { return rule(segment).acceleration_jumps; }
  /// On any segment at all.
  bool has_acceleration_jumps() const;
  /// Whether the tip stops where the segment ends, since rotary axes let it pass no sooner
  /// (TurnJoint::stops).
  bool stops_at_joint(std::size_t segment) const;
  /// For a control that passes all such places.
  void pass_joints() { passes_joints_ = true; }
  /// Whether the segment may be merged with `next`.
  bool may_compact(std::size_t segment, std::size_t next) const;
  /// Whether a compressor may smooth the junction between them: where the program asks for one, or,
  /// `everywhere`, wherever it does not ask for exact stops.
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
  std::vector<Rule> rules_;  ///< by Toolpath::path_controls
};

}  // namespace feedscope
