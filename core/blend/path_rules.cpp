#include "core/blend/path_rules.h"

#include <algorithm>
#include <limits>

#include "core/machine/contour_tolerance.h"

namespace feedscope {

MotionTolerance tolerance_of(const PathControl& control, const Settings& settings) {
  if (follows_program_tolerance(settings)) {
    if (control.contour_tolerance) {
      return {*control.contour_tolerance, true};
    }
    if (control.blend_distance) {
      return {*control.blend_distance, true};
    }
  }
  return {settings.number(contour_tolerance_key), false};
}

PathRules::PathRules(const Toolpath& toolpath, const Settings& settings) : toolpath_(&toolpath) {
  const bool follow_program = follows_program_tolerance(settings);
  for (const PathControl& control : toolpath.path_controls) {
    Rule& rule = rules_.emplace_back(rule_of(control));
    rule.tolerance = tolerance_of(control, settings).tolerance;
    if (follow_program && control.blend_distance) {
      rule.longest_blend = *control.blend_distance;
    }
  }
}

PathRules PathRules::exact_corners(const Toolpath& toolpath) {
  PathRules rules(toolpath);
  for (const PathControl& control : toolpath.path_controls) {
    rules.rules_.push_back(rule_of(control));
  }
  return rules;
}

PathRules::Rule PathRules::rule_of(const PathControl& control) {
  return {0, std::numeric_limits<double>::infinity(),
          control.compaction != Switch::off && control.mode != PathMode::exact_stop,
          control.compressor == Switch::on && control.mode != PathMode::exact_stop,
          control.acceleration == AccelerationMode::brisk};
}

double PathRules::corner_tolerance(std::size_t segment) const {
  return std::min(rule(segment).tolerance, rule(segment + 1).tolerance);
}

double PathRules::longest_blend(std::size_t segment) const {
  return std::min(rule(segment).longest_blend, rule(segment + 1).longest_blend);
}

bool PathRules::stops_at_joint(std::size_t segment) const {
  if (passes_joints_ || toolpath_->turn_joints.empty()) {
    return false;
  }
  const TurnJoint* joint = toolpath_->turn_joint(segment);
  return joint != nullptr && joint->stops;
}

bool PathRules::has_acceleration_jumps() const {
  return std::any_of(rules_.begin(), rules_.end(), [](const Rule& rule) { return rule.acceleration_jumps; });
}

bool PathRules::may_compact(std::size_t segment, std::size_t next) const {
  const auto control = [this](std::size_t i) { return toolpath_->segments[i].path_control; };
  return control(segment) == control(next) && rule(segment).compacts;
}

bool PathRules::may_compress(std::size_t segment, std::size_t next, bool everywhere) const {
  const auto allows = [&](std::size_t i) {
    const PathControl& control = toolpath_->path_control_of(i);
    return everywhere ? control.mode != PathMode::exact_stop : rule(i).asks_for_curves;
  };
  return allows(segment) && allows(next) && !stops_at_joint(segment);
}

}  // namespace feedscope
