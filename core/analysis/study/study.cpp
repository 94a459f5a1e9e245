#include "core/analysis/study/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/analysis/study/fastest_runs.h"
#include "core/analysis/study/recommendation.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"

namespace feedscope {
namespace {

bool is_one_of(const std::vector<std::string>& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

void check_keys(const StudyRequest& request) {
  for (std::size_t i = 0; i < request.sweeps.size(); ++i) {
    const std::string& key = request.sweeps[i].key;
    for (std::size_t k = 0; k < i; ++k) {
      if (request.sweeps[k].key == key) {
        throw InputError(
            message(NC_("core", "'{}' is swept twice; write all its values into one sweep"), key));
      }
    }
    for (const std::string& assignment : request.assignments) {
      if (assigned_key(assignment) == key) {
        throw InputError(
            message(NC_("core", "'{}' is both swept and set to a value; omit '{}'"), key, assignment));
      }
    }
    if (key == "tolerance" && !request.tolerances.empty()) {
      throw InputError(NC_("core", "the tolerance is both swept and set; omit --tolerance"));
    }
  }
}

std::vector<std::string> models_that_know(const StudyRequest& request) {
  std::vector<std::string> models = request.models;
  if (models.empty()) {
    for (const ControlModel* model : all_models()) {
      models.push_back(model->info().id);
    }
  }
  const std::vector<std::string> asked = models;
  std::vector<std::string> known;
  for (const std::string& model : asked) {
    for (const std::string& key : sweep_keys(find_model(model))) {
      if (!is_one_of(known, key)) {
        known.push_back(key);
      }
    }
  }
  for (const Sweep& sweep : request.sweeps) {
    std::erase_if(models, [&](const std::string& model) {
      return !is_one_of(sweep_keys(find_model(model)), sweep.key);
    });
    if (models.empty()) {
      const std::string near = nearest_name(sweep.key, known);
      throw InputError(message(
          NC_("core", "sweep of '{}': unknown to the models {}; {}known settings: {}"), sweep.key,
          fmt::format("{}", fmt::join(asked, ", ")),
          near.empty() || near == sweep.key ? Message() : message(NC_("core", "did you mean '{}'? "), near),
          fmt::format("{}", fmt::join(known, ", "))));
    }
  }
  return models;
}

/// Given setups whose model has every swept key.
std::vector<Setup> setups_that_know(const StudyRequest& request) {
  StudyRequest of_models = request;
  for (const Setup& setup : request.setups) {
    of_models.models.push_back(setup.model->info().id);
  }
  const std::vector<std::string> models = models_that_know(of_models);
  std::vector<Setup> setups = request.setups;
  std::erase_if(setups, [&](const Setup& setup) { return !is_one_of(models, setup.model->info().id); });
  return setups;
}

std::size_t combinations(const std::vector<Sweep>& sweeps) {
  std::size_t count = 1;
  for (const Sweep& sweep : sweeps) {
    count *= sweep.values.size();
    if (count > max_study_runs) {
      break;
    }
  }
  return count;
}

std::vector<RunTime> times_of(std::span<const StudyRun> runs) {
  std::vector<RunTime> times;
  for (const StudyRun& run : runs) {
    times.push_back(
        {run.summary.cycle_time, deciding_error(run.summary), run.lines_not_run, run.is_possible()});
  }
  return times;
}

}  // namespace

std::vector<StudySetup> setups_to_study(const StudyRequest& request) {
  check_keys(request);
  const std::vector<Setup> bases = !request.setups.empty()
                                       ? setups_that_know(request)
                                       : setups_to_compare(request.machines, models_that_know(request),
                                                           request.tolerances, request.assignments);
  const std::size_t count = combinations(request.sweeps);
  if (count * bases.size() > max_study_runs) {
    throw InputError(
        message(NC_("core", "the sweeps need more than {} runs; use fewer values"), max_study_runs));
  }
  std::vector<StudySetup> setups;
  for (const Setup& base : bases) {
    for (std::size_t i = 0; i < count; ++i) {
      StudySetup one{base, {}};
      if (!request.load.empty()) {
        one.setup.load = request.load;
      }
      std::size_t rest = i;
      for (const Sweep& sweep : request.sweeps) {
        one.swept.push_back(sweep.values[rest % sweep.values.size()]);
        rest /= sweep.values.size();
        apply_swept(sweep.key, one.swept.back(), one.setup);
      }
      setups.push_back(std::move(one));
    }
  }
  return setups;
}

Study run_study(const LoadedProgram& program, const StudyRequest& request, Progress* progress) {
  Study study;
  study.sweeps = request.sweeps;
  study.within = request.within;
  study.operations = split_operations(*program.program, *program.toolpath, request.split);
  const std::vector<StudySetup> setups = setups_to_study(request);
  std::vector<Setup> plain;
  for (const StudySetup& one : setups) {
    plain.push_back(one.setup);
  }
  study.runs.resize(setups.size());
  const auto keep_operations = [&](std::size_t i, const Run& run) {
    study.runs[i].operations = figures_of(study.operations, *run.trajectory);
  };
  std::vector<ComparedRun> figures = compare_runs(program, plain, progress, keep_operations);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    static_cast<ComparedRun&>(study.runs[i]) = std::move(figures[i]);
    study.runs[i].swept = setups[i].swept;
  }
  return study;
}

std::vector<std::span<const StudyRun>> Study::curves() const {
  const std::size_t length = sweeps.empty() ? 1 : sweeps.front().values.size();
  std::vector<std::span<const StudyRun>> curves;
  for (std::size_t first = 0; first + length <= runs.size(); first += length) {
    curves.emplace_back(runs.data() + first, length);
  }
  return curves;
}

const StudyRun* fastest(std::span<const StudyRun> runs, std::optional<double> within) {
  const std::vector<std::size_t> found = fastest_runs(times_of(runs), within);
  return found.empty() ? nullptr : &runs[found.front()];
}

bool makes_no_difference(std::span<const StudyRun> runs, std::optional<double> within) {
  constexpr double rounding = 1e-9;  // of the cycle time
  const StudyRun& first = runs.front();
  return runs.size() > 1 && std::ranges::all_of(runs, [&](const StudyRun& run) {
           return run.is_possible() && run.lines_not_run == first.lines_not_run &&
                  std::abs(run.summary.cycle_time - first.summary.cycle_time) <=
                      rounding * first.summary.cycle_time &&
                  keeps_bound(deciding_error(run.summary), within);
         });
}

std::vector<bool> fastest_marks(std::span<const StudyRun> curve, std::optional<double> within) {
  std::vector<bool> marks(curve.size());
  if (curve.empty() || makes_no_difference(curve, within)) {
    return marks;
  }
  for (const std::size_t i : fastest_runs(times_of(curve), within)) {
    marks[i] = true;
  }
  return marks;
}

const StudyRun* recommended(std::span<const StudyRun> runs, std::optional<double> within) {
  const auto taken = recommend(std::span<const RunTime>(times_of(runs)), within);
  return taken ? &runs[taken->run] : nullptr;
}

std::vector<bool> recommended_marks(std::span<const StudyRun> curve, std::optional<double> within) {
  std::vector<bool> marks(curve.size());
  const std::vector<RunTime> times = times_of(curve);
  const auto taken = recommend(std::span<const RunTime>(times), within);
  if (!taken || makes_no_difference(curve, within)) {
    return marks;
  }
  const RunTime& best = times[taken->run];
  constexpr double rounding = 1e-9;  // of the time, relative; of errors [mm]
  for (const std::size_t i : runs_to_choose_from(times, within)) {
    marks[i] = std::abs(times[i].cycle_time - best.cycle_time) <= rounding * best.cycle_time &&
               std::abs(times[i].contour_error - best.contour_error) <= rounding;
  }
  return marks;
}

}  // namespace feedscope
