#include "app/comparison_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "app/print.h"
#include "app/run_remarks.h"
#include "core/analysis/notes/slower_tolerance.h"
#include "core/analysis/notes/tolerance_effect.h"
#include "core/analysis/run/source_figures.h"
#include "core/base/clock_text.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr std::size_t causes_width = 92;  // leaves room for model and tolerance in a line of 120
constexpr double shown_share = 0.005;     // of the cycle time; less would read 0 %

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f}", 100 * share) : "-";
}

/// "40 % braking for a slower place ahead, 35 % jerk of axis X, ...", the largest first, in lines that fit.
std::vector<std::string> causes_text(const Summary& summary) {
  const std::vector<double>& times = summary.time_by_cause;
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t cause) { return times[cause]; });
  std::vector<std::string> lines{""};
  for (const std::size_t cause : order) {
    if (!(times[cause] > shown_share * summary.cycle_time)) {
      break;
    }
    const std::string part =
        fmt::format("{} % {}", percent(times[cause] / summary.cycle_time), cause_title(all_causes()[cause]));
    if (lines.back().empty()) {
      lines.back() = part;
    } else if (lines.back().size() + part.size() + 3 > causes_width) {
      lines.back() += ',';
      lines.push_back(part);
    } else {
      lines.back() += ", " + part;
    }
  }
  return lines;
}

using Cells = std::vector<std::string>;

/// A table with the name of a run before its cells and the machine above its runs.
class RunTable {
 public:
  void add_head(Cells cells) { add({"model", "tolerance"}, std::move(cells)); }
  void add_units(Cells cells) { add({"", "[mm]"}, std::move(cells)); }

  void add_run(const ComparedRun& run, Cells cells) {
    const Machine& machine = run.setup.machine;
    if (machine_ != machine.id) {
      machine_ = machine.id;
      table_.add_heading(fmt::format("{} ({})", machine.name, machine.id));
    }
    add({run.setup.model->info().id, range_text(run.tolerance)}, std::move(cells));
  }

  /// Adds another line of the run above.
  void add_more(Cells cells) { add({"", ""}, std::move(cells)); }

  /// `alignments`: of the cells.
  std::string text(const std::string& alignments) const { return table_.text("lr" + alignments); }

 private:
  void add(Cells name, Cells cells) {
    std::ranges::move(cells, std::back_inserter(name));
    table_.add(std::move(name));
  }

  TextTable table_;
  std::string machine_;
};

std::string times_table(std::span<const ComparedRun> runs) {
  RunTable table;
  const auto figures = source_figures_of(runs, [](const ComparedRun& run) { return &run.summary; });
  Cells head{"cycle time", "h:mm:ss", "x programmed", "mean feed", "peak feed", "contour error"};
  Cells head_units{"[s]", "", "", "[mm/min]", "[mm/min]", "[mm]"};
  for (const SourceFigure* figure : figures) {
    head.push_back(figure_title(*figure));
    head_units.push_back(figure_unit(*figure));
  }
  table.add_head(head);
  table.add_units(head_units);
  for (const ComparedRun& run : runs) {
    if (!run.is_possible()) {
      Cells cells(head.size(), "-");
      cells.front() = run.refused ? refused_word : out_of_reach_word;
      table.add_run(run, std::move(cells));
      continue;
    }
    const Summary& summary = run.summary;
    Cells cells{fmt::format("{:.3f}", summary.cycle_time),
                clock_text(summary.cycle_time),
                run.lines_not_run > 0 ? "-" : fmt::format("{:.3f}", run.against_cam()),
                fmt::format("{:.1f}", units::to_mm_min(summary.mean_feed)),
                fmt::format("{:.1f}", units::to_mm_min(summary.peak_feed)),
                fmt::format("{:.4f}", summary.cutting_contour_error)};
    for (const SourceFigure* figure : figures) {
      cells.push_back(figure_text(*figure, summary));
    }
    table.add_run(run, std::move(cells));
  }
  return table.text(std::string(6 + figures.size(), 'r'));
}

void add_shares(Cells& cells, const ComparedRun& run, double AxisPeaks::*peak, double AxisLimits::*limit) {
  for (const AxisInfo& axis : known_axes) {
    const AxisPeaks* const found = run.summary.axes.find(axis.name);
    cells.push_back(found == nullptr     ? ""
                    : !run.is_possible() ? "-"
                    : std::isnan(found->*peak)
                        ? "jumps"
                        : percent(found->*peak / run.setup.machine.axes.find(axis.name)->*limit));
  }
}

/// Remarks on the figures.
std::string remarks_text(std::span<const ComparedRun> runs) {
  using About = Remark::About;
  std::vector<RemarkedSetup> remarked;
  for (const ComparedRun& run : runs) {
    remarked.push_back({&run.setup, run.remarks});
  }
  std::string out;
  for (const std::string& text :
       remark_texts(remarked, {About::programmed, About::time, About::values, About::not_counted})) {
    out += "\n" + wrapped(text, 0) + "\n";
  }
  return out;
}

std::string peaks_table(std::span<const ComparedRun> runs) {
  RunTable table;
  Cells head;
  for (const std::string_view limit : {"velocity ", "acceleration ", "jerk "}) {
    for (std::size_t i = 0; i < known_axes.size(); ++i) {
      head.push_back(fmt::format("{}{}", i == 0 ? limit : "", known_axes[i].name));
    }
  }
  table.add_head(std::move(head));
  for (const ComparedRun& run : runs) {
    Cells shares;
    add_shares(shares, run, &AxisPeaks::velocity, &AxisLimits::velocity);
    add_shares(shares, run, &AxisPeaks::acceleration, &AxisLimits::acceleration);
    add_shares(shares, run, &AxisPeaks::jerk, &AxisLimits::jerk);
    table.add_run(run, std::move(shares));
  }
  return table.text("rrrrrrrrr");
}

std::string causes_table(std::span<const ComparedRun> runs) {
  RunTable table;
  table.add_head({"of the cycle time, largest first"});
  for (const ComparedRun& run : runs) {
    const std::vector<std::string> lines =
        run.refused ? std::vector<std::string>{"refused by the control: none of its feed motions is run"}
        : run.out_of_reach
            ? std::vector<std::string>{"out of reach: rotary axes would have to go where they cannot"}
            : causes_text(run.summary);
    table.add_run(run, {lines.front()});
    for (std::size_t i = 1; i < lines.size(); ++i) {
      table.add_more({lines[i]});
    }
  }
  return table.text("l");
}

}  // namespace

std::string comparison_text(const LoadedProgram& program, std::span<const ComparedRun> runs,
                            const std::vector<std::string>& assignments) {
  std::string heading =
      fmt::format("{}, path {:.3f} mm", program.program->source->name(), program.toolpath->length());
  if (!assignments.empty()) {
    heading += fmt::format(", with {}", fmt::join(assignments, " "));
  }
  std::string text =
      fmt::format("{}\n\n{}{}\nLargest values in percent of the limits\n{}\nTime by limiting cause\n{}",
                  heading, times_table(runs), remarks_text(runs), peaks_table(runs), causes_table(runs));
  const std::vector<ToleranceRun> all = tolerance_runs(runs);
  for (const SlowerTolerance& slower : slower_with_wider_tolerance(all)) {
    text += fmt::format("\n{}\n", wrapped(to_string(slower, all), 0));
  }
  if (tolerances_without_effect(runs)) {
    text += "\nNo run has a corner blend: the contour tolerances compared change nothing.\n";
  }
  return text;
}

}  // namespace feedscope
