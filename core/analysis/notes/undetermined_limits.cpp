#include "core/analysis/notes/undetermined_limits.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string_view>

#include "core/machine/undetermined.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

/// Number that determines a kind of cause: a limit of the cause's axis if it begins with a dot, else a
/// setting.
struct NumberOfCause {
  CauseKind kind;
  std::string_view number;
};
constexpr std::array numbers_of_causes{
    NumberOfCause{CauseKind::rapid, ".velocity"},
    NumberOfCause{CauseKind::axis_velocity, ".velocity"},
    NumberOfCause{CauseKind::blend_velocity, ".velocity"},
    NumberOfCause{CauseKind::axis_acceleration, ".acceleration"},
    NumberOfCause{CauseKind::radial_acceleration, ".acceleration"},
    NumberOfCause{CauseKind::blend_radial_acceleration, ".acceleration"},
    NumberOfCause{CauseKind::blend_tangential_acceleration, ".acceleration"},
    NumberOfCause{CauseKind::axis_jerk, ".jerk"},
    NumberOfCause{CauseKind::radial_jerk, ".jerk"},
    NumberOfCause{CauseKind::curvature_crossing, ".jerk"},
    NumberOfCause{CauseKind::blend_radial_jerk, ".blend_jerk"},
    NumberOfCause{CauseKind::blend_tangential_jerk, ".blend_jerk"},
    NumberOfCause{CauseKind::curvilinear_jerk, "curvilinear_jerk_m_s3"},
    NumberOfCause{CauseKind::contour_tolerance, "contour_tolerance_mm"},
    NumberOfCause{CauseKind::contour_tolerance, "blend_tolerance_mm"},
    NumberOfCause{CauseKind::velocity_filter, "filter_time_s"},
    NumberOfCause{CauseKind::velocity_filter, "filter_jerk_m_s3"},
    NumberOfCause{CauseKind::junction_deviation, "junction_deviation_mm"},
    NumberOfCause{CauseKind::square_corner_velocity, "square_corner_velocity_mm_s"},
    NumberOfCause{CauseKind::cruise_ratio, "minimum_cruise_ratio"},
    NumberOfCause{CauseKind::path_velocity, "max_velocity_m_min"},
    NumberOfCause{CauseKind::path_velocity, "max_linear_velocity_m_min"},
    NumberOfCause{CauseKind::path_acceleration, "max_acceleration_m_s2"}};

/// Undetermined numbers that `setup` uses, with zero time.
std::map<std::string, double, std::less<>> undetermined_numbers(const Setup& setup) {
  std::map<std::string, double, std::less<>> numbers;
  const Settings& of_machine = setup.machine.settings;
  for (const auto& [key, provenance] : setup.machine.provenance) {
    const bool is_changed = of_machine.has(key) && setup.settings.value(key) != of_machine.value(key);
    if (is_undetermined(provenance) && !is_changed) {
      numbers.emplace(key, 0.0);
    }
  }
  return numbers;
}

/// Adds `time` to the numbers that determine `cause`.
void add_time(std::map<std::string, double, std::less<>>& numbers, Cause cause, double time) {
  for (const auto& [kind, number] : numbers_of_causes) {
    const bool of_axis = number.starts_with('.');
    if (kind != cause.kind || (of_axis && cause.axis < 0)) {
      continue;
    }
    std::string key(number);
    if (of_axis) {
      key.insert(key.begin(), cause_axes[static_cast<std::size_t>(cause.axis)].name);
    }
    if (const auto found = numbers.find(key); found != numbers.end()) {
      found->second += time;
    }
  }
}

}  // namespace

std::vector<UndeterminedLimit> undetermined_limits(const Run& run) {
  constexpr double least_share = 1e-3;
  std::map<std::string, double, std::less<>> numbers = undetermined_numbers(run.setup);
  const double cycle = run.trajectory->duration();
  if (numbers.empty() || !(cycle > 0)) {
    return {};
  }
  for (PartWalk walk(*run.trajectory); !walk.done(); walk.next()) {
    const Part& part = walk.part();
    const bool slows = part.cause.kind == CauseKind::ramp_down;
    add_time(numbers, slows ? run.trajectory->slower_place(part.piece) : part.cause, part.duration);
  }
  std::vector<UndeterminedLimit> limits;
  for (const auto& [key, time] : numbers) {
    if (time > least_share * cycle) {
      limits.push_back({key, time, time / cycle});
    }
  }
  std::ranges::stable_sort(limits, std::ranges::greater(), &UndeterminedLimit::time);
  return limits;
}

Message describe(const UndeterminedLimit& limit) {
  return message(NC_("core",
                     "{} limits {:.3g} s of the cycle time ({:.2g} %), but the recordings that the machine "
                     "was identified from do not determine it."),
                 limit.key, limit.time, 100 * limit.share);
}

}  // namespace feedscope
