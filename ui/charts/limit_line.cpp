#include "ui/charts/limit_line.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/analysis/load/limit_tracker.h"

namespace feedscope::ui {
namespace {

struct LimitLines {
  Q_DECLARE_TR_FUNCTIONS(LimitLines)
};

}  // namespace

std::vector<LimitLine> limit_lines(const ChartSpec& spec, const AxisVector<AxisLimits>& limits,
                                   double AxisLimits::*kind) {
  std::vector<LimitLine> lines;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double value = spec.convert(limits[i].*kind);
    const QString axis(QChar(limits.name(i)));
    if (!lines.empty() && lines.back().value == value) {
      lines.back().label += ' ' + axis;
      lines.back().axis.reset();
    } else {
      lines.push_back({value, axis, i});
    }
  }
  for (LimitLine& line : lines) {
    line.label = LimitLines::tr("limit of %1").arg(line.label);
  }
  return lines;
}

std::vector<LimitLine> bound_lines(const ChartSpec& spec, const RunLoad& load) {
  std::vector<LimitLine> lines;
  for (std::size_t i = 0; i < load_limit_count; ++i) {
    const auto limit = static_cast<LoadLimit>(i);
    const QuantityId id = load_quantities()[quantity_of(limit)].id;
    if (std::ranges::find(spec.curves, id, &CurveSpec::quantity) == spec.curves.end()) {
      continue;
    }
    for (const LoadedOperation& operation : load.model().operations()) {
      const std::optional<double> bound = bound_of(limit, operation.operation);
      const double value = bound ? spec.convert(*bound) : 0;
      const QString label =
          limit == LoadLimit::least_chip ? LimitLines::tr("least chip") : LimitLines::tr("bound");
      if (bound && std::ranges::find(lines, value, &LimitLine::value) == lines.end()) {
        lines.push_back({value, label, std::nullopt});
      }
    }
  }
  return lines;
}

}  // namespace feedscope::ui
