#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/analysis/time/time_report.h"

namespace feedscope::ui {

/// A row and its target: a place, a change, or none.
struct TimeRow {
  std::array<QString, 3> cells;
  QString tip;
  double share = 0;                ///< bar under the cells, 0 to 1
  std::optional<SlowPlace> place;  ///< target
  std::optional<double> time;      ///< target [s]
  std::optional<Remedy> remedy;    ///< change for a new run
  std::vector<TimeRow> rows = {};  ///< child rows
};

/// The rows under one heading, whose cells name the columns.
struct TimeSection {
  std::array<QString, 3> heading;
  std::vector<TimeRow> rows;
};

/// Contents of the panel for a report on a run, the most important section first. Without changes until some
/// are tried.
std::vector<TimeSection> time_sections(const TimeReport& report, const Run& run);

}  // namespace feedscope::ui
