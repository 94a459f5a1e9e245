#include "core/analysis/run/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/translatable.h"

namespace feedscope {
namespace {

using enum Dimension;
using Id = QuantityId;
using Chart = QuantityChart;

double across(const Instant& i) {
  return std::sqrt(std::max(
      0.0, i.set.acceleration.squaredNorm() - i.set.tangential_acceleration * i.set.tangential_acceleration));
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

template <int axis>
double actual_position(const Instant& i) {
  return i.actual != nullptr ? i.actual->motion.position[axis] : unknown;
}

template <int axis>
double following_error(const Instant& i) {
  return i.actual != nullptr ? i.actual->motion.following_error[axis] : unknown;
}

double whole_following_error(const Instant& i) {
  return i.actual != nullptr ? i.actual->motion.following_error.norm() : unknown;
}

double following_error_across(const Instant& i) {
  if (i.actual == nullptr) {
    return unknown;
  }
  const Vec3& error = i.actual->motion.following_error;
  if (!(i.set.speed > 0)) {
    return error.norm();
  }
  return error.cross(i.set.velocity).norm() / i.set.velocity.norm();
}

double actual_contour_error(const Instant& i) {
  return i.actual != nullptr && i.actual->cuts ? i.actual->contour_error : unknown;
}

template <CuttingLoad LoadSample::*at_feed, double CuttingLoad::*number>
double of_load(const Instant& i) {
  return i.load != nullptr && i.load->has_load() ? (i.load->*at_feed).*number : unknown;
}

template <std::size_t axis, double AxisState::*value>
double of_rotary(const Instant& i) {
  return i.rotary != nullptr ? i.rotary->rotary[axis].*value : unknown;
}

template <std::size_t axis, double AxisState::*value>
double of_linear(const Instant& i) {
  return i.rotary != nullptr ? i.rotary->linear[axis].*value : unknown;
}

constexpr auto predicted = &LoadSample::predicted;
constexpr auto programmed = &LoadSample::programmed;

constexpr QuantitySource drives = QuantitySource::drives;
constexpr QuantitySource cut = QuantitySource::load;
constexpr QuantitySource rotary = QuantitySource::rotary;

constexpr std::array<QuantityInfo, quantity_count> quantities{{
    {Id::time, "time", "time_s", QT_TRANSLATE_NOOP("core", "Time"), time, -1, Chart::none, "", false, false,
     [](const Instant& i) { return i.set.time; }},
    {Id::path_length, "path_length", "path_mm", QT_TRANSLATE_NOOP("core", "Path length"), length, -1,
     Chart::none, "", false, false, [](const Instant& i) { return i.set.path_length; }},
    {Id::line, "line", "line", QT_TRANSLATE_NOOP("core", "Line"), number, -1, Chart::none, "", false, false,
     [](const Instant& i) { return static_cast<double>(i.set.line); }},
    {Id::position_x, "x", "x_mm", QT_TRANSLATE_NOOP("core", "Position of %1"), length, 0, Chart::none, "",
     false, true, [](const Instant& i) { return i.set.position.x(); }},
    {Id::position_y, "y", "y_mm", QT_TRANSLATE_NOOP("core", "Position of %1"), length, 1, Chart::none, "",
     false, true, [](const Instant& i) { return i.set.position.y(); }},
    {Id::position_z, "z", "z_mm", QT_TRANSLATE_NOOP("core", "Position of %1"), length, 2, Chart::none, "",
     false, true, [](const Instant& i) { return i.set.position.z(); }},
    {Id::feed, "feed", "feed_mm_min", QT_TRANSLATE_NOOP("core", "Feed"), feed, -1, Chart::feed,
     QT_TRANSLATE_NOOP("core", "achieved"), true, false, [](const Instant& i) { return i.set.speed; }},
    {Id::programmed_feed, "programmed_feed", "programmed_feed_mm_min",
     QT_TRANSLATE_NOOP("core", "Programmed feed"), feed, -1, Chart::feed,
     QT_TRANSLATE_NOOP("core", "programmed"), false, false,
     [](const Instant& i) { return i.set.programmed_feed; }},
    {Id::velocity_x, "vx", "vx_mm_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), feed, 0, Chart::feed, "",
     false, true, [](const Instant& i) { return i.set.velocity.x(); }},
    {Id::velocity_y, "vy", "vy_mm_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), feed, 1, Chart::feed, "",
     false, true, [](const Instant& i) { return i.set.velocity.y(); }},
    {Id::velocity_z, "vz", "vz_mm_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), feed, 2, Chart::feed, "",
     false, true, [](const Instant& i) { return i.set.velocity.z(); }},
    {Id::acceleration_x, "ax", "ax_m_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"), acceleration, 0,
     Chart::acceleration, "", false, true, [](const Instant& i) { return i.set.acceleration.x(); }},
    {Id::acceleration_y, "ay", "ay_m_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"), acceleration, 1,
     Chart::acceleration, "", false, true, [](const Instant& i) { return i.set.acceleration.y(); }},
    {Id::acceleration_z, "az", "az_m_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"), acceleration, 2,
     Chart::acceleration, "", false, true, [](const Instant& i) { return i.set.acceleration.z(); }},
    {Id::jerk_x, "jx", "jx_m_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), jerk, 0, Chart::jerk, "", false,
     true, [](const Instant& i) { return i.set.jerk.x(); }},
    {Id::jerk_y, "jy", "jy_m_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), jerk, 1, Chart::jerk, "", false,
     true, [](const Instant& i) { return i.set.jerk.y(); }},
    {Id::jerk_z, "jz", "jz_m_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), jerk, 2, Chart::jerk, "", false,
     true, [](const Instant& i) { return i.set.jerk.z(); }},
    {Id::tangential_acceleration, "tangential_acceleration", "at_m_s2",
     QT_TRANSLATE_NOOP("core", "Tangential acceleration"), acceleration, -1, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "tangential"), true, true,
     [](const Instant& i) { return i.set.tangential_acceleration; }},
    {Id::tangential_jerk, "tangential_jerk", "jt_m_s3", QT_TRANSLATE_NOOP("core", "Tangential jerk"), jerk,
     -1, Chart::jerk, QT_TRANSLATE_NOOP("core", "tangential"), true, true,
     [](const Instant& i) { return i.set.tangential_jerk; }},
    {Id::acceleration_across, "acceleration_across", "an_m_s2",
     QT_TRANSLATE_NOOP("core", "Acceleration across the path"), acceleration, -1, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "across"), true, false, across},
    {Id::acceleration, "acceleration", "", QT_TRANSLATE_NOOP("core", "Acceleration"), acceleration, -1,
     Chart::none, "", true, false, [](const Instant& i) { return i.set.acceleration.norm(); }},
    {Id::jerk, "jerk", "", QT_TRANSLATE_NOOP("core", "Jerk"), jerk, -1, Chart::none, "", true, false,
     [](const Instant& i) { return i.set.jerk.norm(); }},
    {Id::feed_ratio, "feed_ratio", "", QT_TRANSLATE_NOOP("core", "Feed / programmed"), ratio, -1, Chart::none,
     "", true, false,
     [](const Instant& i) { return i.set.programmed_feed > 0 ? i.set.speed / i.set.programmed_feed : 0; }},
    {Id::actual_x, "actual_x", "actual_x_mm", QT_TRANSLATE_NOOP("core", "Actual position of %1"), length, 0,
     Chart::none, "", false, true, actual_position<0>, drives},
    {Id::actual_y, "actual_y", "actual_y_mm", QT_TRANSLATE_NOOP("core", "Actual position of %1"), length, 1,
     Chart::none, "", false, true, actual_position<1>, drives},
    {Id::actual_z, "actual_z", "actual_z_mm", QT_TRANSLATE_NOOP("core", "Actual position of %1"), length, 2,
     Chart::none, "", false, true, actual_position<2>, drives},
    {Id::following_error_x, "following_error_x", "following_error_x_um",
     QT_TRANSLATE_NOOP("core", "Following error of %1"), error, 0, Chart::following_error, "", false, true,
     following_error<0>, drives},
    {Id::following_error_y, "following_error_y", "following_error_y_um",
     QT_TRANSLATE_NOOP("core", "Following error of %1"), error, 1, Chart::following_error, "", false, true,
     following_error<1>, drives},
    {Id::following_error_z, "following_error_z", "following_error_z_um",
     QT_TRANSLATE_NOOP("core", "Following error of %1"), error, 2, Chart::following_error, "", false, true,
     following_error<2>, drives},
    {Id::actual_contour_error, "actual_contour_error", "actual_contour_error_um",
     QT_TRANSLATE_NOOP("core", "Contour error of the actual path"), error, -1, Chart::following_error,
     QT_TRANSLATE_NOOP("core", "contour error"), true, false, actual_contour_error, drives},
    {Id::following_error_across, "following_error_across", "",
     QT_TRANSLATE_NOOP("core", "Following error across the path"), error, -1, Chart::following_error,
     QT_TRANSLATE_NOOP("core", "across"), false, false, following_error_across, drives},
    {Id::following_error, "following_error", "", QT_TRANSLATE_NOOP("core", "Following error"), error, -1,
     Chart::none, "", true, false, whole_following_error, drives},
    {Id::feed_per_tooth, "feed_per_tooth", "feed_per_tooth_mm", QT_TRANSLATE_NOOP("core", "Feed per tooth"),
     length, -1, Chart::none, "", false, false, of_load<predicted, &CuttingLoad::feed_per_tooth>, cut},
    {Id::torque, "torque", "torque_nm", QT_TRANSLATE_NOOP("core", "Torque"), Dimension::torque, -1,
     Chart::none, "", false, false, of_load<predicted, &CuttingLoad::torque>, cut},
    {Id::power, "power", "power_kw", QT_TRANSLATE_NOOP("core", "Cutting power"), Dimension::power, -1,
     Chart::none, "", false, false, of_load<predicted, &CuttingLoad::power>, cut},
    {Id::mean_force, "mean_force", "cutting_force_mean_n", QT_TRANSLATE_NOOP("core", "Mean cutting force"),
     force, -1, Chart::force, QT_TRANSLATE_NOOP("core", "mean"), false, false,
     of_load<predicted, &CuttingLoad::mean_force>, cut},
    {Id::peak_force, "peak_force", "cutting_force_peak_n", QT_TRANSLATE_NOOP("core", "Peak cutting force"),
     force, -1, Chart::force, QT_TRANSLATE_NOOP("core", "peak"), true, false,
     of_load<predicted, &CuttingLoad::peak_force>, cut},
    {Id::chip_thickness, "chip_thickness", "chip_thickness_um", QT_TRANSLATE_NOOP("core", "Chip thickness"),
     error, -1, Chart::chip, QT_TRANSLATE_NOOP("core", "predicted"), true, false,
     of_load<predicted, &CuttingLoad::chip_thickness>, cut},
    {Id::chip_thickness_programmed, "chip_thickness_programmed", "chip_thickness_programmed_um",
     QT_TRANSLATE_NOOP("core", "Chip thickness at the programmed feed"), error, -1, Chart::chip,
     QT_TRANSLATE_NOOP("core", "at programmed feed"), false, false,
     of_load<programmed, &CuttingLoad::chip_thickness>, cut},
    {Id::peak_force_programmed, "peak_force_programmed", "cutting_force_peak_programmed_n",
     QT_TRANSLATE_NOOP("core", "Peak cutting force at the programmed feed"), force, -1, Chart::force,
     QT_TRANSLATE_NOOP("core", "peak at programmed feed"), false, false,
     of_load<programmed, &CuttingLoad::peak_force>, cut},
    {Id::mean_force_programmed, "mean_force_programmed", "cutting_force_mean_programmed_n",
     QT_TRANSLATE_NOOP("core", "Mean cutting force at the programmed feed"), force, -1, Chart::none, "",
     false, false, of_load<programmed, &CuttingLoad::mean_force>, cut},
    {Id::feed_per_tooth_programmed, "feed_per_tooth_programmed", "feed_per_tooth_programmed_mm",
     QT_TRANSLATE_NOOP("core", "Feed per tooth at the programmed feed"), length, -1, Chart::none, "", false,
     false, of_load<programmed, &CuttingLoad::feed_per_tooth>, cut},
    {Id::torque_programmed, "torque_programmed", "torque_programmed_nm",
     QT_TRANSLATE_NOOP("core", "Torque at the programmed feed"), Dimension::torque, -1, Chart::none, "",
     false, false, of_load<programmed, &CuttingLoad::torque>, cut},
    {Id::power_programmed, "power_programmed", "power_programmed_kw",
     QT_TRANSLATE_NOOP("core", "Cutting power at the programmed feed"), Dimension::power, -1, Chart::none, "",
     false, false, of_load<programmed, &CuttingLoad::power>, cut},
    {Id::position_a, "a", "a_deg", QT_TRANSLATE_NOOP("core", "Position of %1"), angle, 3,
     Chart::rotary_position, "", false, true, of_rotary<0, &AxisState::position>, rotary},
    {Id::position_b, "b", "b_deg", QT_TRANSLATE_NOOP("core", "Position of %1"), angle, 4,
     Chart::rotary_position, "", false, true, of_rotary<1, &AxisState::position>, rotary},
    {Id::position_c, "c", "c_deg", QT_TRANSLATE_NOOP("core", "Position of %1"), angle, 5,
     Chart::rotary_position, "", false, true, of_rotary<2, &AxisState::position>, rotary},
    {Id::velocity_a, "va", "va_rev_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), turning, 3,
     Chart::rotary_velocity, "", false, true, of_rotary<0, &AxisState::velocity>, rotary},
    {Id::velocity_b, "vb", "vb_rev_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), turning, 4,
     Chart::rotary_velocity, "", false, true, of_rotary<1, &AxisState::velocity>, rotary},
    {Id::velocity_c, "vc", "vc_rev_min", QT_TRANSLATE_NOOP("core", "Velocity of %1"), turning, 5,
     Chart::rotary_velocity, "", false, true, of_rotary<2, &AxisState::velocity>, rotary},
    {Id::acceleration_a, "aa", "aa_rev_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"),
     turning_acceleration, 3, Chart::rotary_acceleration, "", false, true,
     of_rotary<0, &AxisState::acceleration>, rotary},
    {Id::acceleration_b, "ab", "ab_rev_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"),
     turning_acceleration, 4, Chart::rotary_acceleration, "", false, true,
     of_rotary<1, &AxisState::acceleration>, rotary},
    {Id::acceleration_c, "ac", "ac_rev_s2", QT_TRANSLATE_NOOP("core", "Acceleration of %1"),
     turning_acceleration, 5, Chart::rotary_acceleration, "", false, true,
     of_rotary<2, &AxisState::acceleration>, rotary},
    {Id::jerk_a, "ja", "ja_rev_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), turning_jerk, 3,
     Chart::rotary_jerk, "", false, true, of_rotary<0, &AxisState::jerk>, rotary},
    {Id::jerk_b, "jb", "jb_rev_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), turning_jerk, 4,
     Chart::rotary_jerk, "", false, true, of_rotary<1, &AxisState::jerk>, rotary},
    {Id::jerk_c, "jc", "jc_rev_s3", QT_TRANSLATE_NOOP("core", "Jerk of %1"), turning_jerk, 5,
     Chart::rotary_jerk, "", false, true, of_rotary<2, &AxisState::jerk>, rotary},
    {Id::machine_velocity_x, "machine_vx", "machine_vx_mm_min",
     QT_TRANSLATE_NOOP("core", "Velocity of %1 of the machine"), feed, 0, Chart::feed,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<0, &AxisState::velocity>, rotary},
    {Id::machine_velocity_y, "machine_vy", "machine_vy_mm_min",
     QT_TRANSLATE_NOOP("core", "Velocity of %1 of the machine"), feed, 1, Chart::feed,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<1, &AxisState::velocity>, rotary},
    {Id::machine_velocity_z, "machine_vz", "machine_vz_mm_min",
     QT_TRANSLATE_NOOP("core", "Velocity of %1 of the machine"), feed, 2, Chart::feed,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<2, &AxisState::velocity>, rotary},
    {Id::machine_acceleration_x, "machine_ax", "machine_ax_m_s2",
     QT_TRANSLATE_NOOP("core", "Acceleration of %1 of the machine"), acceleration, 0, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<0, &AxisState::acceleration>,
     rotary},
    {Id::machine_acceleration_y, "machine_ay", "machine_ay_m_s2",
     QT_TRANSLATE_NOOP("core", "Acceleration of %1 of the machine"), acceleration, 1, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<1, &AxisState::acceleration>,
     rotary},
    {Id::machine_acceleration_z, "machine_az", "machine_az_m_s2",
     QT_TRANSLATE_NOOP("core", "Acceleration of %1 of the machine"), acceleration, 2, Chart::acceleration,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<2, &AxisState::acceleration>,
     rotary},
    {Id::machine_jerk_x, "machine_jx", "machine_jx_m_s3",
     QT_TRANSLATE_NOOP("core", "Jerk of %1 of the machine"), jerk, 0, Chart::jerk,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<0, &AxisState::jerk>, rotary},
    {Id::machine_jerk_y, "machine_jy", "machine_jy_m_s3",
     QT_TRANSLATE_NOOP("core", "Jerk of %1 of the machine"), jerk, 1, Chart::jerk,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<1, &AxisState::jerk>, rotary},
    {Id::machine_jerk_z, "machine_jz", "machine_jz_m_s3",
     QT_TRANSLATE_NOOP("core", "Jerk of %1 of the machine"), jerk, 2, Chart::jerk,
     QT_TRANSLATE_NOOP("core", "%1 of the machine"), false, true, of_linear<2, &AxisState::jerk>, rotary},
    {Id::machine_x, "machine_x", "machine_x_mm", QT_TRANSLATE_NOOP("core", "Position of %1 of the machine"),
     length, 0, Chart::none, "", false, true, of_linear<0, &AxisState::position>, rotary},
    {Id::machine_y, "machine_y", "machine_y_mm", QT_TRANSLATE_NOOP("core", "Position of %1 of the machine"),
     length, 1, Chart::none, "", false, true, of_linear<1, &AxisState::position>, rotary},
    {Id::machine_z, "machine_z", "machine_z_mm", QT_TRANSLATE_NOOP("core", "Position of %1 of the machine"),
     length, 2, Chart::none, "", false, true, of_linear<2, &AxisState::position>, rotary},
}};

constexpr bool is_in(QuantityId id, const ChartedRange& range) {
  return id >= range.first &&
         static_cast<std::size_t>(id) < static_cast<std::size_t>(range.first) + range.count;
}

constexpr bool is_consistent() {
  std::size_t coloured = 0;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const QuantityInfo& quantity = quantities[i];
    const bool charted = is_in(quantity.id, quantity.source == drives   ? charted_of_drives
                                            : quantity.source == cut    ? charted_of_load
                                            : quantity.source == rotary ? charted_of_rotary
                                                                        : charted_of_motion);
    if (static_cast<std::size_t>(quantity.id) != i || charted != (quantity.chart != Chart::none)) {
      return false;
    }
    coloured += quantity.colours ? 1 : 0;
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
