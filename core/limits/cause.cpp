#include "core/limits/cause.h"

#include <fmt/format.h>

#include <array>

#include "core/base/geometry.h"
#include "core/base/translatable.h"
#include "core/machine/axis_vector.h"

namespace feedscope {
namespace {

/// In the order of CauseKind. Any two colours differ by at least 15 in CIELAB
/// (tests/ui/scene/cause_colour_test).
constexpr std::array kinds{
    CauseInfo{CauseKind::programmed_feed, "programmed_feed", QT_TRANSLATE_NOOP("core", "programmed feed"), "",
              0xc3cad2, 0xcdc7d0},
    CauseInfo{CauseKind::rapid, "rapid", QT_TRANSLATE_NOOP("core", "rapid traverse"), "", 0xba75ab, 0xd190c1},
    CauseInfo{CauseKind::axis_velocity, "axis_velocity", QT_TRANSLATE_NOOP("core", "axis velocity"),
              QT_TRANSLATE_NOOP("core", "velocity of axis %1"), 0x56b4e9, 0x74c5ff},
    CauseInfo{CauseKind::axis_acceleration, "axis_acceleration",
              QT_TRANSLATE_NOOP("core", "axis acceleration"),
              QT_TRANSLATE_NOOP("core", "acceleration of axis %1"), 0x0072b2, 0x559adc},
    CauseInfo{CauseKind::axis_jerk, "axis_jerk", QT_TRANSLATE_NOOP("core", "axis jerk"),
              QT_TRANSLATE_NOOP("core", "jerk of axis %1"), 0xd55e00, 0xff8022},
    CauseInfo{CauseKind::radial_acceleration, "radial_acceleration",
              QT_TRANSLATE_NOOP("core", "radial acceleration"),
              QT_TRANSLATE_NOOP("core", "radial acceleration of axis %1"), 0x283aa6, 0x6965cb},
    CauseInfo{CauseKind::radial_jerk, "radial_jerk", QT_TRANSLATE_NOOP("core", "radial jerk"),
              QT_TRANSLATE_NOOP("core", "radial jerk of axis %1"), 0x902b02, 0xed9d76},
    CauseInfo{CauseKind::blend_velocity, "blend_velocity", QT_TRANSLATE_NOOP("core", "velocity on a blend"),
              QT_TRANSLATE_NOOP("core", "velocity of axis %1 on a blend"), 0x9d7cee, 0x918cff},
    CauseInfo{CauseKind::blend_radial_acceleration, "blend_radial_acceleration",
              QT_TRANSLATE_NOOP("core", "radial acceleration on a blend"),
              QT_TRANSLATE_NOOP("core", "radial acceleration of axis %1 on a blend"), 0x400072, 0x6933c5},
    CauseInfo{CauseKind::blend_radial_jerk, "blend_radial_jerk",
              QT_TRANSLATE_NOOP("core", "radial jerk on a blend"),
              QT_TRANSLATE_NOOP("core", "radial jerk of axis %1 on a blend"), 0xff8297, 0xea5273},
    CauseInfo{CauseKind::blend_tangential_acceleration, "blend_tangential_acceleration",
              QT_TRANSLATE_NOOP("core", "tangential acceleration on a blend"),
              QT_TRANSLATE_NOOP("core", "tangential acceleration of axis %1 on a blend"), 0x93df74, 0xb1ff8b},
    CauseInfo{CauseKind::blend_tangential_jerk, "blend_tangential_jerk",
              QT_TRANSLATE_NOOP("core", "tangential jerk on a blend"),
              QT_TRANSLATE_NOOP("core", "tangential jerk of axis %1 on a blend"), 0x570f00, 0x904331},
    CauseInfo{CauseKind::curvilinear_jerk, "curvilinear_jerk", QT_TRANSLATE_NOOP("core", "curvilinear jerk"),
              "", 0x7ba655, 0xe3ffb8},
    CauseInfo{CauseKind::curvature_crossing, "curvature_crossing",
              QT_TRANSLATE_NOOP("core", "jerk at a change of curvature"),
              QT_TRANSLATE_NOOP("core", "jerk of axis %1 at a change of curvature"), 0x4a0352, 0x78407b},
    CauseInfo{CauseKind::interpolation_period, "interpolation_period",
              QT_TRANSLATE_NOOP("core", "interpolation period"), "", 0x5b7339, 0x798d43},
    CauseInfo{CauseKind::block_time, "block_time", QT_TRANSLATE_NOOP("core", "block time"), "", 0x8e2bed,
              0x8d5ef2},
    CauseInfo{CauseKind::contour_tolerance, "contour_tolerance",
              QT_TRANSLATE_NOOP("core", "contour tolerance"), "", 0x009e73, 0x008c65},
    CauseInfo{CauseKind::lookahead_horizon, "lookahead_horizon",
              QT_TRANSLATE_NOOP("core", "look-ahead horizon"), "", 0x145536, 0x95ffd3},
    CauseInfo{CauseKind::velocity_filter, "velocity_filter", QT_TRANSLATE_NOOP("core", "velocity filters"),
              "", 0x6cfca8, 0x5cc93f},
    CauseInfo{CauseKind::junction_deviation, "junction_deviation",
              QT_TRANSLATE_NOOP("core", "junction deviation"), "", 0x786973, 0x5d505e},
    CauseInfo{CauseKind::square_corner_velocity, "square_corner_velocity",
              QT_TRANSLATE_NOOP("core", "square corner velocity"), "", 0xa9078a, 0xa9180b},
    CauseInfo{CauseKind::cruise_ratio, "cruise_ratio", QT_TRANSLATE_NOOP("core", "minimum cruise ratio"), "",
              0xb652ff, 0x90189d},
    CauseInfo{CauseKind::kink, "kink", QT_TRANSLATE_NOOP("core", "kink between blocks"), "", 0xc7ff65,
              0x5700fa},
    CauseInfo{CauseKind::path_velocity, "path_velocity", QT_TRANSLATE_NOOP("core", "velocity along the path"),
              "", 0x000000, 0x49fa54},
    CauseInfo{CauseKind::path_acceleration, "path_acceleration",
              QT_TRANSLATE_NOOP("core", "acceleration along the path"), "", 0xbab043, 0xd8baa2},
    CauseInfo{CauseKind::ramp_down, "ramp_down",
              QT_TRANSLATE_NOOP("core", "braking for a slower place ahead"), "", 0xf0b429, 0xa86e01},
    CauseInfo{CauseKind::exact_stop, "exact_stop", QT_TRANSLATE_NOOP("core", "exact stop"), "", 0x262b2e,
              0xa99e9d},
    CauseInfo{CauseKind::dwell, "dwell", QT_TRANSLATE_NOOP("core", "dwell"), "", 0x5e425d, 0x8a6d8b},
    CauseInfo{CauseKind::tool_change, "tool_change", QT_TRANSLATE_NOOP("core", "tool change"), "", 0x1400f8,
              0x9932ff},
    CauseInfo{CauseKind::spindle_start, "spindle_start", QT_TRANSLATE_NOOP("core", "spindle start"), "",
              0xf0f800, 0xfffa00},
    CauseInfo{CauseKind::indexing, "indexing", QT_TRANSLATE_NOOP("core", "indexing of rotary axes"),
              QT_TRANSLATE_NOOP("core", "indexing of axis %1"), 0x230028, 0xb05bb0},
    CauseInfo{CauseKind::swing, "swing", QT_TRANSLATE_NOOP("core", "swing about the tip"),
              QT_TRANSLATE_NOOP("core", "swing about the tip, held by axis %1"), 0xa6ffd7, 0xbedafc},
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

/// Axes that can set a cause: first of cause_axes, and their number.
struct AxisRange {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Whether rotary axes can also set it.
constexpr bool turns_too(CauseKind kind) {
  return kind == CauseKind::axis_velocity || kind == CauseKind::axis_acceleration ||
         kind == CauseKind::axis_jerk || kind == CauseKind::swing;
}

constexpr AxisRange axes_of(const CauseInfo& info) {
  constexpr std::size_t linear = known_axes.size();
  return !info.by_axis()                    ? AxisRange{}
         : info.kind == CauseKind::indexing ? AxisRange{linear, cause_axes.size() - linear}
         : turns_too(info.kind)             ? AxisRange{0, cause_axes.size()}
                                            : AxisRange{0, linear};
}

/// Index in all_causes() of each kind without axis; those with an axis follow.
constexpr std::array<std::size_t, kinds.size()> first_indices() {
  std::array<std::size_t, kinds.size()> first{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    first[i] = next;
    next += 1 + axes_of(kinds[i]).count;
  }
  return first;
}

bool has_axis(Cause cause) {
  return info_of(cause.kind).by_axis() && cause.axis >= 0;
}

std::vector<Cause> list_causes() {
  std::vector<Cause> causes;
  for (const CauseInfo& info : kinds) {
    causes.push_back({info.kind, -1});
    const AxisRange axes = axes_of(info);
    for (std::size_t axis = axes.first; axis < axes.first + axes.count; ++axis) {
      causes.push_back({info.kind, static_cast<std::int8_t>(axis)});
    }
  }
  return causes;
}

}  // namespace

char axis_name(Cause cause) {
  return cause.axis < 0 ? ' ' : cause_axes[static_cast<std::size_t>(cause.axis)].name;
}

const CauseInfo& info_of(CauseKind kind) {
  return kinds[static_cast<std::size_t>(kind)];
}

std::string cause_key(Cause cause) {
  const std::string_view key = info_of(cause.kind).key;
  return has_axis(cause) ? fmt::format("{}_{}", key, static_cast<char>(axis_name(cause) - 'X' + 'x'))
                         : std::string(key);
}

std::string cause_title(Cause cause) {
  if (!has_axis(cause)) {
    return std::string(info_of(cause.kind).title);
  }
  std::string title(info_of(cause.kind).axis_title);
  return title.replace(title.find("%1"), 2, 1, axis_name(cause));
}

const std::vector<Cause>& all_causes() {
  static const std::vector<Cause> causes = list_causes();
  return causes;
}

std::size_t cause_index(Cause cause) {
  static constexpr auto first = first_indices();
  const auto kind = static_cast<std::size_t>(cause.kind);
  return first[kind] +
         (has_axis(cause) ? static_cast<std::size_t>(cause.axis) - axes_of(kinds[kind]).first + 1 : 0);
}

}  // namespace feedscope
