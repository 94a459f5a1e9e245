#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/analysis/contour/actual_path.h"
#include "core/analysis/load/load_sample.h"
#include "core/analysis/rotary/rotary_sample.h"
#include "core/base/dimension.h"

namespace feedscope {

/// Data of a run at one instant. Refers to its parts.
struct Instant {
  // NOLINTNEXTLINE(google-explicit-constructor): a state is an instant of a run with nothing beside its
  // motion
  Instant(const State& state, const ActualSample* drives = nullptr, const LoadSample* cut = nullptr,
          const RotarySample* turned = nullptr)
      : set(state), actual(drives), load(cut), rotary(turned) {}

  const State& set;
  const ActualSample* actual;  ///< null without drives
  const LoadSample* load;      ///< null without known operations
  const RotarySample* rotary;  ///< null unless a rotary axis turns in the run
};

/// Quantities of a run at every instant, in the order of CSV columns.
enum class QuantityId : std::uint8_t {
  time,
  path_length,
  line,
  position_x,
  position_y,
  position_z,
  feed,
  programmed_feed,
  velocity_x,
  velocity_y,
  velocity_z,
  acceleration_x,
  acceleration_y,
  acceleration_z,
  jerk_x,
  jerk_y,
  jerk_z,
  tangential_acceleration,
  tangential_jerk,
  acceleration_across,  ///< perpendicular to the path: speed squared times curvature
  acceleration,         ///< length of the vector
  jerk,                 ///< length of the vector
  feed_ratio,           ///< achieved over programmed feed
  actual_x,             ///< the following ones are of the drives
  actual_y,
  actual_z,
  following_error_x,
  following_error_y,
  following_error_z,
  /// Distance of the actual position from the nearest programmed point; unknown unless ActualSample::cuts.
  actual_contour_error,
  following_error_across,  ///< perpendicular to the direction of the set motion; all of it at standstill
  following_error,         ///< length of the vector
  feed_per_tooth,          ///< the following ones are of the cutting load, at the achieved feed
  torque,
  power,
  mean_force,
  peak_force,
  chip_thickness,             ///< largest of one tooth
  chip_thickness_programmed,  ///< the following ones are at the programmed feed, at the same place
  peak_force_programmed,
  mean_force_programmed,
  feed_per_tooth_programmed,
  torque_programmed,
  power_programmed,
  position_a,  ///< the following ones are of the rotary axes
  position_b,
  position_c,
  velocity_a,
  velocity_b,
  velocity_c,
  acceleration_a,
  acceleration_b,
  acceleration_c,
  jerk_a,
  jerk_b,
  jerk_c,
  machine_velocity_x,  ///< the following ones are of the machine's linear axes, with rotary axes turning
                       ///< about the tip
  machine_velocity_y,
  machine_velocity_z,
  machine_acceleration_x,
  machine_acceleration_y,
  machine_acceleration_z,
  machine_jerk_x,
  machine_jerk_y,
  machine_jerk_z,
  machine_x,
  machine_y,
  machine_z,
};
inline constexpr std::size_t quantity_count = static_cast<std::size_t>(QuantityId::machine_z) + 1;

/// Part of a run that a quantity describes.
enum class QuantitySource : std::uint8_t {
  motion,  ///< set by the control
  drives,  ///< actual motion of the axes; NaN on a machine without drives
  load,    ///< cutting load; NaN without a cut that an operation describes
  rotary,  ///< rotary axes, and X, Y, Z with them; NaN for axes that the machine lacks
};

/// Chart that shows a quantity over time.
enum class QuantityChart : std::uint8_t {
  none,
  feed,
  acceleration,
  jerk,
  following_error,
  force,
  chip,
  rotary_position,
  rotary_velocity,
  rotary_acceleration,
  rotary_jerk
};

/// Charted quantities of one source; they are consecutive.
struct ChartedRange {
  QuantityId first;
  std::size_t count;  ///< number in the range
  std::size_t index;  ///< of the first one among all charted quantities
};
inline constexpr ChartedRange charted_of_motion{QuantityId::feed, 14, 0};
inline constexpr ChartedRange charted_of_drives{QuantityId::following_error_x, 5, charted_of_motion.count};
inline constexpr ChartedRange charted_of_load{QuantityId::mean_force, 5,
                                              charted_of_drives.index + charted_of_drives.count};
inline constexpr ChartedRange charted_of_rotary{QuantityId::position_a, 21,
                                                charted_of_load.index + charted_of_load.count};
inline constexpr std::size_t charted_count = charted_of_rotary.index + charted_of_rotary.count;
/// Index of a quantity among all charted ones.
constexpr std::size_t charted_index(QuantityId id) {
  const ChartedRange& range = id < charted_of_drives.first   ? charted_of_motion
                              : id < charted_of_load.first   ? charted_of_drives
                              : id < charted_of_rotary.first ? charted_of_load
                                                             : charted_of_rotary;
  return range.index + static_cast<std::size_t>(id) - static_cast<std::size_t>(range.first);
}

/// Number of quantities that can colour the executed path.
inline constexpr std::size_t coloured_count = 11;

/// One row for each quantity: CSV, charts, colours, measures of lessons and annotations use this list, so a
/// new quantity is a row here.
struct QuantityInfo {
  QuantityId id = QuantityId::time;
  std::string_view key;     ///< stable, for sessions, annotations and lessons: "acceleration_across"
  std::string_view column;  ///< of CSV, with its unit: "an_m_s2"; empty if none
  std::string_view title;   ///< English, marked for translation; %1: the axis
  Dimension dimension = Dimension::number;
  int axis = -1;  ///< index in cause_axes: X, Y, Z, A, B, C; -1: of the path
  QuantityChart chart = QuantityChart::none;
  std::string_view curve;  ///< name of its curve in the chart, marked for translation; empty: the axis
  bool colours = false;    ///< the executed path can be coloured by it
  bool is_signed = false;
  double (*of)(const Instant&) = nullptr;  ///< in internal units
  QuantitySource source = QuantitySource::motion;
};

/// In the order of QuantityId.
std::span<const QuantityInfo> all_quantities();
const QuantityInfo& info_of(QuantityId id);

}  // namespace feedscope
