#include "core/analysis/study/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/analysis/notes/refused_lines.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/parallel.h"

namespace feedscope {
namespace {

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> or_all_models(const std::vector<std::string>& models) {
  std::vector<std::string> ids = models;
  if (ids.empty()) {
    for (const ControlModel* model : all_models()) {
      ids.push_back(model->info().id);
    }
  }
  return ids;
}

/// Throws InputError for an assignment that none of the models takes.
void check_assignments(const std::vector<std::string>& assignments, const std::vector<std::string>& models) {
  std::vector<std::string> known;
  for (const std::string& model : models) {
    for (std::string& key : assignable_keys(find_model(model))) {
      if (!contains(known, key)) {
        known.push_back(std::move(key));
      }
    }
  }
  for (const std::string& assignment : assignments) {
    const std::string key = assigned_key(assignment);
    if (!contains(known, key)) {
      const std::string near = nearest_name(key, known);
      throw InputError(message(NC_("core", "setting '{}' is unknown to the models {}; {}known settings: {}"),
                               key, fmt::format("{}", fmt::join(models, ", ")),
                               near.empty() ? Message() : message(NC_("core", "did you mean '{}'? "), near),
                               fmt::format("{}", fmt::join(known, ", "))));
    }
  }
}

std::vector<std::string> taken_by(const ControlModel& model, std::vector<std::string> assignments) {
  const std::vector<std::string> keys = assignable_keys(model);
  std::erase_if(assignments,
                [&](const std::string& assignment) { return !contains(keys, assigned_key(assignment)); });
  return assignments;
}

}  // namespace

ComparedRun figures_of(const Run& run) {
  return {run.setup,
          run.summary,
          run.trajectory->path_length(),
          run.trajectory->blend_count(),
          run.simulate_time,
          tolerance_in_force(run.input.feed_controls, run.setup),
          is_refused(run),
          run.lines_not_run.size(),
          is_out_of_reach(run),
          remarks(run)};
}

std::vector<Setup> setups_to_compare(const std::vector<std::string>& machines,
                                     const std::vector<std::string>& models,
                                     const std::vector<double>& tolerances,
                                     const std::vector<std::string>& assignments) {
  const std::vector<std::string> model_ids = or_all_models(models);
  check_assignments(assignments, model_ids);
  std::vector<Setup> setups;
  for (const std::string& machine : machines.empty() ? std::vector<std::string>{""} : machines) {
    for (const std::string& model : model_ids) {
      const std::vector<std::string> taken = taken_by(find_model(model), assignments);
      const auto add = [&](std::optional<double> tolerance) -> const Setup& {
        return setups.emplace_back(make_setup({machine, model, tolerance, taken}));
      };
      if (tolerances.empty()) {
        add(std::nullopt);
      }
      for (const double tolerance : tolerances) {
        if (!contour_tolerance(add(tolerance))) {
          break;
        }
      }
    }
  }
  return setups;
}

std::vector<ComparedRun> compare_runs(const LoadedProgram& program, const std::vector<Setup>& setups,
                                      Progress* progress,
                                      const std::function<void(std::size_t, const Run&)>& inspect) {
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  whole.report(0);
  std::vector<ComparedRun> runs(setups.size());
  in_parallel(setups.size(), [&](std::size_t i) {
    Progress part(whole, 1 / static_cast<double>(setups.size()));
    part.report(0);
    const Run done = simulate_run(program, setups[i], &part);
    runs[i] = figures_of(done);
    if (inspect) {
      inspect(i, done);
    }
    part.report(1);
  });
  whole.report(1);
  return runs;
}

}  // namespace feedscope
