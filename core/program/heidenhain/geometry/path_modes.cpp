#include "core/program/heidenhain/geometry/path_modes.h"

#include "core/machine/contour_tolerance.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

void PathModes::set_tolerance(std::optional<double> tolerance, std::optional<double> orientation_tolerance,
                              std::uint32_t column) {
  if (tolerance && *tolerance < 0) {
    throw ReadFault{"tolerance", column, message(NC_("core", "the tolerance T{} is below zero"), *tolerance),
                    NC_("core", "the tolerance in force stays")};
  }
  if (tolerance && is_too_small(*tolerance)) {
    report(Severity::warning, "tolerance", 1, column,
           [&] { return too_small_text(message(NC_("core", "the tolerance T{}"), plain_text(*tolerance))); });
    tolerance = least_tolerance;
  }
  end_contour(column);
  PathControl control = path().path_control();
  // T0 switches the tolerance of the program off, and the machine's own applies (TNC 640 cycles manual, cycle
  // 32).
  tolerance = tolerance.value_or(0) > 0 ? tolerance : std::nullopt;
  control.mode = tolerance ? PathMode::continuous : PathMode::machine;
  control.contour_tolerance = tolerance;
  control.compressor = tolerance ? Switch::on : Switch::machine;
  control.orientation_tolerance = orientation_tolerance;
  path().set_path_control(control);
}

void PathModes::set_orientation_tolerance(double tolerance, std::uint32_t column) {
  set_tolerance(path().path_control().contour_tolerance, tolerance, column);
}

void PathModes::use_look_ahead(std::uint32_t column) {
  end_contour(column);
  PathControl control = path().path_control();
  control.look_ahead = Switch::on;
  path().set_path_control(control);
}

}  // namespace feedscope::heidenhain
