#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/models/guarantees.h"
#include "core/models/limit_traits.h"
#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// What a model is and what it promises.
struct ModelInfo {
  std::string id;
  std::string title;
  std::string reference;              ///< paper, or "" for a baseline
  std::string summary;                ///< two or three sentences
  std::vector<SettingSpec> settings;  ///< beyond those of common_settings()
  std::vector<std::string> uses;      ///< keys of common_settings() that it reads
  std::vector<Message> remarks;       ///< what Guarantees cannot say, one sentence each
  LimitTraits limits = {};            ///< for explanations
};

/// A program as a control reads it.
struct ControlReading {
  std::shared_ptr<const Toolpath> path;
  std::vector<Diagnostic> refused;  ///< lines that the control does not run, as notes of code "refused"
};

/// A published way in which a control turns a path into motion.
class ControlModel {
 public:
  virtual ~ControlModel() = default;
  virtual const ModelInfo& info() const = 0;
  /// What holds of every motion that simulate() makes with `settings`, as complete_settings gives them.
  virtual Guarantees guarantees(const Settings& settings) const = 0;
  /// Behaviour of the control on `path`, as the machine runs it, that the model does not simulate: one
  /// translatable sentence each.
  virtual std::vector<const char*> left_out(const Toolpath& /*path*/, const Settings& /*settings*/) const {
    return {};
  }
  /// What the control reads in the text of `toolpath`, where it reads it in a way of its own: its path and
  /// the lines that it refuses. Else `toolpath` as it is. Throws Cancelled when stopped.
  ControlReading read(std::shared_ptr<const Toolpath> toolpath, const Settings& settings,
                      const Progress* progress = nullptr) const {
    return toolpath->may_be_read() ? do_read(toolpath, settings, progress)
                                   : ControlReading{std::move(toolpath), {}};
  }
  /// Deterministic. `settings` as complete_settings gives them; the trajectory shares `toolpath`, or what
  /// read() and on_machine() make of it. Throws
  /// InputError if an axis that moves lacks a limit, Cancelled when stopped.
  Trajectory simulate(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
                      const Settings& settings, Progress* progress = nullptr) const;
  /// The same of a copy of `toolpath`.
  Trajectory simulate(const Toolpath& toolpath, const Machine& machine, const Settings& settings,
                      Progress* progress = nullptr) const;
  /// The path that simulate() runs, dwells included; what there is of the motion may be missing.
  Trajectory lay_path(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
                      const Settings& settings, Progress* progress = nullptr) const;

 private:
  using Run = std::function<Trajectory(const std::shared_ptr<const Toolpath>& path)>;
  /// `run` of `path`, collinear blocks merged if merge_collinear_mm asks for it, on the blocks of `path`.
  Trajectory on_merged(std::shared_ptr<const Toolpath> path, const Settings& settings, const Run& run) const;
  virtual ControlReading do_read(const std::shared_ptr<const Toolpath>& toolpath,
                                 const Settings& /*settings*/, const Progress* /*progress*/) const {
    return {toolpath, {}};
  }
  virtual Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                 const Settings& settings, Progress* progress) const = 0;
  /// Whether do_simulate() has another model run the path, which then merges its blocks.
  virtual bool takes_path_of_another() const { return false; }
  /// For models whose path does not hang on the motion.
  virtual Trajectory do_lay_path(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                 const Settings& settings, Progress* progress) const {
    return do_simulate(toolpath, machine, settings, progress);
  }
};

/// All models, in the order in which they are listed.
const std::vector<const ControlModel*>& all_models();
/// Throws InputError with the nearest id.
const ControlModel& find_model(std::string_view id);
/// The specs of every model's own settings, for reading machine files.
std::vector<SettingSpec> all_model_settings();
/// Specs of what `model` reads: common ones it uses, its own, then machine_settings().
const std::vector<SettingSpec>& settings_of(const ControlModel& model);

/// The settings of a run: fallbacks, then the machine's values; every key of settings_of(model) is there that
/// is not optional.
Settings complete_settings(const ControlModel& model, const Machine& machine);

/// The keys that apply_setting takes: those of settings_of(model), then "X.velocity" and the rest of
/// axis_specs().
std::vector<std::string> assignable_keys(const ControlModel& model);
/// The KEY of KEY=VALUE. Throws InputError if there is none.
std::string assigned_key(const std::string& assignment);
/// Applies KEY=VALUE of --set to machine ("X.jerk") or settings ("alpha"). Throws InputError naming key,
/// value, bounds and the nearest valid key.
void apply_setting(const std::string& assignment, const ControlModel& model, Machine& machine,
                   Settings& settings);

}  // namespace feedscope
