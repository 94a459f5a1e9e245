#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <vector>

#include "core/analysis/run/source_figures.h"
#include "core/base/units.h"
#include "core/export/csv_field.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

/// For every axis of known_axes; empty values if a machine lacks it.
constexpr std::array<const char*, 6> axis_columns{"v{}_mm_min", "a{}_m_s2",  "j{}_m_s3",
                                                  "v{}_share",  "a{}_share", "j{}_share"};

/// Indices in all_causes() of the causes of any run.
template <typename Runs>
std::vector<std::size_t> causes_of(const Runs& runs) {
  std::vector<std::size_t> causes;
  for (std::size_t i = 0; i < all_causes().size(); ++i) {
    for (const ComparedRun& run : runs) {
      if (run.summary.time_by_cause[i] > 0) {
        causes.push_back(i);
        break;
      }
    }
  }
  return causes;
}

constexpr std::size_t name_columns = 3;  // machine, model and tolerance before the figures

std::vector<std::string> header(const std::vector<std::size_t>& causes) {
  std::vector<std::string> row{"machine",
                               "model",
                               "tolerance_mm",
                               "cycle_time_s",
                               "programmed_time_s",
                               "against_cam",
                               "mean_feed_mm_min",
                               "peak_feed_mm_min",
                               "max_contour_error_mm",
                               "blends",
                               "tolerance_min_mm",
                               "tolerance_max_mm",
                               "tolerance_set_by",
                               "max_contour_error_cutting_mm"};
  for (const AxisInfo& info : known_axes) {
    const char axis = static_cast<char>(std::tolower(info.name));
    for (const char* column : axis_columns) {
      row.push_back(fmt::format(fmt::runtime(column), axis));
    }
  }
  for (const std::size_t cause : causes) {
    row.push_back(fmt::format("time_{}_s", cause_key(all_causes()[cause])));
  }
  return row;
}

/// Row of a run, without figures if the control refuses the program.
std::vector<std::string> row_of(const ComparedRun& run, const std::vector<std::size_t>& causes) {
  const Summary& summary = run.summary;
  const std::optional<ToleranceInForce>& tolerance = run.tolerance;
  std::vector<std::string> row{csv_field(run.setup.machine.id),
                               run.setup.model->info().id,
                               tolerance && !tolerance->is_range() ? csv_number(tolerance->max) : "",
                               csv_number(summary.cycle_time),
                               csv_number(summary.programmed_time),
                               csv_number(run.against_cam()),
                               csv_number(units::to_mm_min(summary.mean_feed)),
                               csv_number(units::to_mm_min(summary.peak_feed)),
                               csv_number(rounded_error(summary.max_contour_error)),
                               fmt::format("{}", run.blends),
                               tolerance ? csv_number(tolerance->min) : "",
                               tolerance ? csv_number(tolerance->max) : "",
                               std::string(tolerance ? to_string(tolerance->set_by) : ""),
                               csv_number(rounded_error(summary.cutting_contour_error))};
  for (const AxisInfo& axis : known_axes) {
    const AxisPeaks* const found = summary.axes.find(axis.name);
    if (found == nullptr) {
      row.insert(row.end(), axis_columns.size(), "");
      continue;
    }
    const AxisPeaks& peak = *found;
    const AxisLimits& limit = *run.setup.machine.axes.find(axis.name);
    row.push_back(csv_number(units::to_mm_min(peak.velocity)));
    row.push_back(csv_number(units::to_m(peak.acceleration)));
    row.push_back(csv_number(units::to_m(peak.jerk)));
    row.push_back(csv_number(peak.velocity / limit.velocity));
    row.push_back(csv_number(peak.acceleration / limit.acceleration));
    row.push_back(csv_number(peak.jerk / limit.jerk));
  }
  for (const std::size_t cause : causes) {
    row.push_back(csv_number(summary.time_by_cause[cause]));
  }
  if (!run.is_possible()) {
    const std::vector<std::string> titles = header(causes);
    for (std::size_t column = name_columns; column < row.size(); ++column) {
      row[column] = titles[column].starts_with("tolerance_") ? row[column] : "";
    }
  }
  return row;
}

std::vector<std::string> study_columns(const Study& study) {
  std::vector<std::string> columns;
  for (const Sweep& sweep : study.sweeps) {
    columns.push_back(csv_field("setting_" + sweep.key));
  }
  for (const char* name : {"within_bound", "fastest", "limiting_cause", "limiting_share"}) {
    columns.emplace_back(name);
  }
  if (!study.operations.empty()) {
    for (const char* name : {"operation", "operation_line", "cutting_length_mm"}) {
      columns.emplace_back(name);
    }
  }
  return columns;
}

std::string bound_text(std::optional<double> within, double error) {
  constexpr double rounding = 1e-9;  // mm
  return within ? (error <= *within + rounding ? "1" : "0") : "";
}

/// Columns of study_columns() up to the operations.
std::vector<std::string> study_cells(const Study& study, const StudyRun& run, bool is_fastest) {
  std::vector<std::string> cells;
  for (const double value : run.swept) {
    cells.push_back(csv_number(value));
  }
  cells.push_back(run.is_possible() ? bound_text(study.within, run.summary.cutting_contour_error) : "");
  cells.emplace_back(is_fastest ? "1" : "0");
  const std::vector<CauseShare> causes =
      run.out_of_reach ? std::vector<CauseShare>() : limiting_causes(run.summary);
  cells.push_back(causes.empty() ? "" : cause_key(causes.front().cause));
  cells.push_back(causes.empty() ? "" : csv_number(causes.front().share));
  return cells;
}

/// Row of one operation, based on that of its run.
std::vector<std::string> operation_row(const Study& study, const StudyRun& run, std::size_t i,
                                       const std::vector<std::string>& titles, std::vector<std::string> row) {
  const Operation& operation = study.operations[i];
  const OperationFigures& figures = run.operations[i];
  const auto put = [&](const std::string& title, std::string text) {
    row[static_cast<std::size_t>(std::ranges::find(titles, title) - titles.begin())] = std::move(text);
  };
  for (std::size_t column = name_columns; column < row.size(); ++column) {
    const std::string& title = titles[column];
    if (!title.starts_with("setting_") && title != "fastest") {
      row[column].clear();
    }
  }
  put("cycle_time_s", csv_number(figures.time));
  put("mean_feed_mm_min", csv_number(units::to_mm_min(figures.mean_feed())));
  put("max_contour_error_mm", csv_number(rounded_error(figures.contour_error)));
  put("within_bound", bound_text(study.within, figures.cutting_contour_error));
  put("limiting_cause", cause_key(figures.cause));
  put("limiting_share", figures.time > 0 ? csv_number(figures.cause_time / figures.time) : "");
  put("operation", csv_field(operation.title));
  put("operation_line", fmt::format("{}", operation.line));
  put("cutting_length_mm", csv_number(figures.cutting_length));
  return row;
}

void append(std::vector<std::string>& row, std::vector<std::string> more) {
  std::ranges::move(more, std::back_inserter(row));
}

using Figures = std::vector<const SourceFigure*>;

template <typename Runs>
Figures figures_of(const Runs& runs) {
  return source_figures_of(runs, [](const ComparedRun& run) { return &run.summary; });
}

std::vector<std::string> columns_of(const Figures& figures) {
  std::vector<std::string> columns;
  for (const SourceFigure* figure : figures) {
    columns.emplace_back(figure->column);
  }
  return columns;
}

std::vector<std::string> cells_of(const Figures& figures, const Summary& summary) {
  std::vector<std::string> cells;
  for (const SourceFigure* figure : figures) {
    const std::optional<double> value = figure->of(summary);
    cells.push_back(value ? csv_number(*value) : "");
  }
  return cells;
}

}  // namespace

std::string comparison_csv(std::span<const ComparedRun> runs, std::span<const std::string> names) {
  const std::vector<std::size_t> causes = causes_of(runs);
  const Figures figures = figures_of(runs);
  std::vector<std::string> titles = header(causes);
  append(titles, columns_of(figures));
  if (!names.empty()) {
    titles.emplace_back("run");
  }
  std::string text = fmt::format("{}\n", fmt::join(titles, ","));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::string> row = row_of(runs[i], causes);
    append(row, cells_of(figures, runs[i].summary));
    if (!names.empty()) {
      row.push_back(csv_field(names[i]));
    }
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

std::string study_csv(const Study& study) {
  const std::vector<std::size_t> causes = causes_of(study.runs);
  std::vector<std::string> titles = header(causes);
  append(titles, study_columns(study));
  const std::size_t own = titles.size();
  const Figures figures = figures_of(study.runs);
  append(titles, columns_of(figures));
  std::string text = fmt::format("{}\n", fmt::join(titles, ","));
  for (const auto& curve : study.curves()) {
    const std::vector<bool> marks = fastest_marks(curve, study.within);
    for (std::size_t at = 0; at < curve.size(); ++at) {
      const StudyRun& run = curve[at];
      std::vector<std::string> row = row_of(run, causes);
      append(row, study_cells(study, run, marks[at]));
      row.resize(own);
      append(row, cells_of(figures, run.summary));
      text += fmt::format("{}\n", fmt::join(row, ","));
      for (std::size_t i = 0; i < run.operations.size(); ++i) {
        text += fmt::format("{}\n", fmt::join(operation_row(study, run, i, titles, row), ","));
      }
    }
  }
  return text;
}

}  // namespace feedscope
