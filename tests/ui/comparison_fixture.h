#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/analysis/study/compare.h"

namespace feedscope::test {

/// A run whose cycle time is the sum of `times` [s], on a shipped machine with that name and those settings.
inline ComparedRun compared_run(const std::string& machine, const std::string& model,
                                std::optional<double> tolerance,
                                const std::vector<std::pair<Cause, double>>& times,
                                const std::vector<std::string>& assignments = {}) {
  ComparedRun run;
  run.setup = make_setup({"spinner-mvc850", model, tolerance, assignments});
  run.setup.machine.id = machine;
  run.setup.machine.name = machine;
  if (tolerance) {
    run.tolerance = ToleranceInForce{*tolerance, *tolerance};
  }
  run.summary.time_by_cause.assign(all_causes().size(), 0);
  for (const auto& [cause, time] : times) {
    run.summary.time_by_cause[cause_index(cause)] += time;
    run.summary.cycle_time += time;
  }
  run.summary.programmed_time = 2;
  run.summary.max_contour_error = run.summary.cutting_contour_error = 0.008;
  return run;
}

/// Settings of usual_compared_runs(), of which `essid` alone reads the first.
inline const std::vector<std::string> compared_settings{"alpha=2", "X.jerk=5"};

/// Two machines, three models, two tolerances: what a comparison usually holds, in round figures.
inline std::vector<ComparedRun> usual_compared_runs() {
  const std::vector<std::string> jerk{compared_settings[1]};
  const Cause feed{CauseKind::programmed_feed, -1};
  const Cause rapid{CauseKind::rapid, -1};
  const Cause jerk_x{CauseKind::axis_jerk, 0};
  const Cause jerk_y{CauseKind::axis_jerk, 1};
  const Cause blend{CauseKind::blend_radial_jerk, 1};
  const Cause tolerance{CauseKind::contour_tolerance, -1};
  const Cause ramp{CauseKind::ramp_down, -1};
  const Cause stop{CauseKind::exact_stop, -1};
  const Cause dwell{CauseKind::dwell, -1};
  const std::string first = "Portal mill 5000 with a long name and a swivelling head";
  const std::string second = "Spinner";
  return {
      compared_run(first, "cam", {}, {{feed, 1.9}, {rapid, 0.1}}, jerk),
      compared_run(first, "essid", 0.01, {{feed, 0.7}, {jerk_x, 0.8}, {jerk_y, 0.3}, {blend, 0.2}, {ramp, 1}},
                   compared_settings),
      compared_run(first, "essid", 0.05,
                   {{feed, 0.9}, {jerk_x, 0.7}, {jerk_y, 0.2}, {blend, 0.1}, {ramp, 0.8}}, compared_settings),
      compared_run(first, "ward", 0.01,
                   {{feed, 0.5}, {tolerance, 4}, {ramp, 0.5}, {stop, 0.03}, {dwell, 0.02}}, jerk),
      compared_run(first, "ward", 0.05, {{feed, 0.5}, {tolerance, 1.5}, {ramp, 0.4}}, jerk),
      compared_run(second, "cam", {}, {{feed, 1.9}, {rapid, 0.1}}, jerk),
      compared_run(second, "essid", 0.05, {{feed, 1.5}, {jerk_x, 0.4}, {ramp, 0.4}}, compared_settings)};
}

/// `count` runs of several machines, models and tolerances, every kind of cause among them.
inline std::vector<ComparedRun> many_compared_runs(std::size_t count) {
  const std::vector<std::string> models{"essid", "msaddek", "ward"};
  std::vector<ComparedRun> runs;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::pair<Cause, double>> times;
    for (std::size_t c = 0; c < all_causes().size(); ++c) {
      times.emplace_back(all_causes()[c], 0.1 * static_cast<double>((c * 7 + i * 3) % 11));
    }
    runs.push_back(compared_run("machine with a long name, number " + std::to_string(i / 12),
                                models[i / 4 % models.size()], 0.01 * static_cast<double>(1 + i % 4), times));
  }
  return runs;
}

}  // namespace feedscope::test
