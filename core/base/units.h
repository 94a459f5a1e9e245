#pragma once

/// The only place where units are converted. Internal units: mm, s, mm/s, mm/s2, mm/s3, rad.
namespace feedscope::units {

inline constexpr double pi = 3.14159265358979323846;

constexpr double from_mm_min(double v) {
  return v / 60.0;
}  ///< mm/min -> mm/s
constexpr double to_mm_min(double v) {
  return v * 60.0;
}  ///< mm/s -> mm/min
constexpr double from_m_min(double v) {
  return v * 1000 / 60;
}  ///< m/min -> mm/s
constexpr double to_m_min(double v) {
  return v * 60 / 1000;
}  ///< mm/s -> m/min
constexpr double from_m(double v) {
  return v * 1000.0;
}  ///< m/s2 -> mm/s2, m/s3 -> mm/s3
constexpr double to_m(double v) {
  return v / 1000.0;
}  ///< mm/s2 -> m/s2, mm/s3 -> m/s3
constexpr double from_um(double v) {
  return v / 1000.0;
}  ///< um -> mm
constexpr double to_um(double v) {
  return v * 1000.0;
}  ///< mm -> um
constexpr double from_ms(double v) {
  return v / 1000.0;
}  ///< ms -> s
constexpr double to_ms(double v) {
  return v * 1000.0;
}  ///< s -> ms
constexpr double as_it_is(double v) {
  return v;
}  ///< for equal units in file and core
constexpr double from_inch(double v) {
  return v * 25.4;
}  ///< inch -> mm
constexpr double from_deg(double v) {
  return v * pi / 180.0;
}  ///< degrees -> rad
constexpr double to_deg(double v) {
  return v * 180.0 / pi;
}  ///< rad -> degrees
constexpr double from_turns(double v) {
  return v * 2 * pi;
}  ///< rev -> rad, rev/s2 -> rad/s2, rev/s3 -> rad/s3
constexpr double to_turns(double v) {
  return v / (2 * pi);
}  ///< rad -> rev
constexpr double from_turns_min(double v) {
  return v * 2 * pi / 60;
}  ///< rev/min -> rad/s
constexpr double to_turns_min(double v) {
  return v * 60 / (2 * pi);
}  ///< rad/s -> rev/min
constexpr double from_rev_min(double v) {
  return v / 60.0;
}  ///< 1/min -> 1/s
constexpr double to_rev_min(double v) {
  return v * 60.0;
}  ///< 1/s -> 1/min
constexpr double from_n_m(double v) {
  return v * 1000.0;
}  ///< N m -> N mm
constexpr double to_n_m(double v) {
  return v / 1000.0;
}  ///< N mm -> N m
constexpr double from_kw(double v) {
  return v * 1e6;
}  ///< kW -> N mm/s
constexpr double to_kw(double v) {
  return v / 1e6;
}  ///< N mm/s -> kW

}  // namespace feedscope::units
