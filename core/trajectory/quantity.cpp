#include "core/trajectory/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/translatable.h"

namespace feedscope {
namespace {

using enum Dimension;
using Id = QuantityId;
using Chart = QuantityChart;

double across(const State& s) {
  return std::sqrt(
      std::max(0.0, s.acceleration.squaredNorm() - s.tangential_acceleration * s.tangential_acceleration));
}

constexpr std::array<QuantityInfo, quantity_count> quantities{{
    {Id::time, "time", "time_s", QT_TRANSLATE_NOOP("core", "Time"), time, -1, Chart::none, "", false, false,
     [](const State& s) { return s.time; }},
    {Id::path_length, "path_length", "path_mm", QT_TRANSLATE_NOOP("core", "Path length"), length, -1,
     Chart::none, "", false, false, [](const State& s) { return s.path_length; }},
    {Id::line, "line", "line", QT_TRANSLATE_NOOP("core", "Line"), number, -1, Chart::none, "", false, false,
     [](const State& s) { return static_cast<double>(s.line); }},
    {Id::position_x, "x", "x_mm", QT_TRANSLATE_NOOP("core", "Position of %1"), length, 0, Chart::none, "",
     false, true, [](const State& s) { return s.position.x(); }},
    {Id::position_y, "y", "y_mm", QT_TRANSLATE_NOOP("core", "Position of %1"), length, 1, Chart::none, "",
     false, true, [](const State& s) { return s.position.y(); }},
    {Id::position_z, "z", "z_mm", QT_TRANSLATE_NOOP("core", "Position of %1"), length, 2, Chart::none, "",
     false, true, [](const State& s) { return s.position.z(); }},
    {Id::feed, "feed", "feed_mm_min", QT_TRANSLATE_NOOP("core", "Feed"), feed, -1, Chart::feed,
     QT_TRANSLATE_NOOP("core", "achieved"), true, false, [](const State& s) { return s.speed; }},
    {Id::programmed_feed, "programmed_feed", "programmed_feed_mm_min",
     QT_TRANSLATE_NOOP("core", "Programmed feed"), feed, -1, Chart::feed,
     QT_TRANSLATE_NOOP("core", "programmed"), false, false, [](const State& s) { return s.programmed_feed; }},
    {Id::velocity_x, "vx", "vx_mm_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), feed, 0, Chart::feed, "",
     false, true, [](const State& s) { return s.velocity.x(); }},
    {Id::velocity_y, "vy", "vy_mm_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), feed, 1, Chart::feed, "",
     false, true, [](const State& s) { return s.velocity.y(); }},
    {Id::velocity_z, "vz", "vz_mm_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), feed, 2, Chart::feed, "",
     false, true, [](const State& s) { return s.velocity.z(); }},
    {Id::acceleration_x, "ax", "ax_m_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"), acceleration, 0,
     Chart::acceleration, "", false, true, [](const State& s) { return s.acceleration.x(); }},
    {Id::acceleration_y, "ay", "ay_m_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"), acceleration, 1,
     Chart::acceleration, "", false, true, [](const State& s) { return s.acceleration.y(); }},
    {Id::acceleration_z, "az", "az_m_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"), acceleration, 2,
     Chart::acceleration, "", false, true, [](const State& s) { return s.acceleration.z(); }},
    {Id::jerk_x, "jx", "jx_m_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), jerk, 0, Chart::jerk, "", false,
     true, [](const State& s) { return s.jerk.x(); }},
    {Id::jerk_y, "jy", "jy_m_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), jerk, 1, Chart::jerk, "", false,
     true, [](const State& s) { return s.jerk.y(); }},
    {Id::jerk_z, "jz", "jz_m_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), jerk, 2, Chart::jerk, "", false,
     true, [](const State& s) { return s.jerk.z(); }},
    {Id::tangential_acceleration, "tangential_acceleration", "at_m_s2",
     QT_TRANSLATE_NOOP("core", "Tangential acceleration"), acceleration, -1, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "tangential"), true, true,
     [](const State& s) { return s.tangential_acceleration; }},
    {Id::tangential_jerk, "tangential_jerk", "jt_m_s3", QT_TRANSLATE_NOOP("core", "Tangential jerk"), jerk,
     -1, Chart::jerk, QT_TRANSLATE_NOOP("core", "tangential"), true, true,
     [](const State& s) { return s.tangential_jerk; }},
    {Id::acceleration_across, "acceleration_across", "an_m_s2",
     QT_TRANSLATE_NOOP("core", "Acceleration across the path"), acceleration, -1, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "across"), true, false, across},
    {Id::acceleration, "acceleration", "", QT_TRANSLATE_NOOP("core", "Acceleration"), acceleration, -1,
     Chart::none, "", true, false, [](const State& s) { return s.acceleration.norm(); }},
    {Id::jerk, "jerk", "", QT_TRANSLATE_NOOP("core", "Jerk"), jerk, -1, Chart::none, "", true, false,
     [](const State& s) { return s.jerk.norm(); }},
    {Id::feed_ratio, "feed_ratio", "", QT_TRANSLATE_NOOP("core", "Feed / programmed"), ratio, -1, Chart::none,
     "", true, false, [](const State& s) { return s.programmed_feed > 0 ? s.speed / s.programmed_feed : 0; }},
}};

constexpr bool is_consistent() {
  std::size_t coloured = 0;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const bool charted = i - static_cast<std::size_t>(first_charted) < charted_count;
    if (static_cast<std::size_t>(quantities[i].id) != i || charted != (quantities[i].chart != Chart::none)) {
      return false;
    }
    coloured += quantities[i].colours ? 1 : 0;
  }
  return coloured == coloured_count;
}
static_assert(is_consistent());

}  // namespace

std::span<const QuantityInfo> all_quantities() {
  return quantities;
}

const QuantityInfo& info_of(QuantityId id) {
  return quantities[static_cast<std::size_t>(id)];
}

}  // namespace feedscope
