#include "core/program/path_control.h"

#include <algorithm>
#include <vector>

#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {

namespace {

Translatable window_text(ExactStopWindow window) {
  switch (window) {
    case ExactStopWindow::machine:
      break;
    case ExactStopWindow::fine:
      return NC_("core", "fine");
    case ExactStopWindow::coarse:
      return NC_("core", "coarse");
    case ExactStopWindow::interpolation_end:
      return NC_("core", "interpolation end");
  }
  return {};
}

void add_switch(std::vector<Message>& parts, Switch value, Translatable on, Translatable off) {
  if (value != Switch::machine) {
    parts.emplace_back(value == Switch::on ? on : off);
  }
}

}  // namespace

bool is_too_small(double tolerance) {
  return tolerance > 0 && tolerance < least_tolerance;
}

DiagnosticLog::Text too_small_text(const Message& words) {
  const Message least = Message::number(plain_text(least_tolerance));
  return {message(NC_("core", "{} is below {} mm"), words, least),
          message(NC_("core", "{} mm is used, the smallest that is simulated"), least)};
}

const PathControl* find_own_tolerance(std::span<const PathControl> controls) {
  const auto own = std::find_if(controls.begin(), controls.end(), [](const PathControl& control) {
    return control.contour_tolerance || control.blend_distance;
  });
  return own == controls.end() ? nullptr : &*own;
}

std::string_view to_string(ExactStopWindow window) {
  return window_text(window).english;
}

Message describe(const PathControl& control) {
  std::vector<Message> parts;
  if (control.mode == PathMode::exact_stop) {
    const bool any = control.exact_stop_window == ExactStopWindow::machine;
    parts.push_back(any ? NC_("core", "exact stops")
                        : message(NC_("core", "exact stops ({})"), window_text(control.exact_stop_window)));
  } else if (control.mode == PathMode::continuous) {
    parts.emplace_back(NC_("core", "continuous"));
  }
  if (control.contour_tolerance) {
    parts.push_back(message(NC_("core", "contour tolerance {} mm"), *control.contour_tolerance));
  }
  if (control.blend_distance) {
    parts.push_back(message(NC_("core", "blends from {} mm before the corner"), *control.blend_distance));
  }
  if (control.orientation_tolerance) {
    parts.push_back(message(NC_("core", "orientation tolerance {:.6g} deg"),
                            units::to_deg(*control.orientation_tolerance)));
  }
  add_switch(parts, control.compaction, NC_("core", "compaction on"), NC_("core", "compaction off"));
  if (control.compressor != control.compaction) {
    add_switch(parts, control.compressor, NC_("core", "smooth curves on"), NC_("core", "smooth curves off"));
  }
  if (control.compaction_tolerance) {
    parts.push_back(message(NC_("core", "compaction tolerance {} mm"), *control.compaction_tolerance));
  }
  switch (control.acceleration) {
    case AccelerationMode::machine:
      break;
    case AccelerationMode::soft:
      parts.emplace_back(NC_("core", "jerk limited"));
      break;
    case AccelerationMode::brisk:
      parts.emplace_back(NC_("core", "acceleration in steps"));
      break;
    case AccelerationMode::drive:
      parts.emplace_back(NC_("core", "acceleration falling with speed"));
      break;
  }
  add_switch(parts, control.feed_forward, NC_("core", "feed forward on"), NC_("core", "feed forward off"));
  add_switch(parts, control.look_ahead, NC_("core", "look-ahead on"), NC_("core", "look-ahead off"));
  return parts.empty() ? NC_("core", "as the machine") : enumerated(parts);
}

}  // namespace feedscope
