#include "app/study_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>

#include "app/print.h"
#include "core/analysis/notes/slower_tolerance.h"
#include "core/analysis/run/source_figures.h"
#include "core/analysis/study/recommendation.h"
#include "core/base/clock_text.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

std::string value_text(const Sweep& sweep, double value) {
  const std::string unit = sweep_unit(sweep.key);
  return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

std::string setting_text(const Study& study, const StudyRun& run) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < study.sweeps.size(); ++i) {
    parts.push_back(fmt::format("{} {}", study.sweeps[i].key, value_text(study.sweeps[i], run.swept[i])));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Common part of the runs of a curve: "essid on Spinner MVC 850, X.jerk 20 m/s3".
std::string curve_title(const Study& study, const StudyRun& run) {
  std::string title = fmt::format("{} on {}", run.setup.model->info().id, run.setup.machine.name);
  const bool sweeps_tolerance =
      std::ranges::any_of(study.sweeps, [](const Sweep& sweep) { return sweep.key == "tolerance"; });
  if (run.tolerance && !sweeps_tolerance) {
    title += fmt::format(", tolerance {}", describe(run.tolerance));
  }
  for (std::size_t i = 1; i < study.sweeps.size(); ++i) {
    title += fmt::format(", {} {}", study.sweeps[i].key, value_text(study.sweeps[i], run.swept[i]));
  }
  return title;
}

std::string share_text(const CauseShare& cause) {
  return fmt::format("{:.0f} % {}", 100 * cause.share, cause_title(cause.cause));
}

std::string main_causes(const StudyRun& run) {
  constexpr std::size_t most = 3;
  constexpr double shown = 0.05;
  std::vector<std::string> parts;
  for (const CauseShare& cause : limiting_causes(run.summary)) {
    if (parts.size() == most || (!parts.empty() && cause.share < shown)) {
      break;
    }
    parts.push_back(share_text(cause));
  }
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string curve_table(const Study& study, std::span<const StudyRun> curve) {
  const std::vector<bool> marks = recommended_marks(curve, study.within);
  TextTable table;
  const Sweep& sweep = study.sweeps.front();
  const std::string unit = sweep_unit(sweep.key);
  const auto figures = source_figures_of(study.runs, [](const StudyRun& run) { return &run.summary; });
  std::vector<std::string> head{"", sweep.key, "cycle time", "h:mm:ss", "mean feed", "contour error"};
  std::vector<std::string> head_units{
      "", unit.empty() ? "" : fmt::format("[{}]", unit), "[s]", "", "[mm/min]", "[mm]"};
  for (const SourceFigure* figure : figures) {
    head.push_back(figure_title(*figure));
    head_units.push_back(figure_unit(*figure));
  }
  head.emplace_back("limited most by");
  head_units.emplace_back("");
  table.add(head);
  table.add(head_units);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const StudyRun& run = curve[i];
    const Summary& summary = run.summary;
    const std::vector<CauseShare> causes = limiting_causes(summary);
    std::vector<std::string> cells{marks[i] ? "*" : "",
                                   fmt::format("{}", run.swept.front()),
                                   fmt::format("{:.3f}", summary.cycle_time),
                                   clock_text(summary.cycle_time),
                                   fmt::format("{:.1f}", units::to_mm_min(summary.mean_feed)),
                                   fmt::format("{:.4f}", summary.cutting_contour_error)};
    if (!run.is_possible()) {
      std::ranges::fill(cells.begin() + 2, cells.end(), "-");
      cells[2] = run.refused ? refused_word : out_of_reach_word;
    }
    for (const SourceFigure* figure : figures) {
      cells.push_back(run.is_possible() ? figure_text(*figure, summary) : "-");
    }
    cells.push_back(causes.empty() || run.out_of_reach ? "" : share_text(causes.front()));
    table.add(std::move(cells));
  }
  return table.text("lrrrrr" + std::string(figures.size(), 'r') + "l");
}

constexpr const char* refused_text = "The control refuses the program: none of its feed motions is run.";

bool none_possible(std::span<const StudyRun> runs) {
  return std::ranges::none_of(runs, &StudyRun::is_possible);
}

std::string none_possible_text(std::span<const StudyRun> runs) {
  return std::ranges::all_of(runs, &StudyRun::refused)
             ? refused_text
             : "No run is possible: the program sends the rotary axes where the machine cannot turn them; "
               "simulate says in which lines.";
}

/// The possible run with the least error; if none is possible, one with the fewest refused lines.
const StudyRun& min_error(std::span<const StudyRun> runs) {
  return *std::ranges::min_element(runs, {}, [](const StudyRun& run) {
    return std::tuple(!run.is_possible(), run.lines_not_run, deciding_error(run.summary));
  });
}

/// "X.jerk makes no difference: 12.3 s with every value. ..." of a curve.
std::string no_difference_text(const Study& study, std::span<const StudyRun> curve) {
  const StudyRun& first = curve.front();
  const std::string& key = study.sweeps.front().key;
  const bool is_jerk = key.ends_with(".jerk") || key.ends_with(".blend_jerk");
  std::string text = fmt::format("{} makes no difference to the cycle time: {} with every value.", key,
                                 time_text(first.summary.cycle_time));
  if (is_jerk && !first.setup.model->guarantees(first.setup.settings).limits_jerk) {
    text += fmt::format(" Model {} limits no jerk and does not use it.", first.setup.model->info().id);
  }
  const auto error = [](const StudyRun& run) { return fmt::format("{:.4f}", deciding_error(run.summary)); };
  const char* const actual = first.summary.actual ? "actual " : "";
  const StudyRun& least = min_error(curve);
  if (std::ranges::all_of(curve, [&](const StudyRun& run) { return error(run) == error(first); })) {
    text += fmt::format(" The {}contour error is {} mm with all.", actual, error(first));
  } else {
    text += fmt::format(" The {}contour error is smallest at {}: {} mm.", actual, setting_text(study, least),
                        error(least));
  }
  return text + not_run_text(first.lines_not_run);
}

std::string recommended_text(const Study& study, std::span<const StudyRun> runs) {
  if (none_possible(runs)) {
    return none_possible_text(runs);
  }
  const StudyRun* best = recommended(runs, study.within);
  if (best == nullptr) {
    const StudyRun& least = min_error(runs);
    return fmt::format("No value has a contour error within {} mm; the smallest is {:.4f} mm at {}.",
                       *study.within, deciding_error(least.summary), setting_text(study, least));
  }
  const Summary& summary = best->summary;
  std::string where;
  if (!summary.actual && summary.cutting_contour_error > 0 &&
      summary.cutting_contour_error == summary.max_contour_error) {
    where = fmt::format(" (line {}, at {:.3f} s)", summary.worst_place.line, summary.worst_place.time);
  }
  return fmt::format("Recommended{}: {} with {}, {}contour error {:.4f} mm{}.{}",
                     study.within ? fmt::format(" within {} mm", *study.within) : "",
                     setting_text(study, *best), time_text(summary.cycle_time),
                     summary.actual ? "actual " : "", deciding_error(summary), where,
                     not_run_text(best->lines_not_run));
}

/// The limits at both ends of a curve; empty if an end is impossible.
std::string ends_text(const Study& study, std::span<const StudyRun> curve) {
  if (!curve.front().is_possible() || !curve.back().is_possible()) {
    return "";
  }
  const Sweep& sweep = study.sweeps.front();
  std::string text = fmt::format("At {} {} the time is due to {}", sweep.key,
                                 value_text(sweep, curve.front().swept.front()), main_causes(curve.front()));
  if (curve.size() > 1) {
    text += fmt::format("; at {} to {}", value_text(sweep, curve.back().swept.front()),
                        main_causes(curve.back()));
  }
  return text + ".";
}

}  // namespace

std::string operations_text(const Study& study, const StudyRun& run) {
  TextTable table;
  table.add(
      {"line", "operation", "time", "share", "cutting", "mean feed", "contour error", "limited most by"});
  table.add({"", "", "[s]", "[%]", "[mm]", "[mm/min]", "[mm]", ""});
  constexpr std::size_t longest_title = 40;
  for (std::size_t i = 0; i < run.operations.size(); ++i) {
    const OperationFigures& figures = run.operations[i];
    const std::string& title = study.operations[i].title;
    table.add({fmt::format("{}", study.operations[i].line),
               title.size() > longest_title ? title.substr(0, longest_title - 3) + "..." : title,
               fmt::format("{:.3f}", figures.time),
               fmt::format("{:.0f}", 100 * figures.time / std::max(run.summary.cycle_time, 1e-12)),
               fmt::format("{:.1f}", figures.cutting_length),
               fmt::format("{:.1f}", units::to_mm_min(figures.mean_feed())),
               fmt::format("{:.4f}", figures.cutting_contour_error),
               figures.time > 0 ? share_text({figures.cause, figures.cause_time / figures.time}) : ""});
  }
  return table.text("rlrrrrrl");
}

std::vector<std::string> names_among(const Study& study) {
  const std::vector<StudyRun>& runs = study.runs;
  const auto differs = [&](const auto& of) {
    return std::ranges::any_of(runs, [&](const StudyRun& run) { return of(run) != of(runs.front()); });
  };
  const auto machine = [](const StudyRun& run) { return run.setup.machine.name; };
  const auto tolerance = [](const StudyRun& run) { return describe(run.tolerance); };
  const auto model = [](const StudyRun& run) { return run.setup.model->info().id; };
  const bool machines_differ = differs(machine);
  const bool models_differ = differs(model);
  const bool tolerances_differ = study.sweeps.empty() && differs(tolerance);
  std::vector<std::string> names;
  for (const StudyRun& run : runs) {
    std::vector<std::string> parts;
    if (machines_differ) {
      parts.push_back(machine(run));
    }
    if (models_differ) {
      parts.push_back(model(run));
    }
    if (!study.sweeps.empty()) {
      parts.push_back(setting_text(study, run));
    } else if (tolerances_differ || !(machines_differ || models_differ)) {
      parts.push_back(tolerance(run));
    }
    names.push_back(fmt::format("{}", fmt::join(parts, ", ")));
  }
  const std::vector<std::string> plain = names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::ranges::count(plain, plain[i]) > 1) {
      names[i] += fmt::format(" (run {})", i + 1);
    }
  }
  return names;
}

std::string fastest_text(const Study& study) {
  if (none_possible(study.runs)) {
    return fmt::format("{}\n", none_possible_text(study.runs));
  }
  const StudyRun* best = fastest(study.runs, study.within);
  if (best == nullptr) {
    const StudyRun& least = min_error(study.runs);
    return fmt::format("No run has a contour error within {} mm; the smallest is {:.4f} mm: {}.\n",
                       *study.within, deciding_error(least.summary), curve_title(study, least));
  }
  return fmt::format("Fastest within {} mm: {}, {}.{}\n", *study.within, curve_title(study, *best),
                     time_text(best->summary.cycle_time), not_run_text(best->lines_not_run));
}

std::string study_text(const LoadedProgram& program, const Study& study,
                       const std::vector<std::string>& assignments) {
  std::string text =
      fmt::format("{}, path {:.3f} mm", program.program->source->name(), program.toolpath->length());
  if (!assignments.empty()) {
    text += fmt::format(", with {}", fmt::join(assignments, " "));
  }
  text += "\n";
  const auto curves = study.curves();
  for (const auto& curve : curves) {
    const bool all_equal = makes_no_difference(curve, study.within);
    const StudyRun* best = all_equal ? nullptr : recommended(curve, study.within);
    text += fmt::format(
        "\n{}\n{}{}\n", curve_title(study, curve.front()), curve_table(study, curve),
        wrapped(all_equal ? no_difference_text(study, curve) : recommended_text(study, curve), 0));
    if (const std::string ends = ends_text(study, curve); !ends.empty()) {
      text += wrapped(ends, 0) + "\n";
    }
    std::vector<ToleranceRun> tolerances;
    for (const StudyRun& run : curve) {
      if (run.is_possible()) {
        tolerances.push_back({&run.setup, &run.summary});
      }
    }
    for (const SlowerTolerance& slower : slower_with_wider_tolerance(tolerances)) {
      text += fmt::format("{}\n", wrapped(to_string(slower, tolerances), 0));
    }
    if (!study.operations.empty() && !none_possible(curve)) {
      const StudyRun& shown = best != nullptr ? *best : min_error(curve);
      text +=
          fmt::format("\nOperations at {}\n{}", setting_text(study, shown), operations_text(study, shown));
    }
  }
  if (curves.size() > 1) {
    const StudyRun* best = recommended(study.runs, study.within);
    const bool any_value = best != nullptr && std::ranges::any_of(curves, [&](const auto& curve) {
                             return best >= curve.data() && best < curve.data() + curve.size() &&
                                    makes_no_difference(curve, study.within);
                           });
    text += best == nullptr ? fmt::format("\n{}\n", recommended_text(study, study.runs))
            : any_value     ? fmt::format("\nOf all: {}, {}.\n", curve_title(study, *best),
                                          time_text(best->summary.cycle_time))
                            : fmt::format("\nOf all: {}. {}\n", curve_title(study, *best),
                                          recommended_text(study, study.runs));
  }
  return text;
}

}  // namespace feedscope
