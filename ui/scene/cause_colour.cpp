#include "ui/scene/cause_colour.h"

#include <fmt/format.h>

#include <cstdint>

namespace feedscope::ui {
namespace {

constexpr Rgb from_hex(std::uint32_t rgb) {
  return {static_cast<double>(rgb >> 16 & 0xff) / 255, static_cast<double>(rgb >> 8 & 0xff) / 255,
          static_cast<double>(rgb & 0xff) / 255};
}

struct Pair {
  std::uint32_t light, dark;
};

Pair colours_of(CauseKind kind) {
  switch (kind) {
    case CauseKind::programmed_feed:
      return {0xc3cad2, 0xcbd0d7};
    case CauseKind::rapid:
      return {0xb875a3, 0xd190c1};
    case CauseKind::axis_velocity:
      return {0x56b4e9, 0x6ec9ff};
    case CauseKind::axis_acceleration:
      return {0x0072b2, 0x519de1};
    case CauseKind::axis_jerk:
      return {0xd55e00, 0xff8022};
    case CauseKind::radial_acceleration:
      return {0x283aa6, 0x6b61c7};
    case CauseKind::radial_jerk:
      return {0x902b02, 0xf6946f};
    case CauseKind::blend_velocity:
      return {0x9285fe, 0x8f87ff};
    case CauseKind::blend_radial_acceleration:
      return {0x400072, 0x6d37c6};
    case CauseKind::blend_radial_jerk:
      return {0xff8297, 0xe64f70};
    case CauseKind::blend_tangential_acceleration:
      return {0x93df74, 0xa9f583};
    case CauseKind::blend_tangential_jerk:
      return {0x570f00, 0x904331};
    case CauseKind::curvilinear_jerk:
      return {0x7ba655, 0xdaffb4};
    case CauseKind::curvature_crossing:
      return {0x4a0352, 0x8d4993};
    case CauseKind::interpolation_period:
      return {0x5b7339, 0x798d43};
    case CauseKind::contour_tolerance:
      return {0x009e73, 0x008c65};
    case CauseKind::lookahead_horizon:
      return {0x145536, 0x98ffd1};
    case CauseKind::ramp_down:
      return {0xf0b429, 0xa86e01};
    case CauseKind::exact_stop:
      return {0x22262a, 0xa99e9d};
    case CauseKind::dwell:
      return {0x644a65, 0x8a6d8b};
    case CauseKind::tool_change:
      return {0x7000e0, 0x9800f8};
    case CauseKind::spindle_start:
      return {0xf0f800, 0xe8e000};
  }
  return {};
}

}  // namespace

Rgb cause_colour(CauseKind kind, Background background) {
  const Pair colours = colours_of(kind);
  return from_hex(background == Background::dark ? colours.dark : colours.light);
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
