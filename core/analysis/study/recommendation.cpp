#include "core/analysis/study/recommendation.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace feedscope {
namespace {

/// Run with the smallest error among those not longer than `fastest`.
std::size_t most_exact(std::span<const RunTime> runs, const std::vector<std::size_t>& places,
                       std::size_t fastest) {
  const double longest = runs[fastest].cycle_time * (1 + worthwhile_share);
  std::size_t best = fastest;
  for (const std::size_t place : places) {
    const RunTime& run = runs[place];
    const bool better =
        run.contour_error < runs[best].contour_error ||
        (run.contour_error == runs[best].contour_error && run.cycle_time < runs[best].cycle_time);
    if (run.cycle_time <= longest && better) {
      best = place;
    }
  }
  return best;
}

struct ChoiceTimes {
  double fastest = 0;  ///< [s]
  double taken = 0;
  double slowest = 0;
};

Recommendation::Reason reason_of(std::size_t choices, const ChoiceTimes& times) {
  using enum Recommendation::Reason;
  return choices == 1                                              ? only
         : times.slowest <= times.fastest * (1 + worthwhile_share) ? no_difference
         : times.taken == times.fastest                            ? fastest
                                                                   : smallest_error;
}

std::vector<RunTime> times_of(std::span<const ComparedRun> runs) {
  const std::vector<bool> can = can_be_chosen(runs);
  std::vector<RunTime> times;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Summary& summary = runs[i].summary;
    times.push_back({summary.cycle_time, deciding_error(summary), runs[i].lines_not_run, can[i]});
  }
  return times;
}

}  // namespace

std::optional<Recommendation> recommend(std::span<const RunTime> runs, std::optional<double> within) {
  const std::vector<std::size_t> places = runs_to_choose_from(runs, within);
  if (places.empty()) {
    return std::nullopt;
  }
  const auto time = [&](std::size_t place) { return runs[place].cycle_time; };
  const std::size_t fastest = *std::ranges::min_element(places, {}, time);
  const std::size_t slowest = *std::ranges::max_element(places, {}, time);
  const std::size_t best = most_exact(runs, places, fastest);
  Recommendation result;
  result.run = best;
  result.against = slowest;
  result.gain = time(slowest) - time(best);
  result.gain_share = time(slowest) > 0 ? result.gain / time(slowest) : 0;
  result.contour_error = runs[best].contour_error;
  result.reason = reason_of(places.size(), {time(fastest), time(best), time(slowest)});
  return result;
}

double deciding_error(const Summary& summary) {
  return summary.actual ? summary.actual->worst.error : summary.cutting_contour_error;
}

std::vector<bool> can_be_chosen(std::span<const ComparedRun> runs) {
  const bool one_model = std::ranges::all_of(
      runs, [&](const ComparedRun& run) { return run.setup.model == runs.front().setup.model; });
  std::vector<bool> can;
  for (const ComparedRun& run : runs) {
    can.push_back(run.is_possible() && (one_model || run.setup.model->info().id == run.setup.machine.model));
  }
  return can;
}

std::optional<Recommendation> recommend(std::span<const ComparedRun> runs, std::optional<double> within) {
  const std::vector<RunTime> times = times_of(runs);
  return recommend(std::span<const RunTime>(times), within);
}

std::optional<std::size_t> leading_run(std::span<const ComparedRun> runs, std::optional<double> within) {
  if (const auto taken = recommend(runs, within)) {
    return taken->run;
  }
  const std::vector<RunTime> times = times_of(runs);
  const std::vector<std::size_t> choices = runs_to_choose_from(times, std::nullopt);
  if (choices.empty()) {
    return std::nullopt;
  }
  return *std::ranges::min_element(choices, {}, [&](std::size_t run) {
    return std::pair(times[run].contour_error, times[run].cycle_time);
  });
}

bool another_model_is_faster(std::span<const ComparedRun> runs, const Recommendation& taken) {
  const std::vector<bool> can = can_be_chosen(runs);
  const ComparedRun& chosen = runs[taken.run];
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!can[i] && runs[i].is_possible() && runs[i].lines_not_run <= chosen.lines_not_run &&
        runs[i].summary.cycle_time < chosen.summary.cycle_time) {
      return true;
    }
  }
  return false;
}

OnlyChoice why_only(std::span<const ComparedRun> runs, std::optional<double> within) {
  const std::vector<bool> can = can_be_chosen(runs);
  std::size_t choices = 0;
  std::size_t beyond = 0;
  bool of_other_models = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    choices += can[i] ? 1 : 0;
    beyond += can[i] && !keeps_bound(deciding_error(runs[i].summary), within) ? 1 : 0;
    of_other_models = of_other_models || (!can[i] && runs[i].is_possible());
  }
  using enum OnlyChoice;
  if (choices == 1) {
    return of_other_models ? of_machine : possible;
  }
  return beyond + 1 < choices ? possible : of_other_models ? within_bound_of_machine : within_bound;
}

std::string to_string(Recommendation::Reason reason) {
  switch (reason) {
    case Recommendation::Reason::only:
      return "only";
    case Recommendation::Reason::no_difference:
      return "no-difference";
    case Recommendation::Reason::fastest:
      return "fastest";
    case Recommendation::Reason::smallest_error:
      break;
  }
  return "smallest-error-within-1-percent";
}

}  // namespace feedscope
