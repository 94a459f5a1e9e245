#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// Reason why the tool is not faster.
enum class CauseKind : std::uint8_t {
  programmed_feed,
  rapid,
  axis_velocity,
  axis_acceleration,
  axis_jerk,
  radial_acceleration,
  radial_jerk,
  blend_velocity,             ///< axis velocity on a corner blend
  blend_radial_acceleration,  ///< share R_A of an axis acceleration on a corner blend
  blend_radial_jerk,          ///< share R_J of an axis jerk on a corner blend
  blend_tangential_acceleration,
  blend_tangential_jerk,
  curvilinear_jerk,
  curvature_crossing,
  interpolation_period,
  block_time,  ///< time of the control to prepare a block
  contour_tolerance,
  lookahead_horizon,
  velocity_filter,         ///< filters of the control that spread every change of feed
  junction_deviation,      ///< corner rule of grbl
  square_corner_velocity,  ///< corner rule of Klipper
  cruise_ratio,            ///< Klipper: part of a path reserved for cruising
  kink,                    ///< corner rule of LinuxCNC: acceleration of one period
  path_velocity,           ///< the control's own limit of the speed
  path_acceleration,       ///< the control's own limit of the acceleration
  ramp_down,               ///< braking for a slower place
  exact_stop,
  dwell,
  tool_change,
  spindle_start,
  indexing,  ///< rotary axes turn while the tool is at rest
  swing,     ///< the tool turns about its tip, which X, Y and Z keep in place
};
inline constexpr std::size_t cause_kind_count = static_cast<std::size_t>(CauseKind::swing) + 1;
/// Whether X, Y and Z are at rest, so that nothing limits a feed.
constexpr bool is_pause(CauseKind kind) {
  return kind >= CauseKind::dwell;
}

/// Limiting cause, with its axis if there is one.
struct Cause {
  CauseKind kind = CauseKind::programmed_feed;
  std::int8_t axis = -1;  ///< index in cause_axes; -1 none
  bool operator==(const Cause&) const = default;
};

/// Data of a kind of cause: one row for keys, titles, legends and colours.
struct CauseInfo {
  CauseKind kind = CauseKind::programmed_feed;
  std::string_view key;
  std::string_view title;       ///< for any axis
  std::string_view axis_title;  ///< %1: the axis; empty for causes without an axis
  std::uint32_t light = 0;      ///< colour on a light background, 0xRRGGBB
  std::uint32_t dark = 0;       ///< colour on a dark one

  constexpr bool by_axis() const { return !axis_title.empty(); }
};

const CauseInfo& info_of(CauseKind kind);

/// Name of the axis; blank if none.
char axis_name(Cause cause);
/// Stable key for files: "programmed_feed", "axis_jerk_x".
std::string cause_key(Cause cause);
/// Title for display: "programmed feed", "jerk of axis X", "axis jerk".
std::string cause_title(Cause cause);
/// All possible causes, in a fixed order for tables and legends.
const std::vector<Cause>& all_causes();
/// Index in all_causes().
std::size_t cause_index(Cause cause);

}  // namespace feedscope
