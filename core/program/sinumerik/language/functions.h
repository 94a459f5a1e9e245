#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/diagnostic.h"

namespace feedscope::sinumerik {

/// Effect of a G word or a name without value ("CIP", "SOFT") on the reader.
enum class Action : std::uint8_t {
  accept,         ///< does not change the path; values, indices and arguments after it are skipped
  report,         ///< the same, and reported
  own_words,      ///< reported; the block's coordinates belong to it, nothing moves
  unread_motion,  ///< reported; nothing moves until the next supported motion word
  rapid,
  line,
  arc_cw,
  arc_ccw,
  arc_through,  ///< CIP
  arc_tangent,  ///< CT
  spline,       ///< ASPLINE, BSPLINE, CSPLINE
  polynomial,
  thread,  ///< G33, G331, G332: a line whose feed is lead times spindle speed
  dwell,
  plane_xy,
  plane_zx,
  plane_yz,
  inch,        ///< lengths
  metric,      ///< lengths
  inch_all,    ///< lengths and feeds
  metric_all,  ///< lengths and feeds
  absolute,
  incremental,
  feed_per_minute,
  feed_inverse_time,
  feed_per_revolution,
  work_offset,  ///< a warning once it changes after a motion
  compensation_left,
  compensation_right,
  compensation_off,
  corner_arc,             ///< G450
  corner_meeting,         ///< G451
  diameters,              ///< DIAMON: X is a diameter
  diameters_if_absolute,  ///< DIAM90
  radii,                  ///< DIAMOF
  machine_axes,           ///< SUPA, G53, G153, G74, G75: positions that depend on the machine
  shift,                  ///< TRANS
  shift_more,             ///< ATRANS
  turn,
  turn_more,
  scale,
  scale_more,
  mirror,
  mirror_more,
  coarse_shift,  ///< G58
  fine_shift,    ///< G59
  pole_from_position,
  pole_from_zero,
  pole_from_pole,
  exact_stop_once,  ///< G9
  path_control,     ///< selected by name in PathWords
  spline_end,       ///< selected by name as a SplineEnd
};

/// Functions of one group exclude each other in a block.
enum class Group : std::uint8_t {
  none,
  motion,
  plane,
  distance,
  units,
  feed_mode,
  offset,
  path_mode,
  exact_stop_window,
  compaction,
  acceleration,
  feed_forward,
  compensation,
  corner,
  diameter,
  own_block,  ///< frames, dwell, pole: the coordinates belong to it
};

inline constexpr std::size_t group_count = static_cast<std::size_t>(Group::own_block) + 1;

struct Function {
  std::string_view name;  ///< upper case
  Group group = Group::none;
  Action action = Action::accept;
  Severity severity = Severity::info;  ///< of the report, where there is one
  Translatable subject = {};           ///< its meaning; empty: nothing to report
  Translatable effect = {};            ///< effect on the path shown
};

/// nullptr for an unknown one. G numbers without leading zeros: "G1", "G641".
const Function* find_function(std::string_view name);
const Function* find_g(int number);

}  // namespace feedscope::sinumerik
