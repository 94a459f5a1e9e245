#include "core/analysis/time/program_changes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/analysis/contour/contour_errors.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/run/control_dialect.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/machine/contour_tolerance.h"
#include "core/program/dialect.h"

namespace feedscope {
namespace {

constexpr std::size_t most_causes = 5;
constexpr double worth_a_change = 0.01;  // of the cycle time lost by a cause

/// Causes that lose most. The programmed feed is covered by the override that remedies() adds.
std::vector<Cause> causes_to_change(const TimeUse& use) {
  std::vector<Cause> causes;
  for (const CauseCost& cost : use.causes) {
    if (causes.size() < most_causes && !is_pause(cost.cause.kind) &&
        cost.lost > worth_a_change * use.cycle_time) {
      causes.push_back(cost.cause);
    }
  }
  return causes;
}

bool has_larger_limit(const Machine& machine, const Machine& than) {
  for (const AxisInfo& axis : than.axes.axes()) {
    for (const SettingSpec& spec : axis_limit_specs()) {
      if (machine.axes.find(axis.name) != nullptr &&
          axis_limit(machine, axis.name, spec.key) > axis_limit(than, axis.name, spec.key)) {
        return true;
      }
    }
  }
  return false;
}

/// Whether the programs of one machine run on the other, as far as their controls are known.
bool reads_the_same(const Machine& machine, const Machine& as) {
  return std::ranges::all_of(all_dialects(), [&](const DialectInfo& dialect) {
    return !control_reads(as, dialect.dialect).value_or(false) ||
           control_reads(machine, dialect.dialect).value_or(true);
  });
}

/// Zero of a work offset; none if the machine file has none.
std::optional<Vec3> zero_of(const Machine& machine, const std::string& offset) {
  const auto found = machine.work_offsets.all().find(offset);
  return found == machine.work_offsets.all().end() ? std::nullopt : std::optional(found->second);
}

/// Whether the machine's own control runs every line of the run, and the program was read as on it.
bool runs_as_much(const Machine& machine, const Run& run) {
  SetupRequest request;
  request.machine = machine.id;
  return std::ranges::all_of(run.input.program->work_offsets,
                             [&](const OffsetUse& use) {
                               return zero_of(machine, use.name) == zero_of(run.setup.machine, use.name);
                             }) &&
         std::ranges::includes(run.lines_not_run, refused_lines(run.input, make_setup(request)), {},
                               &Diagnostic::line, &Diagnostic::line);
}

std::vector<Remedy> other_machines(const Run& run) {
  const Setup& setup = run.setup;
  std::vector<Remedy> found;
  const MachineLibrary library = shipped_machines();
  for (const std::string& id : library.ids()) {
    const Machine machine = library.load(id);
    if (id != setup.machine.id && reads_the_same(machine, setup.machine) &&
        axis_names(machine) == axis_names(setup.machine) && has_larger_limit(machine, setup.machine) &&
        runs_as_much(machine, run)) {
      Remedy remedy;
      remedy.machine = id;
      found.push_back(std::move(remedy));
    }
  }
  return found;
}

/// Combines two changes.
Remedy joined(Remedy first, const Remedy& second) {
  first.changes.insert(first.changes.end(), second.changes.begin(), second.changes.end());
  first.before = first.before ? first.before : second.before;
  return first;
}

/// A change with its motion; no motion if it failed or is not simulated yet.
struct Trial {
  TriedChange change;
  std::optional<Trajectory> motion;
};

/// Simulates the change unless its motion exists.
void complete(Trial& trial, const Run& run, bool with_error, Progress* progress) {
  TriedChange& change = trial.change;
  try {
    if (!trial.motion) {
      trial.motion = try_remedy(run.input, run.setup, change.remedy, progress);
      change.cycle_time = trial.motion->duration();
    }
    if (with_error) {
      const ContourErrors errors = contour_errors(*trial.motion, {1}, progress);
      change.max_contour_error = errors.largest;
      change.cutting_contour_error = cutting_contour_error(*trial.motion, errors, {}, progress);
    }
  } catch (const InputError& error) {
    change.failure = error.what();
    trial.motion.reset();
  }
}

/// Motions of the best changes so far, each of another kind. They include those of best_of(): a change only
/// moves down as others come in.
class BestMotions {
 public:
  /// `place`: index in the order of the changes; of equal times the first is better.
  void offer(std::size_t place, Trial trial) {
    if (!trial.motion) {
      return;
    }
    Kept offered{trial.change.cycle_time, place, kind_of(trial.change.remedy), std::move(*trial.motion)};
    const std::lock_guard lock(mutex_);
    const auto same = std::ranges::find(kept_, offered.kind, &Kept::kind);
    if (same != kept_.end() && rank(*same) < rank(offered)) {
      return;
    }
    if (same != kept_.end()) {
      kept_.erase(same);
    }
    kept_.insert(std::ranges::upper_bound(kept_, rank(offered), {}, rank), std::move(offered));
    if (kept_.size() > ChangeTrials::most) {
      kept_.pop_back();
    }
  }
  Trajectory take(std::size_t place) {
    return std::move(std::ranges::find(kept_, place, &Kept::place)->motion);
  }

 private:
  struct Kept {
    double cycle_time;  ///< [s]
    std::size_t place;
    std::string kind;
    Trajectory motion;
  };
  static std::pair<double, std::size_t> rank(const Kept& kept) { return {kept.cycle_time, kept.place}; }

  std::mutex mutex_;
  std::vector<Kept> kept_;  ///< best first
};

/// Best change of each kind, by gain.
std::vector<std::size_t> best_of(const std::vector<TriedChange>& tried, double cycle_time) {
  std::vector<std::size_t> best;
  std::set<std::string> kinds;
  for (std::size_t i = 0; i < tried.size() && best.size() < ChangeTrials::most; ++i) {
    const bool helps =
        tried[i].failure.empty() && cycle_time - tried[i].cycle_time > ChangeTrials::worth_it * cycle_time;
    if (helps && kinds.insert(kind_of(tried[i].remedy)).second) {
      best.push_back(i);
    }
  }
  return best;
}

}  // namespace

int decimals_of_gain(double seconds) {
  const double size = std::abs(seconds);
  return size < 1 ? 3 : size < 1000 ? 1 : 0;
}

std::string kind_of(const Remedy& remedy) {
  if (!remedy.machine.empty()) {
    return "machine";
  }
  const std::string& key = remedy.changes.front().first;
  if (is_tolerance(key)) {
    return "tolerance";
  }
  if (key == feed_override_key) {
    return "feed";
  }
  const bool of_axis = key.size() > 2 && key[1] == '.';
  const std::string limit = of_axis ? key.substr(2) : key;
  return limit == "blend_jerk" ? "jerk" : limit;
}

std::vector<Remedy> changes_worth_trying(const Run& run, const TimeUse& use) {
  std::vector<Remedy> changes = remedies(run.setup, causes_to_change(use), run.input.feed_controls);
  const std::vector<Remedy> machines = other_machines(run);
  changes.insert(changes.end(), machines.begin(), machines.end());
  return changes;
}

ChangeTrials try_changes(const Run& run, const std::vector<Remedy>& changes, Progress* progress,
                         const std::function<void(std::size_t, const TriedChange&)>& tell) {
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  const auto steps = static_cast<double>(changes.size() + ChangeTrials::most + 1);
  const auto try_one = [&](Trial& trial, bool with_error) {
    Progress part(whole, 1 / steps);
    part.report(0);
    complete(trial, run, with_error, &part);
    part.report(1);
  };
  std::vector<TriedChange> tried(changes.size());
  BestMotions motions;
  in_parallel(changes.size(), [&](std::size_t i) {
    Trial trial;
    trial.change.remedy = changes[i];
    try_one(trial, false);
    tried[i] = trial.change;
    motions.offer(i, std::move(trial));
    if (tell) {
      tell(i, tried[i]);
    }
  });
  std::vector<std::size_t> order(changes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return tried[i].failure.empty() ? tried[i].cycle_time : std::numeric_limits<double>::infinity();
  });
  ChangeTrials trials;
  std::ranges::transform(order, std::back_inserter(trials.tried), [&](std::size_t i) { return tried[i]; });
  trials.best = best_of(trials.tried, run.trajectory->duration());
  std::vector<Trial> best;
  Remedy together;
  std::size_t joins = 0;
  for (const std::size_t i : trials.best) {
    best.push_back({trials.tried[i], motions.take(order[i])});
    if (const Remedy& remedy = trials.tried[i].remedy; remedy.machine.empty()) {
      together = joined(std::move(together), remedy);
      ++joins;
    }
  }
  if (joins > 1) {
    best.emplace_back();
    best.back().change.remedy = std::move(together);
  }
  in_parallel(best.size(), [&](std::size_t i) { try_one(best[i], true); });
  for (std::size_t i = 0; i < trials.best.size(); ++i) {
    trials.tried[trials.best[i]] = best[i].change;
  }
  if (joins > 1) {
    trials.together = best.back().change;
  }
  whole.report(1);
  return trials;
}

}  // namespace feedscope
