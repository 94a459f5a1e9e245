#include "core/program/path_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {

namespace {

void add_switch(std::vector<std::string>& parts, std::string_view name, Switch value) {
  if (value != Switch::machine) {
    parts.push_back(fmt::format("{} {}", name, value == Switch::on ? "on" : "off"));
  }
}

}  // namespace

bool is_too_small(double tolerance) {
  return tolerance > 0 && tolerance < least_tolerance;
}

DiagnosticLog::Text too_small_text(std::string_view words) {
  const std::string least = plain_text(least_tolerance);
  return {fmt::format("{} is below {} mm", words, least),
          fmt::format("{} mm is used, the smallest that is simulated", least)};
}

const PathControl* find_own_tolerance(std::span<const PathControl> controls) {
  const auto own = std::find_if(controls.begin(), controls.end(), [](const PathControl& control) {
    return control.contour_tolerance || control.blend_distance;
  });
  return own == controls.end() ? nullptr : &*own;
}

std::string_view to_string(ExactStopWindow window) {
  switch (window) {
    case ExactStopWindow::machine:
      break;
    case ExactStopWindow::fine:
      return "fine";
    case ExactStopWindow::coarse:
      return "coarse";
    case ExactStopWindow::interpolation_end:
      return "interpolation end";
  }
  return {};
}

std::string describe(const PathControl& control) {
  std::vector<std::string> parts;
  if (control.mode == PathMode::exact_stop) {
    const std::string_view window = to_string(control.exact_stop_window);
    parts.push_back(window.empty() ? "exact stops" : fmt::format("exact stops ({})", window));
  } else if (control.mode == PathMode::continuous) {
    parts.emplace_back("continuous");
  }
  if (control.contour_tolerance) {
    parts.push_back(fmt::format("contour tolerance {} mm", *control.contour_tolerance));
  }
  if (control.blend_distance) {
    parts.push_back(fmt::format("blends from {} mm before the corner", *control.blend_distance));
  }
  if (control.orientation_tolerance) {
    parts.push_back(
        fmt::format("orientation tolerance {:.6g} deg", units::to_deg(*control.orientation_tolerance)));
  }
  add_switch(parts, "compaction", control.compaction);
  if (control.compressor != control.compaction) {
    add_switch(parts, "smooth curves", control.compressor);
  }
  if (control.compaction_tolerance) {
    parts.push_back(fmt::format("compaction tolerance {} mm", *control.compaction_tolerance));
  }
  switch (control.acceleration) {
    case AccelerationMode::machine:
      break;
    case AccelerationMode::soft:
      parts.emplace_back("jerk limited");
      break;
    case AccelerationMode::brisk:
      parts.emplace_back("acceleration in steps");
      break;
    case AccelerationMode::drive:
      parts.emplace_back("acceleration falling with speed");
      break;
  }
  add_switch(parts, "feed forward", control.feed_forward);
  add_switch(parts, "look-ahead", control.look_ahead);
  return parts.empty() ? "as the machine" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace feedscope
