#include "core/analysis/run/source_figures.h"

#include <array>

#include "core/base/translatable.h"

namespace feedscope {
namespace {

std::optional<double> actual_contour_error(const Summary& summary) {
  return summary.actual ? std::optional(summary.actual->worst.error) : std::nullopt;
}

std::optional<double> peak_force(const Summary& summary) {
  const bool cuts = summary.load && summary.load->all.cutting_time > 0;
  return cuts ? std::optional(figure_of(summary.load->all.predicted, QuantityId::peak_force).largest)
              : std::nullopt;
}

/// None if no operation has a least chip thickness.
std::optional<double> rubbing_time(const Summary& summary) {
  if (summary.load) {
    for (const LimitFigures& limit : summary.load->limits) {
      if (limit.limit == LoadLimit::least_chip) {
        return limit.time;
      }
    }
  }
  return std::nullopt;
}

constexpr std::array<SourceFigure, 3> figures{{
    {"max_actual_contour_error_mm", QT_TRANSLATE_NOOP("core", "Actual error"),
     QT_TRANSLATE_NOOP("core", "Largest distance of the actual path from the programmed one"),
     Dimension::error, actual_contour_error},
    {"max_cutting_force_n", QT_TRANSLATE_NOOP("core", "Peak force"),
     QT_TRANSLATE_NOOP("core", "Largest peak cutting force"), Dimension::force, peak_force},
    {"rubbing_time_s", QT_TRANSLATE_NOOP("core", "Rubbing"),
     QT_TRANSLATE_NOOP("core", "Time with chips below their least thickness"), Dimension::time, rubbing_time},
}};

}  // namespace

std::span<const SourceFigure> source_figures() {
  return figures;
}

}  // namespace feedscope
