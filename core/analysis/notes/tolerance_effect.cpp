#include "core/analysis/notes/tolerance_effect.h"

#include <algorithm>

namespace feedscope {
namespace {

bool are_alike(const ComparedRun& a, const ComparedRun& b) {
  return a.setup.model == b.setup.model && a.setup.machine.id == b.setup.machine.id;
}

}  // namespace

bool is_by_blends(const SlowerTolerance& slower) {
  return slower.cause.kind >= CauseKind::blend_velocity &&
         slower.cause.kind <= CauseKind::blend_tangential_jerk;
}

std::string why_slower(const SlowerTolerance& slower) {
  return is_by_blends(slower) ? why_slower_with_wider_tolerance : "";
}

bool tolerances_without_effect(std::span<const ComparedRun> runs) {
  bool compared = false;
  for (const ComparedRun& one : runs) {
    const ComparedRun& first =
        *std::ranges::find_if(runs, [&](const ComparedRun& run) { return are_alike(run, one); });
    if (one.blends > 0 || !one.is_possible() || one.summary.cycle_time != first.summary.cycle_time) {
      return false;
    }
    compared = compared || contour_tolerance(one.setup) != contour_tolerance(first.setup);
  }
  return compared;
}

}  // namespace feedscope
