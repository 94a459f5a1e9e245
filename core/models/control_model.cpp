#include "core/models/control_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/units.h"
#include "core/blend/compaction.h"
#include "core/drives/stop_waits.h"
#include "core/machine/contour_tolerance.h"
#include "core/models/explanation/explainer.h"
#include "core/trajectory/program_blocks.h"

namespace feedscope {
namespace {

/// A moving axis needs all its limits; a limit of 0 or less would divide by zero or never arrive.
void check_axes(const Toolpath& toolpath, const Machine& machine) {
  for (int j = 0; j < 3; ++j) {
    const char name = coordinate_names[static_cast<std::size_t>(j)];
    const AxisLimits* found = machine.axes.find(name);
    const AxisLimits axis = found == nullptr ? AxisLimits() : *found;
    const double least = std::min({axis.velocity, axis.acceleration, axis.jerk, axis.blend_jerk});
    const bool moves =
        !toolpath.segments.empty() &&
        (std::any_of(toolpath.segments.begin(), toolpath.segments.end(), [&](const Segment& s) {
          return s.kind == SegmentKind::arc || s.end[j] != toolpath.start[j];
        }));
    if (moves && !(least > 0)) {
      throw InputError(message(NC_("core",
                                   "machine '{}': axis {} moves in this program, but one of its limits is "
                                   "{}; every limit of an axis that moves must be above 0"),
                               machine.id, name, least));
    }
  }
}

std::string axis_key(char axis, const SettingSpec& spec) {
  return fmt::format("{}.{}", axis, spec.key);
}

}  // namespace

Trajectory ControlModel::simulate(const MachinePath& path, const Machine& machine, const Settings& settings,
                                  Progress* progress) const {
  check_axes(*path, machine);
  Trajectory motion = on_merged(path.toolpath, settings, [&](const std::shared_ptr<const Toolpath>& merged) {
    return do_simulate(merged, machine, settings, progress);
  });
  const double window = settings.has(exact_stop_window_key) ? settings.number(exact_stop_window_key) : 0;
  return window > 0 ? with_stop_waits(std::move(motion), machine, units::from_um(window), progress) : motion;
}

Trajectory ControlModel::simulate(std::shared_ptr<const Toolpath> programmed, const Machine& machine,
                                  const Settings& settings, Progress* progress) const {
  return simulate(
      on_machine(read(std::move(programmed), settings, progress).path, machine, settings, progress), machine,
      settings, progress);
}

Trajectory ControlModel::simulate(const Toolpath& programmed, const Machine& machine,
                                  const Settings& settings, Progress* progress) const {
  return simulate(std::make_shared<const Toolpath>(programmed), machine, settings, progress);
}

Trajectory ControlModel::lay_path(const MachinePath& path, const Machine& machine, const Settings& settings,
                                  Progress* progress) const {
  check_axes(*path, machine);
  return on_merged(path.toolpath, settings, [&](const std::shared_ptr<const Toolpath>& merged) {
    return do_lay_path(merged, machine, settings, progress);
  });
}

Trajectory ControlModel::on_merged(std::shared_ptr<const Toolpath> path, const Settings& settings,
                                   const Run& run) const {
  const double tolerance = settings.has(merge_collinear_key) ? settings.number(merge_collinear_key) : 0;
  if (!(tolerance > 0) || takes_path_of_another()) {
    return run(path);
  }
  const auto merged = std::make_shared<const CompactedPath>(merge_collinear(*path, tolerance));
  if (merged->path.segments.size() == path->segments.size()) {
    return run(path);
  }
  return on_program_blocks(run({merged, &merged->path}), std::move(path), merged);
}

const ControlModel& find_model(std::string_view id) {
  std::vector<std::string> ids;
  for (const ControlModel* model : all_models()) {
    if (model->info().id == id) {
      return *model;
    }
    ids.push_back(model->info().id);
  }
  const std::string near = nearest_name(id, ids);
  const std::string known = fmt::to_string(fmt::join(ids, ", "));
  throw InputError(
      near.empty()
          ? message(NC_("core", "unknown model '{}'; known models: {}"), id, known)
          : message(NC_("core", "unknown model '{}'; did you mean '{}'? known models: {}"), id, near, known));
}

std::vector<SettingSpec> all_model_settings() {
  std::vector<SettingSpec> specs;
  for (const ControlModel* model : all_models()) {
    for (const SettingSpec& spec : model->info().settings) {
      const bool known =
          std::any_of(specs.begin(), specs.end(), [&](const SettingSpec& s) { return s.key == spec.key; });
      if (!known) {
        specs.push_back(spec);
      }
    }
  }
  return specs;
}

namespace {

std::vector<SettingSpec> collect_settings(const ControlModel& model) {
  const ModelInfo& info = model.info();
  std::vector<SettingSpec> specs;
  std::copy_if(common_settings().begin(), common_settings().end(), std::back_inserter(specs),
               [&](const SettingSpec& spec) {
                 return std::find(info.uses.begin(), info.uses.end(), spec.key) != info.uses.end();
               });
  specs.insert(specs.end(), info.settings.begin(), info.settings.end());
  specs.insert(specs.end(), machine_settings().begin(), machine_settings().end());
  return specs;
}

}  // namespace

const std::vector<SettingSpec>& settings_of(const ControlModel& model) {
  static const auto known = [] {
    std::map<const ControlModel*, std::vector<SettingSpec>> specs;
    for (const ControlModel* one : all_models()) {
      specs.emplace(one, collect_settings(*one));
    }
    return specs;
  }();
  return known.at(&model);
}

Settings complete_settings(const ControlModel& model, const Machine& machine) {
  Settings settings;
  for (const SettingSpec& spec : settings_of(model)) {
    const auto given = machine.settings.values().find(spec.key);
    if (given != machine.settings.values().end()) {
      settings.set(spec.key, given->second);
    } else if (spec.optional) {
      continue;
    } else if (spec.choices.empty()) {
      settings.set(spec.key, spec.fallback);
    } else {
      settings.set(spec.key, spec.choices.front());
    }
  }
  return settings;
}

std::vector<std::string> assignable_keys(const ControlModel& model) {
  std::vector<std::string> keys;
  for (const SettingSpec& spec : settings_of(model)) {
    keys.push_back(spec.key);
  }
  for (const char axis : possible_axes) {
    for (const SettingSpec& spec : axis_specs_of(axis)) {
      keys.push_back(axis_key(axis, spec));
    }
  }
  return keys;
}

std::string assigned_key(const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(fmt::format("setting '{}' has no value; write KEY=VALUE, as in X.jerk=20", assignment));
  }
  return assignment.substr(0, equals);
}

void apply_setting(const std::string& assignment, const ControlModel& model, Machine& machine,
                   Settings& settings) {
  const std::string key = assigned_key(assignment);
  const std::string value = assignment.substr(key.size() + 1);
  for (const SettingSpec& spec : settings_of(model)) {
    if (spec.key == key) {
      settings.set(key, parse_setting(spec, value));
      return;
    }
  }
  for (const char axis : possible_axes) {
    for (const SettingSpec& known : axis_specs_of(axis)) {
      SettingSpec spec = known;
      spec.key = axis_key(axis, known);
      if (spec.key == key) {
        set_axis_value(machine, axis, known.key, parse_setting(spec, value));
        return;
      }
    }
  }
  const std::vector<std::string> keys = assignable_keys(model);
  const std::string near = nearest_name(key, keys);
  throw InputError(fmt::format("setting '{}' is unknown to model '{}'; {}known settings: {}", key,
                               model.info().id, near.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                               fmt::join(keys, ", ")));
}

Explanation ControlModel::explain(const SimulatedMotion& motion, const State& state) const {
  return motion.trajectory.pieces().empty() ? Explanation{state, {}, {}} : do_explain(motion, state);
}

Explanation ControlModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return Explainer(motion).explain(state);
}

}  // namespace feedscope
