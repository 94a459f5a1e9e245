#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <vector>

#include "core/base/units.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

std::string number(double value) {
  return fmt::format("{:.11g}", value + 0.0);
}

/// Quoted where a comma, a quote or a line end would break the row.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') {
      quoted += c;
    }
  }
  return quoted + '"';
}

/// Positions in all_causes() of the causes that any of the runs has.
std::vector<std::size_t> causes_of(std::span<const ComparedRun> runs) {
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
                               "blends"};
  for (const char name : axis_names) {
    const char axis = static_cast<char>(std::tolower(name));
    for (const char* column : {"v{}_mm_min", "a{}_m_s2", "j{}_m_s3", "v{}_share", "a{}_share", "j{}_share"}) {
      row.push_back(fmt::format(fmt::runtime(column), axis));
    }
  }
  for (const std::size_t cause : causes) {
    row.push_back(fmt::format("time_{}_s", cause_key(all_causes()[cause])));
  }
  return row;
}

std::vector<std::string> row_of(const ComparedRun& run, const std::vector<std::size_t>& causes) {
  const Summary& summary = run.summary;
  const std::optional<double> tolerance = contour_tolerance(run.setup);
  std::vector<std::string> row{field(run.setup.machine.id),
                               run.setup.model->info().id,
                               tolerance ? number(*tolerance) : "",
                               number(summary.cycle_time),
                               number(summary.programmed_time),
                               number(run.against_cam()),
                               number(units::to_mm_min(summary.mean_feed)),
                               number(units::to_mm_min(summary.peak_feed)),
                               number(summary.max_contour_error),
                               fmt::format("{}", run.blends)};
  for (std::size_t i = 0; i < summary.axes.size(); ++i) {
    const AxisPeaks& peak = summary.axes[i];
    const AxisLimits& limit = run.setup.machine.axes[i];
    row.push_back(number(units::to_mm_min(peak.velocity)));
    row.push_back(number(units::to_m(peak.acceleration)));
    row.push_back(number(units::to_m(peak.jerk)));
    row.push_back(number(peak.velocity / limit.velocity));
    row.push_back(number(peak.acceleration / limit.acceleration));
    row.push_back(number(peak.jerk / limit.jerk));
  }
  for (const std::size_t cause : causes) {
    row.push_back(number(summary.time_by_cause[cause]));
  }
  return row;
}

}  // namespace

std::string comparison_csv(std::span<const ComparedRun> runs) {
  const std::vector<std::size_t> causes = causes_of(runs);
  std::string text = fmt::format("{}\n", fmt::join(header(causes), ","));
  for (const ComparedRun& run : runs) {
    text += fmt::format("{}\n", fmt::join(row_of(run, causes), ","));
  }
  return text;
}

}  // namespace feedscope
