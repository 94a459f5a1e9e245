#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Contour tolerances in force on the feed motions of a run, from whatever source.
struct ToleranceInForce {
  enum class Setter { setting, program, both };

  double min = 0;  ///< [mm]
  double max = 0;  ///< [mm]
  Setter set_by = Setter::setting;

  bool is_range() const { return min != max; }
  bool operator==(const ToleranceInForce&) const = default;
};

/// Texts "setting", "program", "program and setting"; the setting comes from the machine file or the request.
std::string_view to_string(ToleranceInForce::Setter setter);

/// Whether the model follows a contour tolerance with these settings; `cam`, `tapie` and `optimal` on their
/// paths do not, whatever the program requests.
bool follows_tolerance(const Setup& setup);

/// `feed_controls`: LoadedProgram::feed_controls; empty: the setting. None if the model follows no tolerance.
std::optional<ToleranceInForce> tolerance_in_force(std::span<const PathControl> feed_controls,
                                                   const Setup& setup);

/// Text: "0.1 mm", "0.02 mm (program)", "0.01 ... 0.05 mm (program and setting)"; "none" without one.
std::string describe(const std::optional<ToleranceInForce>& tolerance);
/// The same for a table cell, without unit and source; "-" without one.
std::string range_text(const std::optional<ToleranceInForce>& tolerance);

}  // namespace feedscope
