#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/diagnostic.h"

namespace feedscope::iso {

/// Effect of a G word on the reader.
enum class GAction : std::uint8_t {
  accept,  ///< leaves the programmed geometry unchanged
  rapid,
  line,
  arc_cw,
  arc_ccw,
  dwell,
  plane_xy,
  plane_zx,
  plane_yz,
  inch,
  metric,
  absolute,
  incremental,
  absolute_centers,
  incremental_centers,
  feed_per_minute,
  other_feed,     ///< changes the meaning of F
  path_control,   ///< exact stop, continuous path, look-ahead
  cancel_macro,   ///< G67
  function,       ///< IsoReader::run_function(); the block moves as programmed
  axis_function,  ///< the same; the block's coordinates belong to it, nothing else moves
  cycle,
  spline,         ///< G5 to G5.3
  cancel_cycle,   ///< G80
  report,         ///< not read; the block moves as programmed
  own_words,      ///< not read; the block's coordinates belong to it, nothing moves
  unread_motion,  ///< not read; nothing moves until the next G0 to G3
};

/// G words of one group exclude each other in a block.
enum class GGroup : std::uint8_t {
  none,
  motion,
  plane,
  distance,
  center_distance,
  feed_mode,
  units,
  radius,
  tool_length,
  offset,
  path_mode,
};

inline constexpr std::size_t g_group_count = static_cast<std::size_t>(GGroup::path_mode) + 1;

struct GCode {
  int number = 0;  ///< ten times the G number: 901 is G90.1
  GGroup group = GGroup::none;
  GAction action = GAction::accept;
  Severity severity = Severity::info;  ///< of the report, where there is one
  Translatable subject;                ///< its meaning; empty: nothing to report
  Translatable effect;                 ///< effect on the path shown
  bool needs_axes = false;             ///< harmless in a block without X, Y and Z
};

/// The code with ten times its G number, or nullptr for an unknown one.
const GCode* find_g_code(int number);

}  // namespace feedscope::iso
