#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/analysis/run.h"

namespace feedscope {

/// The contour tolerances that hold on the feed motions of a run, whoever sets them.
struct ToleranceInForce {
  enum class Setter { setting, program, both };

  double min = 0;  ///< [mm]
  double max = 0;  ///< [mm]
  Setter set_by = Setter::setting;

  bool is_range() const { return min != max; }
  bool operator==(const ToleranceInForce&) const = default;
};

/// "setting", "program", "program and setting": the setting is that of the machine file or what was asked
/// for.
std::string_view to_string(ToleranceInForce::Setter setter);

/// Whether the model follows a contour tolerance with these settings; `cam`, `tapie` and `optimal` on their
/// paths do not, whatever the program asks for.
bool follows_tolerance(const Setup& setup);

/// `feed_controls`: LoadedProgram::feed_controls; empty: the setting. None where the model follows none.
std::optional<ToleranceInForce> tolerance_in_force(std::span<const PathControl> feed_controls,
                                                   const Setup& setup);

/// "0.1 mm", "0.02 mm (program)", "0.01 ... 0.05 mm (program and setting)"; "none" without one.
std::string describe(const std::optional<ToleranceInForce>& tolerance);
/// The same without unit and setter, "-" without one: a cell of a table.
std::string range_text(const std::optional<ToleranceInForce>& tolerance);

}  // namespace feedscope
