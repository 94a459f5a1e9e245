#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/machine/settings.h"

namespace feedscope {

/// Setting of the contour tolerance [mm].
inline constexpr const char* contour_tolerance_key = "contour_tolerance_mm";
/// The corresponding setting of `linuxcnc`: P of its G64 [mm].
inline constexpr const char* blend_tolerance_key = "blend_tolerance_mm";
/// Smallest contour tolerance and blend distance above 0 [mm], far below the resolution of any control: with
/// smaller ones rounding would decide where a blend begins.
inline constexpr double least_tolerance = 1e-6;
/// Setting that merges collinear blocks: largest distance of their points from the merged block [mm]; without
/// it none are merged.
inline constexpr const char* merge_collinear_key = "merge_collinear_mm";
/// Setting for precedence of the program's own tolerances and blend distances: "on", "off".
inline constexpr const char* program_tolerance_key = "program_tolerance";

/// Settings that a change of the tolerance sets, wherever it is requested: `tolerance` [mm] applies
/// everywhere, in place of the program's own.
inline std::array<std::pair<std::string, SettingValue>, 2> settings_for_tolerance(double tolerance) {
  return {{{contour_tolerance_key, tolerance}, {program_tolerance_key, std::string("off")}}};
}

/// Whether a setting is a tolerance of corners that a program may also set.
inline bool is_tolerance(std::string_view key) {
  return key == contour_tolerance_key || key == blend_tolerance_key;
}

/// Whether the program's own tolerances and blend distances apply, which is the default.
inline bool follows_program_tolerance(const Settings& settings) {
  return !settings.has(program_tolerance_key) || settings.text(program_tolerance_key) == "on";
}

}  // namespace feedscope
