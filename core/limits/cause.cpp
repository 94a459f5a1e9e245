#include "core/limits/cause.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "core/base/geometry.h"

namespace feedscope {
namespace {

struct KindText {
  CauseKind kind;
  bool by_axis;  ///< one axis may set it
  std::string_view key;
  std::string_view title;
  std::string_view title_end;  ///< behind the axis
};

/// In the order of CauseKind.
constexpr std::array kinds{
    KindText{CauseKind::programmed_feed, false, "programmed_feed", "programmed feed", ""},
    KindText{CauseKind::rapid, false, "rapid", "rapid traverse", ""},
    KindText{CauseKind::axis_velocity, true, "axis_velocity", "velocity", ""},
    KindText{CauseKind::axis_acceleration, true, "axis_acceleration", "acceleration", ""},
    KindText{CauseKind::axis_jerk, true, "axis_jerk", "jerk", ""},
    KindText{CauseKind::radial_acceleration, true, "radial_acceleration", "radial acceleration", ""},
    KindText{CauseKind::radial_jerk, true, "radial_jerk", "radial jerk", ""},
    KindText{CauseKind::blend_velocity, true, "blend_velocity", "velocity", " on a blend"},
    KindText{CauseKind::blend_radial_acceleration, true, "blend_radial_acceleration", "radial acceleration",
             " on a blend"},
    KindText{CauseKind::blend_radial_jerk, true, "blend_radial_jerk", "radial jerk", " on a blend"},
    KindText{CauseKind::blend_tangential_acceleration, true, "blend_tangential_acceleration",
             "tangential acceleration", " on a blend"},
    KindText{CauseKind::blend_tangential_jerk, true, "blend_tangential_jerk", "tangential jerk",
             " on a blend"},
    KindText{CauseKind::curvilinear_jerk, false, "curvilinear_jerk", "curvilinear jerk", ""},
    KindText{CauseKind::curvature_crossing, true, "curvature_crossing", "jerk", " at a change of curvature"},
    KindText{CauseKind::interpolation_period, false, "interpolation_period", "interpolation period", ""},
    KindText{CauseKind::contour_tolerance, false, "contour_tolerance", "contour tolerance", ""},
    KindText{CauseKind::lookahead_horizon, false, "lookahead_horizon", "look-ahead horizon", ""},
    KindText{CauseKind::ramp_down, false, "ramp_down", "slowing for what follows", ""},
    KindText{CauseKind::exact_stop, false, "exact_stop", "exact stop", ""},
    KindText{CauseKind::dwell, false, "dwell", "dwell", ""},
    KindText{CauseKind::tool_change, false, "tool_change", "tool change", ""},
    KindText{CauseKind::spindle_start, false, "spindle_start", "spindle start", ""},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (static_cast<std::size_t>(kinds[i].kind) != i) {
      return false;
    }
  }
  return kinds.size() == cause_kind_count;
}
static_assert(in_order());

/// Index in all_causes() of each kind without axis; its axes follow.
constexpr std::array<std::size_t, kinds.size()> first_indices() {
  std::array<std::size_t, kinds.size()> first{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    first[i] = next;
    next += kinds[i].by_axis ? 1 + axis_names.size() : 1;
  }
  return first;
}

const KindText& text_of(Cause cause) {
  return kinds[static_cast<std::size_t>(cause.kind)];
}

bool has_axis(Cause cause) {
  return text_of(cause).by_axis && cause.axis >= 0;
}

char axis_name(Cause cause) {
  return axis_names[static_cast<std::size_t>(cause.axis)];
}

std::vector<Cause> list_causes() {
  std::vector<Cause> causes;
  for (const KindText& text : kinds) {
    causes.push_back({text.kind, -1});
    for (std::int8_t axis = 0; text.by_axis && axis < 3; ++axis) {
      causes.push_back({text.kind, axis});
    }
  }
  return causes;
}

}  // namespace

std::string cause_key(Cause cause) {
  return has_axis(cause)
             ? fmt::format("{}_{}", text_of(cause).key, static_cast<char>(axis_name(cause) - 'X' + 'x'))
             : std::string(text_of(cause).key);
}

std::string cause_title(Cause cause) {
  const KindText& text = text_of(cause);
  const std::string axis = has_axis(cause) ? fmt::format(" of axis {}", axis_name(cause)) : "";
  return fmt::format("{}{}{}", text.title, axis, text.title_end);
}

const std::vector<Cause>& all_causes() {
  static const std::vector<Cause> causes = list_causes();
  return causes;
}

std::size_t cause_index(Cause cause) {
  static constexpr auto first = first_indices();
  const auto kind = static_cast<std::size_t>(cause.kind);
  return first[kind] + (has_axis(cause) ? static_cast<std::size_t>(cause.axis) + 1 : 0);
}

}  // namespace feedscope
