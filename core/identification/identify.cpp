#include "core/identification/identify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/identification/parameter_judgement.h"
#include "core/identification/parameter_search.h"
#include "core/identification/telling_parts.h"
#include "core/identification/trace_limits.h"

namespace feedscope {
namespace {

constexpr double most_feed_error = 0.05;
constexpr double most_time_error = 0.01;

constexpr double beyond_reach = 1.05;  // samples miss a velocity slightly

/// Progress at the start of the reported stages.
constexpr double alone_from = 0.02;
constexpr double together_from = 0.4;
constexpr double refined_from = 0.7;
constexpr double doubted_from = 0.85;
constexpr double judged_from = 0.95;
constexpr std::array stage_titles{
    std::pair(judged_from, QT_TRANSLATE_NOOP("core", "uncertainties")),
    std::pair(doubted_from, QT_TRANSLATE_NOOP("core", "whether another number can stand for it")),
    std::pair(refined_from, QT_TRANSLATE_NOOP("core", "all numbers, refined")),
    std::pair(together_from, QT_TRANSLATE_NOOP("core", "all numbers together")),
    std::pair(alone_from, QT_TRANSLATE_NOOP("core", "each number alone")),
    std::pair(0.0, QT_TRANSLATE_NOOP("core", "what the axes reach"))};

constexpr const char* unexplained = QT_TRANSLATE_NOOP(
    "core", "The model does not explain the traces: a value of it would say nothing of the machine.");

/// Setup with velocities, accelerations and jerks as reached in the traces.
Setup begun_with_reach(const FitCases& cases, Setup setup, const std::vector<FitParameter>& parameters) {
  AxisVector<AxisReach> most(setup.machine.axes.axes());
  for (const auto& one : cases) {
    const AxisVector<AxisReach> reach = one->reach();
    for (std::size_t axis = 0; axis < std::min(most.size(), reach.size()); ++axis) {
      most[axis].velocity = std::max(most[axis].velocity, reach[axis].velocity);
      most[axis].acceleration = std::max(most[axis].acceleration, reach[axis].acceleration);
      most[axis].jerk = std::max(most[axis].jerk, reach[axis].jerk);
    }
  }
  for (const FitParameter& parameter : parameters) {
    const auto axis = setup.machine.axes.axes().find(parameter.key.front());
    if (parameter.key.find('.') == std::string::npos || !axis || most[*axis].velocity <= 0) {
      continue;
    }
    const AxisReach& reach = most[*axis];
    const double value = parameter.key.ends_with(".velocity") ? beyond_reach * units::to_m_min(reach.velocity)
                         : parameter.key.ends_with(".acceleration") ? units::to_m(reach.acceleration)
                                                                    : units::to_m(reach.jerk);
    if (value > 0) {
      set_fit_value(setup, parameter, value);
    }
  }
  return setup;
}

/// Resolves ambiguities between speed limits: releases each in turn, lets each other one take its place, fits
/// all again, and keeps the result if it explains the traces better. Returns the smallest cost without each
/// parameter; infinite where none was tried.
std::vector<double> release_speeds(ParameterSearch& search, std::vector<bool> free) {
  constexpr double out_of_the_way = 3;
  constexpr double better = 0.999;
  constexpr int steps = 4;
  std::vector<std::size_t> speeds;
  for (std::size_t p = 0; p < search.size(); ++p) {
    if (search.parameters()[p].unit == "m/min") {
      speeds.push_back(p);
      free[p] = true;
    }
  }
  std::vector<double> without(search.size(), std::numeric_limits<double>::infinity());
  const std::size_t pairs = speeds.size() * speeds.size();
  search.stage(doubted_from, 0.93, pairs * (25 + static_cast<std::size_t>(steps) * (2 * search.size() + 5)));
  for (const std::size_t p : speeds) {
    for (const std::size_t q : speeds) {
      if (p == q) {
        continue;
      }
      const Eigen::VectorXd before = search.logarithms();
      const double cost_before = ParameterSearch::cost(search.evaluate(before));
      Eigen::VectorXd released = before;
      released[static_cast<Eigen::Index>(p)] += std::log(out_of_the_way);
      if (ParameterSearch::cost(search.evaluate(released)) <= cost_before) {
        search.move_to(before);
        break;  // limits nothing
      }
      search.move_to(released);
      search.scan_one(q, 2, 1.09);
      search.scan_one(q, 1.05, 1.012);
      search.refine(free, steps);
      const double cost_after = ParameterSearch::cost(search.evaluate(search.logarithms()));
      if (cost_after > better * cost_before) {
        search.move_to(before);
        without[p] = std::min(without[p], cost_after);
      } else {
        without[q] = std::min(without[q], cost_before);
      }
    }
  }
  return without;
}

/// Resolves limits slightly below the need of a motion but beyond its reach, which look determined while
/// others replace them: releases each acceleration and jerk, searches the velocity of its axis, which may
/// have been too high, fits the others again, and keeps the result if it explains the traces better. Lowers
/// `without` as release_speeds() does.
void release_ramps(ParameterSearch& search, const std::vector<bool>& free, std::vector<double>& without) {
  constexpr double out_of_the_way = 1.5;
  constexpr double better = 0.999;
  constexpr int steps = 3;
  search.stage(0.93, judged_from, search.size() * (25 + steps * (2 * search.size() + 5)));
  for (std::size_t p = 0; p < search.size(); ++p) {
    const std::string& key = search.parameters()[p].key;
    if (!key.ends_with(".acceleration") && !key.ends_with(".jerk")) {
      continue;
    }
    const Eigen::VectorXd before = search.logarithms();
    const double cost_before = ParameterSearch::cost(search.evaluate(before));
    Eigen::VectorXd released = before;
    released[static_cast<Eigen::Index>(p)] += std::log(out_of_the_way);
    search.move_to(released);
    std::vector<bool> others = free;
    others[p] = false;
    for (std::size_t q = 0; q < search.size(); ++q) {
      if (search.parameters()[q].key == key.substr(0, key.find('.')) + ".velocity") {
        search.scan_one(q, 2, 1.09);
        search.scan_one(q, 1.05, 1.012);
        others[q] = true;
      }
    }
    search.refine(others, steps);
    const double cost_after = ParameterSearch::cost(search.evaluate(search.logarithms()));
    without[p] = std::min(without[p], cost_after);
    if (cost_after > better * cost_before) {
      search.move_to(before);
    }
  }
}

std::vector<bool> all_but(std::vector<bool> some) {
  some.flip();
  return some;
}

/// Adds `others`, except `without`.
void add(std::vector<bool>& some, const std::vector<bool>& others, const std::vector<bool>& without) {
  for (std::size_t i = 0; i < some.size(); ++i) {
    some[i] = (some[i] || others[i]) && !without[i];
  }
}

/// Evaluations of a joint search: as many as short programs allow, fewer for long ones.
std::size_t searched_together(const FitCases& cases, const Setup& start, std::size_t most,
                              Progress* progress) {
  constexpr double few = 300;
  constexpr double of_all = 8000;  // [s] of programs in total
  double seconds = 0;
  for (const auto& one : cases) {
    Progress unwatched;
    Progress part(progress != nullptr ? *progress : unwatched, unseen_share);
    seconds +=
        start.model->simulate(one->program().toolpath, start.machine, start.settings, &part).duration();
  }
  const auto limit = static_cast<double>(most);
  return static_cast<std::size_t>(std::clamp(of_all / std::max(seconds, 1e-3), std::min(few, limit), limit));
}

/// Searches all numbers together, from the present values and from the reach of the traces: several wrong
/// numbers create local minima that no successive search leaves. Unless both searches end in noise alone,
/// continues near the better one as long as that helps.
void search_jointly(ParameterSearch& search, const std::vector<bool>& free, const Eigen::VectorXd& reached,
                    std::size_t most) {
  constexpr double spread = 0.4;  // of the logarithms
  constexpr double narrow = 0.2;
  constexpr double better = 0.98;
  constexpr int most_rounds = 3;
  if (std::ranges::count(free, true) < 2) {
    return;  // nothing can replace another number
  }
  const auto cost_here = [&] { return ParameterSearch::cost(search.evaluate(search.logarithms())); };
  search.search_widely(free, spread, most);
  const Eigen::VectorXd first = search.logarithms();
  const double first_cost = cost_here();
  search.move_to(reached);
  search.search_widely(free, spread, most);
  const double second_cost = cost_here();
  if (second_cost > first_cost) {
    search.move_to(first);
  }
  if (leaves_noise_alone(search) &&
      better * std::max(first_cost, second_cost) < std::min(first_cost, second_cost)) {
    return;  // both searches lead there
  }
  for (int round = 0; round < most_rounds; ++round) {
    const double least = cost_here();
    search.scan(8, 1.19, free);
    search.scan(1.19, 1.03, free);
    search.search_widely(free, narrow, most);
    if (cost_here() > better * least) {
      break;
    }
  }
  for (const double fine : {0.05, 0.0125}) {
    double least = cost_here();
    for (int round = 0; round < most_rounds; ++round) {
      search.search_widely(free, fine, most);
      const double found = cost_here();
      if (found > better * std::exchange(least, found)) {
        break;
      }
    }
  }
}

/// Tries likely values: the start value of a number if it is close, and for a velocity the largest one in the
/// traces. A number that acts in steps, and others that compensate for it, have their own local minimum, as
/// has a limit beyond all motion. `begun`, `reached`: logarithms.
void try_likely(ParameterSearch& search, const std::vector<bool>& free, const Eigen::VectorXd& begun,
                const Eigen::VectorXd& reached, std::size_t most) {
  const double close = std::log(1.5);
  constexpr double same = 1e-9;
  constexpr double spread = 0.03;
  constexpr double better_at_once = 0.9999;
  constexpr double better = 0.98;
  const auto cost_here = [&] { return ParameterSearch::cost(search.evaluate(search.logarithms())); };
  const auto try_value = [&](std::size_t p, double value) {
    const Eigen::VectorXd before = search.logarithms();
    const auto place = static_cast<Eigen::Index>(p);
    const double away = std::abs(before[place] - value);
    if (away < same) {
      return;
    }
    const double least = cost_here();
    Eigen::VectorXd at = before;
    at[place] = value;
    search.move_to(at);
    if (cost_here() < better_at_once * least) {
      return;
    }
    if (free[p] && away < close) {
      std::vector<bool> others = free;
      others[p] = false;
      search.search_widely(others, spread, most);
      if (cost_here() < better * least) {
        return;
      }
    }
    search.move_to(before);
  };
  for (std::size_t p = 0; p < search.size(); ++p) {
    const FitParameter& parameter = search.parameters()[p];
    const auto place = static_cast<Eigen::Index>(p);
    try_value(p, begun[place]);
    if (parameter.key.ends_with(".velocity")) {
      try_value(p, reached[place] - std::log(beyond_reach));
    }
  }
}

std::string names_of(const FitCases& cases) {
  std::string names;
  for (const auto& one : cases) {
    names += (names.empty() ? "" : ", ") + one->name();
  }
  return names;
}

/// Leaves a local minimum: whether a control inserts blends depends on its tolerance, which creates several
/// minima some percent wide. Varies each number from half to double, with the others at their present values.
void leave_hollow(ParameterSearch& search, const std::vector<bool>& free, int most_steps) {
  constexpr double reach = 2;
  constexpr double ratio = 1.06;
  constexpr double fine_reach = 1.05;
  constexpr int most_rounds = 4;
  search.stage(0.8, doubted_from, search.size() * 25);
  double least = ParameterSearch::cost(search.evaluate(search.logarithms()));
  for (int round = 0; round < most_rounds; ++round) {
    search.scan(reach, ratio);
    const double found = ParameterSearch::cost(search.evaluate(search.logarithms()));
    constexpr double deeper = 0.99;
    if (found > deeper * least) {
      return;
    }
    search.refine(free, most_steps);
    search.scan(fine_reach, std::sqrt(std::sqrt(fine_reach)));
    search.refine(free, most_steps);
    least = ParameterSearch::cost(search.evaluate(search.logarithms()));
  }
}

/// Finds the parts of the test program that would determine the remaining numbers: its limits may differ from
/// those of the traces.
void say_what_tells(const Setup& setup, std::vector<IdentifiedParameter>& parameters) {
  std::vector<FitParameter> untold;
  for (const IdentifiedParameter& one : parameters) {
    if (!one.told) {
      untold.push_back(one.parameter);
    }
  }
  const std::vector<std::string> parts = telling_parts(setup, untold);
  auto part = parts.begin();
  for (IdentifiedParameter& one : parameters) {
    if (!one.told) {
      one.told_by = *part++;
    }
  }
}

/// `start`: the original setup, whose sources remain with unchanged values.
void write_sources(Setup& setup, const Setup& start, const std::vector<IdentifiedParameter>& parameters,
                   bool explains, const std::string& from) {
  setup.machine.model = setup.model->info().id;
  const Provenance set_by_hand{"set by hand", false};
  const Provenance usual_value{"usual value of the model", true};
  const Settings known = complete_settings(*setup.model, start.machine);
  for (const auto& [key, value] : setup.settings.values()) {
    if (known.value(key) != value) {
      setup.machine.settings.set(key, value);
      setup.machine.provenance.insert_or_assign(key, set_by_hand);
    }
  }
  for (const IdentifiedParameter& one : parameters) {
    const std::string& key = one.parameter.key;
    if (key.find('.') == std::string::npos) {
      setup.machine.settings.set(key, setup.settings.value(key));
    }
    const auto before = start.machine.provenance.find(key);
    const bool was_set = start.settings.has(key) && known.value(key) != start.settings.value(key);
    const Provenance of_start = was_set                                    ? set_by_hand
                                : before != start.machine.provenance.end() ? before->second
                                                                           : usual_value;
    setup.machine.provenance.insert_or_assign(key, one.told   ? identified_source(one, from)
                                                   : explains ? undetermined_source(one, from, of_start)
                                                              : of_start);
  }
}

/// Simulates the result and compares it with the recordings.
void lay_beside(const FitCases& cases, Identification& found, Progress* progress) {
  found.explains = true;
  for (const auto& one : cases) {
    Progress unwatched;
    Progress part(progress != nullptr ? *progress : unwatched, unseen_share);
    Run run = simulate_run(one->program(), found.setup, &part);
    FitResult result = one->result(run, &part);
    found.feed_error = std::max(found.feed_error, result.feed_error);
    const double off = std::abs(result.agreement.simulated_time - result.agreement.measured_time);
    const double most = std::max(most_time_error * result.agreement.measured_time, result.resolution);
    found.explains =
        found.explains && result.feed_error <= most_feed_error && (!result.time_known || off <= most);
    found.runs.push_back(std::move(run));
    found.agreements.push_back(std::move(result.agreement));
    found.sections.push_back(std::move(result.sections));
  }
}

/// Residual of the present setup of the search.
double residual_of(ParameterSearch& search) {
  const Eigen::VectorXd residuals = search.evaluate(search.logarithms());
  return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
}

}  // namespace

Identification identify(const FitCases& cases, const Setup& start,
                        const std::vector<FitParameter>& parameters, const IdentifyOptions& options,
                        Progress* progress) {
  if (cases.empty()) {
    throw InputError(NC_("core", "identification needs at least one trace"));
  }
  if (parameters.empty()) {
    ParameterSearch search(cases, start, {}, progress);
    Identification found;
    found.setup = start;
    found.residual = residual_of(search);
    lay_beside(cases, found, progress);
    found.simulations = search.simulations();
    return found;
  }
  std::vector<double> begun;
  for (const FitParameter& parameter : parameters) {
    begun.push_back(fit_value(start, parameter));
  }
  ParameterSearch search(cases, start, parameters, progress);
  const Eigen::VectorXd as_it_is = search.logarithms();
  const Eigen::VectorXd reached =
      ParameterSearch(cases, begun_with_reach(cases, start, parameters), parameters, nullptr).logarithms();
  const std::vector<Eigen::VectorXd> both = search.evaluate_all({as_it_is, reached});
  search.move_to(ParameterSearch::cost(both[0]) <= ParameterSearch::cost(both[1]) ? as_it_is : reached);
  const std::size_t count = parameters.size();
  search.stage(alone_from, together_from, count * (7 + 9 + 9 + 4 + 4));
  const std::vector<bool> by_steps = acting_by_steps(search);
  const std::vector<bool> smooth = all_but(by_steps);
  search.scan(8, 2, smooth);
  search.scan(2, 1.19, smooth);
  search.scan(1.2, 1.047, smooth);
  std::vector<bool> free = influences(search);
  {
    const Eigen::VectorXd scanned = search.logarithms();
    search.move_to(reached);
    add(free, influences(search), by_steps);
    search.move_to(scanned);
  }
  const std::size_t together = searched_together(cases, search.setup(), options.most_searched, progress);
  search.stage(together_from, refined_from, 3 * together);
  search_jointly(search, free, reached, together);
  try_likely(search, free, as_it_is, reached, together);
  constexpr double near = 1.1;
  constexpr std::size_t most_near = 100;
  search.search_together(free, near, most_near);
  free = influences(search);
  constexpr int most_steps = 10;
  search.stage(refined_from, 0.8, 2 * static_cast<std::size_t>(most_steps) * (2 * count + 5) + count * 18);
  for (const double reach : {1.05, 1.01}) {  // away from the kinks at limits, to the minimum
    search.refine(free, most_steps);
    search.scan(reach, std::sqrt(std::sqrt(reach)));
  }
  leave_hollow(search, free, most_steps);
  search.refine(free, most_steps);
  std::vector<double> without = release_speeds(search, free);
  release_ramps(search, free, without);
  search.refine(influences(search), most_steps);
  search.stage(judged_from, 1, 6 * count);
  Identification found;
  found.parameters = judge_parameters(search, begun, without);
  take_back(search, found.parameters);
  add_reached_velocities(found.parameters, cases);
  found.setup = search.setup();
  found.residual = residual_of(search);
  lay_beside(cases, found, progress);
  if (found.explains) {
    say_what_tells(found.setup, found.parameters);
  } else {
    for (IdentifiedParameter& one : found.parameters) {
      one.told = false;
      one.uncertainty = 0;
      one.reason = unexplained;
      one.at_least.reset();
    }
  }
  write_sources(found.setup, start, found.parameters, found.explains,
                names_of(cases) + (options.date.empty() ? "" : ", " + options.date));
  found.simulations = search.simulations();
  return found;
}

std::string identification_stage(double fraction) {
  return std::ranges::find_if(stage_titles, [&](const auto& stage) { return fraction >= stage.first; })
      ->second;
}

}  // namespace feedscope
