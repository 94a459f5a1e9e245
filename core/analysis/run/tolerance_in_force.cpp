#include "core/analysis/run/tolerance_in_force.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/blend/path_rules.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {

std::string_view to_string(ToleranceInForce::Setter setter) {
  switch (setter) {
    case ToleranceInForce::Setter::program:
      return "program";
    case ToleranceInForce::Setter::both:
      return "program and setting";
    default:
      return "setting";
  }
}

bool follows_tolerance(const Setup& setup) {
  if (!contour_tolerance(setup)) {
    return false;
  }
  // With a tolerance of 0 a model guarantees exact corners, but the program's own tolerance may override
  // that.
  constexpr double any = 1;  // [mm]
  Settings settings = setup.settings;
  settings.set(contour_tolerance_key, any);
  return setup.model->guarantees(settings).contour > 0;
}

std::optional<ToleranceInForce> tolerance_in_force(std::span<const PathControl> feed_controls,
                                                   const Setup& setup) {
  if (!follows_tolerance(setup)) {
    return std::nullopt;
  }
  const PathControl machine;
  const std::span<const PathControl> controls =
      feed_controls.empty() ? std::span<const PathControl>(&machine, 1) : feed_controls;
  std::optional<ToleranceInForce> found;
  for (const PathControl& control : controls) {
    const MotionTolerance one = tolerance_of(control, setup.settings);
    const auto setter =
        one.by_program ? ToleranceInForce::Setter::program : ToleranceInForce::Setter::setting;
    if (!found) {
      found = {one.tolerance, one.tolerance, setter};
      continue;
    }
    found->min = std::min(found->min, one.tolerance);
    found->max = std::max(found->max, one.tolerance);
    found->set_by = found->set_by == setter ? setter : ToleranceInForce::Setter::both;
  }
  return found;
}

std::string range_text(const std::optional<ToleranceInForce>& tolerance) {
  if (!tolerance) {
    return "-";
  }
  return tolerance->is_range() ? fmt::format("{} ... {}", tolerance->min, tolerance->max)
                               : fmt::format("{}", tolerance->max);
}

std::string describe(const std::optional<ToleranceInForce>& tolerance) {
  if (!tolerance) {
    return "none";
  }
  const std::string text = range_text(tolerance) + " mm";
  return tolerance->set_by == ToleranceInForce::Setter::setting
             ? text
             : fmt::format("{} ({})", text, to_string(tolerance->set_by));
}

}  // namespace feedscope
