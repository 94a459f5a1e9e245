#include "ui/scene/cause_colour.h"

#include <fmt/format.h>

#include <cstdint>

namespace feedscope::ui {
namespace {

constexpr Rgb from_hex(std::uint32_t rgb) {
  return {static_cast<double>(rgb >> 16 & 0xff) / 255, static_cast<double>(rgb >> 8 & 0xff) / 255,
          static_cast<double>(rgb & 0xff) / 255};
}

}  // namespace

Rgb cause_colour(CauseKind kind) {
  switch (kind) {
    case CauseKind::programmed_feed:
      return from_hex(0xc3cad2);
    case CauseKind::rapid:
      return palette::rapid;
    case CauseKind::axis_velocity:
      return from_hex(0x56b4e9);
    case CauseKind::axis_acceleration:
      return from_hex(0x0072b2);
    case CauseKind::axis_jerk:
      return from_hex(0xd55e00);
    case CauseKind::radial_acceleration:
      return from_hex(0x283aa6);
    case CauseKind::radial_jerk:
      return from_hex(0x902b02);
    case CauseKind::blend_velocity:
      return from_hex(0x9285fe);
    case CauseKind::blend_radial_acceleration:
      return from_hex(0x400072);
    case CauseKind::blend_radial_jerk:
      return from_hex(0xff8297);
    case CauseKind::blend_tangential_acceleration:
      return from_hex(0x93df74);
    case CauseKind::blend_tangential_jerk:
      return from_hex(0x570f00);
    case CauseKind::curvilinear_jerk:
      return from_hex(0x7ba655);
    case CauseKind::curvature_crossing:
      return from_hex(0x4a0352);
    case CauseKind::interpolation_period:
      return from_hex(0x5b7339);
    case CauseKind::contour_tolerance:
      return from_hex(0x009e73);
    case CauseKind::lookahead_horizon:
      return from_hex(0x145536);
    case CauseKind::ramp_down:
      return from_hex(0xf0b429);
    case CauseKind::exact_stop:
      return from_hex(0x22262a);
    case CauseKind::dwell:
      return from_hex(0x644a65);
  }
  return palette::text;
}

std::string cause_kind_title(CauseKind kind) {
  const std::string title = cause_title({kind, -1});
  switch (kind) {
    case CauseKind::axis_velocity:
    case CauseKind::axis_acceleration:
    case CauseKind::axis_jerk:
      return fmt::format("axis {}", title);
    default:
      return title;
  }
}

}  // namespace feedscope::ui
