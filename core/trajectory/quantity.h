#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/dimension.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// What a motion has at every instant, in the order of CSV columns.
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
  acceleration_across,  ///< square to the path: speed squared times curvature
  acceleration,         ///< length of the vector
  jerk,                 ///< length of the vector
  feed_ratio,           ///< achieved over programmed feed
};
inline constexpr std::size_t quantity_count = static_cast<std::size_t>(QuantityId::feed_ratio) + 1;

/// Those that are drawn over time, one behind the other.
inline constexpr QuantityId first_charted = QuantityId::feed;
inline constexpr std::size_t charted_count =
    static_cast<std::size_t>(QuantityId::acceleration_across) - static_cast<std::size_t>(first_charted) + 1;
/// How many colour the executed path.
inline constexpr std::size_t coloured_count = 7;

/// Where a quantity is drawn over time.
enum class QuantityChart : std::uint8_t { none, feed, acceleration, jerk };

/// One row for each quantity: CSV, charts, colours, measures of lessons and annotations read this list, so
/// that a new quantity is a row here.
struct QuantityInfo {
  QuantityId id = QuantityId::time;
  std::string_view key;     ///< stable, for sessions, annotations and lessons: "acceleration_across"
  std::string_view column;  ///< of CSV, with its unit: "an_m_s2"; empty: none
  std::string_view title;   ///< English, marked for translation; %1: the axis
  Dimension dimension = Dimension::number;
  int axis = -1;  ///< 0 X, 1 Y, 2 Z; -1: of the path
  QuantityChart chart = QuantityChart::none;
  std::string_view curve;  ///< name of its curve there, marked for translation; empty: the axis
  bool colours = false;    ///< the executed path can be coloured by it
  bool is_signed = false;
  double (*of)(const State&) = nullptr;  ///< in inside units
};

/// By QuantityId.
std::span<const QuantityInfo> all_quantities();
const QuantityInfo& info_of(QuantityId id);

}  // namespace feedscope
