#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/machine/settings.h"

namespace feedscope {

/// Setting of the contour tolerance [mm].
inline constexpr const char* contour_tolerance_key = "contour_tolerance_mm";
/// What `linuxcnc` has instead: P of its G64 [mm].
inline constexpr const char* blend_tolerance_key = "blend_tolerance_mm";
/// The least contour tolerance and blend distance above 0 [mm], far below what any control resolves: with
/// smaller ones rounding would decide where a blend begins.
inline constexpr double least_tolerance = 1e-6;
/// Setting that asks for collinear blocks to be merged: how far points may lie from the block that takes
/// their place [mm]; without it none are.
inline constexpr const char* merge_collinear_key = "merge_collinear_mm";
/// Setting that says whether the program's own tolerances and blend distances go before it: "on", "off".
inline constexpr const char* program_tolerance_key = "program_tolerance";

/// The settings that "set the tolerance" changes, wherever it is asked for: `tolerance` [mm] holds
/// everywhere, in place of the program's own.
inline std::array<std::pair<std::string, SettingValue>, 2> settings_for_tolerance(double tolerance) {
  return {{{contour_tolerance_key, tolerance}, {program_tolerance_key, std::string("off")}}};
}

/// Whether a setting is the tolerance of corners that a program may set too.
inline bool is_tolerance(std::string_view key) {
  return key == contour_tolerance_key || key == blend_tolerance_key;
}

/// Whether the program's own tolerances and blend distances hold, which they do if nothing is set.
inline bool follows_program_tolerance(const Settings& settings) {
  return !settings.has(program_tolerance_key) || settings.text(program_tolerance_key) == "on";
}

}  // namespace feedscope
