#include "core/blend/path_rules.h"

#include <algorithm>
#include <limits>

namespace feedscope {

PathRules::PathRules(const Toolpath& toolpath, const Settings& settings)
    : PathRules(toolpath, settings.number("contour_tolerance_mm"),
                !settings.has("program_tolerance") || settings.text("program_tolerance") == "on") {}

PathRules PathRules::exact_corners(const Toolpath& toolpath) {
  return {toolpath, 0, false};
}

PathRules::PathRules(const Toolpath& toolpath, double tolerance, bool follow_program) : toolpath_(&toolpath) {
  for (const PathControl& control : toolpath.path_controls) {
    Rule rule{tolerance, std::numeric_limits<double>::infinity(),
              control.compaction != Switch::off && control.mode != PathMode::exact_stop,
              control.acceleration == AccelerationMode::brisk};
    if (follow_program && control.blend_distance) {
      // A blend strays from the corner by less than the distance at which it begins.
      rule.tolerance = rule.longest_blend = *control.blend_distance;
    }
    if (follow_program && control.contour_tolerance) {
      rule.tolerance = *control.contour_tolerance;
    }
    rules_.push_back(rule);
  }
}

double PathRules::corner_tolerance(std::size_t segment) const {
  return std::min(rule(segment).tolerance, rule(segment + 1).tolerance);
}

double PathRules::longest_blend(std::size_t segment) const {
  return std::min(rule(segment).longest_blend, rule(segment + 1).longest_blend);
}

bool PathRules::has_acceleration_jumps() const {
  return std::any_of(rules_.begin(), rules_.end(), [](const Rule& rule) { return rule.acceleration_jumps; });
}

bool PathRules::may_compact(std::size_t segment, std::size_t next) const {
  const auto control = [this](std::size_t i) { return toolpath_->segments[i].path_control; };
  return control(segment) == control(next) && rule(segment).compacts;
}

}  // namespace feedscope
