#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// Why the tool is not faster here.
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
  block_time,  ///< that the control takes to prepare a block
  contour_tolerance,
  lookahead_horizon,
  velocity_filter,         ///< filters of the control that spread every change of feed
  junction_deviation,      ///< corner rule of grbl
  square_corner_velocity,  ///< corner rule of Klipper
  cruise_ratio,            ///< Klipper: part of a way that must be left for cruising
  kink,                    ///< corner rule of LinuxCNC: acceleration of one period
  path_velocity,           ///< the control's own limit of the speed
  path_acceleration,       ///< the same of the acceleration
  ramp_down,               ///< slowing towards a slower place
  exact_stop,
  dwell,
  tool_change,
  spindle_start,
  indexing,  ///< rotary axes turn while the tool stands
  swing,     ///< the tool turns about its tip, which X, Y and Z hold
};
inline constexpr std::size_t cause_kind_count = static_cast<std::size_t>(CauseKind::swing) + 1;
/// X, Y and Z stand, so nothing limits a feed.
constexpr bool is_pause(CauseKind kind) {
  return kind >= CauseKind::dwell;
}

/// Limiting cause, with the axis that sets it where one does.
struct Cause {
  CauseKind kind = CauseKind::programmed_feed;
  std::int8_t axis = -1;  ///< place in cause_axes; -1 none
  bool operator==(const Cause&) const = default;
};

/// What is known of a kind of cause: one row for keys, titles, legends and colours.
struct CauseInfo {
  CauseKind kind = CauseKind::programmed_feed;
  std::string_view key;
  std::string_view title;       ///< whatever the axis
  std::string_view axis_title;  ///< %1: the axis that sets it; empty: no axis does
  std::uint32_t light = 0;      ///< colour on a light background, 0xRRGGBB
  std::uint32_t dark = 0;       ///< the same on a dark one

  constexpr bool by_axis() const { return !axis_title.empty(); }
};

const CauseInfo& info_of(CauseKind kind);

/// Name of the axis that sets it; blank for none.
char axis_name(Cause cause);
/// Stable key for files: "programmed_feed", "axis_jerk_x".
std::string cause_key(Cause cause);
/// For people: "programmed feed", "jerk of axis X", "axis jerk".
std::string cause_title(Cause cause);
/// Every cause there can be, in a fixed order for tables and legends.
const std::vector<Cause>& all_causes();
/// Position in all_causes().
std::size_t cause_index(Cause cause);

}  // namespace feedscope
