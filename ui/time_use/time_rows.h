#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "core/analysis/time_use/time_report.h"

namespace feedscope::ui {

/// What a row leads to: a place, a change, or nothing.
struct TimeRow {
  std::array<QString, 3> cells;
  QString tip;
  double share = 0;                ///< bar behind the cells, 0 to 1
  std::optional<SlowPlace> place;  ///< to go to
  std::optional<double> time;      ///< to go to [s]
  std::optional<Remedy> remedy;    ///< to make a run of
  std::vector<TimeRow> rows = {};  ///< below it
};

/// The rows under one heading, whose cells name the columns.
struct TimeSection {
  std::array<QString, 3> heading;
  std::vector<TimeRow> rows;
};

/// What the panel lists of a report on a run, the most important section first. Without changes while none
/// have been tried.
std::vector<TimeSection> time_sections(const TimeReport& report, const Run& run);

}  // namespace feedscope::ui
