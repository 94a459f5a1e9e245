#include "core/program/sinumerik/language/modal_words.h"

#include <cmath>

#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"

namespace feedscope::sinumerik {

void ModalWords::apply_g(double number, std::uint32_t column, std::string_view written) {
  const int g = number >= 0 && number < 1000 && number == std::floor(number) ? static_cast<int>(number) : -1;
  const Function* const function = find_g(g);
  if (function == nullptr) {
    report(Severity::error, "unknown-g", g, column, [&] {
      return Text{message(NC_("core", "{} is not a known G word"), in_quotes(written)),
                  NC_("core", "it is ignored; the control may run another path")};
    });
    return;
  }
  if (function->action == Action::work_offset) {
    parts_.coordinates.select_work_offset(g, column);
  }
  apply(*function, column);
}

void ModalWords::apply_m(double number) {
  functions_.ends |= number == 2 || number == 17 || number == 30;
  functions_.tool_change |= number == 6;
  functions_.stop |= number == 0 || number == 1;
  functions_.spindle_start |= number == 3 || number == 4;
  functions_.spindle_stop |= number == 5 || number == 19;
}

void ModalWords::apply(const Function& function, std::uint32_t column) {
  if (function.group != Group::none) {
    check_group(function, column);
  }
  const bool followed = function.name == "TRAORI" && machining_.other_axes.turns();
  if (!function.subject.empty() && !followed) {
    report(function.severity, "unread-function", kind_of(function.name), column, [&] {
      return Text{message(NC_("core", "{} ({}) is not supported"), function.name, function.subject),
                  function.effect};
    });
  }
  apply_action(function);
  parts_.other_axes.follow(function);
  if (function.group == Group::compensation) {
    functions_.compensation_column = column;
  }
  if (function.group == Group::own_block) {
    functions_.own_block = &function;
    functions_.own_column = column;
  }
}

void ModalWords::check_group(const Function& function, std::uint32_t column) {
  const Function*& present = functions_[function.group];
  if (present != nullptr && present != &function) {
    report(Severity::error, "conflicting-g", kind_of(function.name), column, [&] {
      return Text{
          message(NC_("core", "{} and {} exclude each other in one block"), present->name, function.name),
          message(NC_("core", "{} is used; remove the other"), function.name)};
    });
  }
  present = &function;
}

void ModalWords::apply_action(const Function& function) {
  switch (function.action) {
    case Action::rapid:
    case Action::line:
    case Action::arc_cw:
    case Action::arc_ccw:
    case Action::arc_through:
    case Action::arc_tangent:
    case Action::spline:
    case Action::polynomial:
    case Action::thread:
    case Action::unread_motion:
      modal_.motion = &function;
      break;
    case Action::plane_xy:
      set_plane(Plane::xy);
      break;
    case Action::plane_zx:
      set_plane(Plane::zx);
      break;
    case Action::plane_yz:
      set_plane(Plane::yz);
      break;
    case Action::inch:
    case Action::metric:
    case Action::inch_all:
    case Action::metric_all:
      set_unit(function.action);
      break;
    case Action::absolute:
    case Action::incremental:
      modal_.incremental = function.action == Action::incremental;
      break;
    case Action::feed_per_minute:
    case Action::feed_inverse_time:
    case Action::feed_per_revolution:
      parts_.feeds.set_mode(function);
      break;
    case Action::corner_arc:
    case Action::corner_meeting:
      parts_.compensation.set_corner_meeting(function.action == Action::corner_meeting);
      break;
    case Action::diameters:
    case Action::diameters_if_absolute:
    case Action::radii:
      parts_.targets.set_diameters(function.action);
      break;
    case Action::machine_axes:
      functions_.machine_axes = &function;
      break;
    case Action::exact_stop_once:
      functions_.exact_stop = true;
      break;
    case Action::path_control:
      parts_.path_modes.apply(function.name);
      break;
    case Action::spline_end:
      parts_.splines.set_end(function.name);
      break;
    default:
      break;
  }
}

void ModalWords::set_plane(Plane plane) {
  if (plane != modal_.plane) {
    parts_.targets.end_polar_angle();
  }
  modal_.plane = plane;
}

void ModalWords::set_unit(Action action) {
  modal_.inch = action == Action::inch || action == Action::inch_all;
  // G70 and G71 leave feeds in the control's basic system.
  const bool lengths_only = action == Action::inch || action == Action::metric;
  modal_.inch_feed = lengths_only ? machining_.unit.first() == LengthUnit::inch : modal_.inch;
  machining_.unit.set(modal_.inch ? LengthUnit::inch : LengthUnit::mm);
}

}  // namespace feedscope::sinumerik
