#include "ui/runs/comparison_bars.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include "core/analysis/study/recommendation.h"

namespace feedscope::ui {
namespace {

constexpr std::size_t kind_count = cause_kind_count;
constexpr double min_share = 0.01;
constexpr double seen_share = 0.002;  // of the longest bar; less is narrower than a pixel

using KindFlags = std::array<bool, kind_count>;

std::size_t index_of(CauseKind kind) {
  return static_cast<std::size_t>(kind);
}

/// The largest share of a cycle time for each kind in any run.
std::array<double, kind_count> largest_shares(std::span<const ComparedRun> runs) {
  std::array<double, kind_count> largest{};
  for (const ComparedRun& run : runs) {
    std::array<double, kind_count> times{};
    for (std::size_t i = 0; i < run.summary.time_by_cause.size(); ++i) {
      times[index_of(all_causes()[i].kind)] += run.summary.time_by_cause[i];
    }
    for (std::size_t k = 0; k < kind_count && run.summary.cycle_time > 0; ++k) {
      largest[k] = std::max(largest[k], times[k] / run.summary.cycle_time);
    }
  }
  return largest;
}

KindFlags kinds_told_apart(std::span<const ComparedRun> runs) {
  const std::array<double, kind_count> shares = largest_shares(runs);
  std::vector<std::size_t> present;
  for (std::size_t k = 0; k < kind_count; ++k) {
    if (shares[k] > 0) {
      present.push_back(k);
    }
  }
  std::ranges::stable_sort(present, std::greater(), [&](std::size_t k) { return shares[k]; });
  const auto small =
      std::ranges::find_if(present, [&](std::size_t k) { return shares[k] < min_share; }) - present.begin();
  auto kept = static_cast<std::size_t>(small);
  if (kept + 1 == present.size() && shares[present[kept]] >= seen_share) {
    ++kept;
  }
  present.resize(std::min(kept, max_cause_kinds));
  KindFlags flags{};
  for (const std::size_t k : present) {
    flags[k] = true;
  }
  return flags;
}

ComparisonBar bar_of(const ComparedRun& run, const KindFlags& told) {
  const Summary& summary = run.summary;
  ComparisonBar bar{run.setup.model->info().id,
                    run.tolerance,
                    run.is_possible() ? summary.cycle_time : 0,  // rapids and dwells are not a run of it
                    run.against_cam(),
                    deciding_error(summary),
                    run.refused,
                    run.out_of_reach,
                    run.lines_not_run,
                    {}};
  if (!run.is_possible()) {
    return bar;
  }
  double rest = 0;
  for (std::size_t i = 0; i < summary.time_by_cause.size(); ++i) {
    const double time = summary.time_by_cause[i];
    const Cause cause = all_causes()[i];
    if (time > 0 && told[index_of(cause.kind)]) {
      bar.parts.push_back({cause, time});
    } else {
      rest += time;
    }
  }
  if (rest > 0) {
    bar.parts.push_back({std::nullopt, rest});
  }
  return bar;
}

}  // namespace

std::size_t ComparisonBars::count() const {
  return std::accumulate(
      machines.begin(), machines.end(), std::size_t{0},
      [](std::size_t sum, const MachineBars& machine) { return sum + machine.bars.size(); });
}

ComparisonBars comparison_bars(std::span<const ComparedRun> runs) {
  const KindFlags told = kinds_told_apart(runs);
  ComparisonBars result;
  for (std::size_t k = 0; k < kind_count; ++k) {
    if (told[k]) {
      result.kinds.push_back(static_cast<CauseKind>(k));
    }
  }
  result.actual =
      std::ranges::all_of(runs, [](const ComparedRun& run) { return run.summary.actual.has_value(); });
  const std::string* machine = nullptr;
  for (const ComparedRun& run : runs) {
    if (machine == nullptr || *machine != run.setup.machine.id) {
      machine = &run.setup.machine.id;
      result.machines.push_back({run.setup.machine.name, 0, {}});
    }
    if (run.is_possible() && result.machines.back().programmed_time == 0) {
      result.machines.back().programmed_time = run.summary.programmed_time;
    }
    const ComparisonBar& bar = result.machines.back().bars.emplace_back(bar_of(run, told));
    result.lines_refused = result.lines_refused || bar.lines_not_run > 0;
    result.longest = std::max({result.longest, bar.cycle_time, run.summary.programmed_time});
  }
  for (const MachineBars& each : result.machines) {
    result.rest = result.rest || std::ranges::any_of(each.bars, [&](const ComparisonBar& bar) {
                    return !bar.parts.empty() && !bar.parts.back().cause &&
                           bar.parts.back().time >= seen_share * result.longest;
                  });
  }
  return result;
}

}  // namespace feedscope::ui
