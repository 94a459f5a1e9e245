#include "core/analysis/explanation/stop_reason.h"

#include "core/blend/path_rules.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {

StopReason stop_reason(const Run& run, const State& state) {
  const Settings& settings = run.setup.settings;
  const BlendedPath& path = run.trajectory->path();
  if (path.empty() || path.programmed() == nullptr) {
    return StopReason::unknown;
  }
  const std::uint32_t element = state.element;
  const bool at_start = state.path_length - path.s(element) < path.length(element) / 2;
  if (at_start ? element == 0 : element + std::size_t{1} == path.size()) {
    return StopReason::end;
  }
  const std::size_t before = path.segment(at_start ? element - 1 : element);
  const std::size_t behind = path.segment(at_start ? element : element + 1);
  const Toolpath& toolpath = *path.programmed();
  const Segment& a = toolpath.segments[before];
  const Segment& b = toolpath.segments[behind];
  if (before == behind || a.kind == SegmentKind::dwell || b.kind == SegmentKind::dwell) {
    return StopReason::unknown;
  }
  if (a.rapid || b.rapid) {
    const bool always = run.setup.model->guarantees(settings).stops_at_rapids;
    return always ? StopReason::rapid : StopReason::unknown;
  }
  const bool has_tolerance = settings.has(contour_tolerance_key);
  return has_tolerance && PathRules(toolpath, settings).corner_tolerance(before) == 0 ? StopReason::tolerance
                                                                                      : StopReason::unknown;
}

}  // namespace feedscope
