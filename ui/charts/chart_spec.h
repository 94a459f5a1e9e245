#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <cstdint>
#include <vector>

#include "core/analysis/envelope/envelope.h"
#include "core/analysis/run/quantity.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

/// Meaning of a curve, which determines its colour in every theme.
enum class CurveRole : std::uint8_t { path, programmed, across, x, y, z, machine_x, machine_y, machine_z };
QColor curve_colour(CurveRole role, const ThemeColours& colours);

struct CurveSpec {
  QuantityId quantity = QuantityId::feed;
  QString key;  ///< stable, for files: "feed", "vx"
  QString name;
  CurveRole role = CurveRole::path;
  double width = 1;         ///< [px]
  bool may_be_cut = false;  ///< the chart need not grow far beyond the other curves to show it in full
  bool on_demand = false;   ///< hidden until the user requests it
};

struct ChartSpec {
  QString title;
  QString unit;
  std::vector<CurveSpec> curves;                   ///< in the order of the header
  double factor = 1;                               ///< `unit` per internal unit
  int decimals = 0;                                ///< of values shown as numbers
  QuantitySource source = QuantitySource::motion;  ///< runs without it have no such chart
  QString key = {};                                ///< stable, for files: "feed", "following_error"
  bool on_demand = false;                          ///< hidden until the user requests it

  double convert(double value) const { return value * factor; }
};

inline constexpr std::size_t chart_count = 10;
/// Indices of charts.
inline constexpr std::size_t acceleration_chart = 1;
inline constexpr std::size_t following_error_chart = 3;
inline constexpr std::size_t jerk_chart = 2;
inline constexpr std::size_t force_chart = 4;
inline constexpr std::size_t chip_chart = 5;
inline constexpr std::size_t rotary_velocity_chart = 7;
inline constexpr std::size_t rotary_acceleration_chart = 8;
inline constexpr std::size_t rotary_jerk_chart = 9;

/// Charts of feed, acceleration, jerk, following error, cutting force, chip thickness, and of positions,
/// velocities, accelerations and jerks of rotary axes: a curve for each charted quantity.
std::array<ChartSpec, chart_count> kinematic_chart_specs();

}  // namespace feedscope::ui
