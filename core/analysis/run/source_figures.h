#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/analysis/run/summary.h"
#include "core/base/dimension.h"

namespace feedscope {

/// A figure that only runs with drives or with a cutting load have, for comparisons and studies.
struct SourceFigure {
  std::string_view column;   ///< of CSV, with its internal unit
  std::string_view title;    ///< English, marked for translation: "Actual error"
  std::string_view meaning;  ///< the figure in a sentence
  Dimension dimension = Dimension::number;
  std::optional<double> (*of)(const Summary&) = nullptr;  ///< in internal units
};

std::span<const SourceFigure> source_figures();

/// Figures that any of `runs` has; `summary_of` returns null for a run without a summary.
template <typename Runs, typename SummaryOf>
std::vector<const SourceFigure*> source_figures_of(const Runs& runs, SummaryOf summary_of) {
  std::vector<const SourceFigure*> figures;
  for (const SourceFigure& figure : source_figures()) {
    for (const auto& run : runs) {
      const Summary* summary = summary_of(run);
      if (summary != nullptr && figure.of(*summary)) {
        figures.push_back(&figure);
        break;
      }
    }
  }
  return figures;
}

}  // namespace feedscope
