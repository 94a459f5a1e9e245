#pragma once

// Room `models`: control models, a folder each. A ControlModel puts blend, limits, feed and trajectory
// together as a paper or a control does, for all machines, and says what it guarantees; registry.cpp lists
// the models.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/progress.h"
#include "core/machine/machine.h"
#include "core/models/explanation/reason.h"
#include "core/models/guarantees.h"
#include "core/toolpath/machine_path.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// Description of a model and its promises.
struct ModelInfo {
  std::string id;
  std::string title;
  std::string reference;              ///< paper, or "" for a baseline
  std::string summary;                ///< two or three sentences
  std::vector<SettingSpec> settings;  ///< beyond those of common_settings()
  std::vector<std::string> uses;      ///< keys of common_settings() that it uses
  std::vector<Message> remarks;       ///< facts beyond Guarantees, one sentence each
  /// Corners are passed as programmed, so that the velocity of an axis jumps there.
  bool jumps_in_corners = false;
};

/// A program as a control reads it.
struct ControlReading {
  std::shared_ptr<const Toolpath> path;
  std::vector<Diagnostic> refused;  ///< lines that the control does not run, as notes of code "refused"
};

/// A published method by which a control turns a path into motion.
class ControlModel {
 public:
  virtual ~ControlModel() = default;
  virtual const ModelInfo& info() const = 0;
  /// Properties of every motion of simulate() with these `settings`, as from complete_settings().
  virtual Guarantees guarantees(const Settings& settings) const = 0;
  /// Behaviour of the control on `path`, as the machine runs it, that the model does not simulate: one
  /// translatable sentence each.
  virtual std::vector<const char*> left_out(const Toolpath& /*path*/, const Settings& /*settings*/) const {
    return {};
  }
  /// Path of the text of `programmed` in the control's own reading, where it has one, and the lines that it
  /// refuses. Otherwise `programmed` unchanged. Throws Cancelled when stopped.
  ControlReading read(std::shared_ptr<const Toolpath> programmed, const Settings& settings,
                      const Progress* progress = nullptr) const {
    return programmed->source ? do_read(programmed, settings, progress)
                              : ControlReading{std::move(programmed), {}};
  }
  /// Deterministic. `path`: made by on_machine() for this machine and these settings, as from
  /// complete_settings(); the trajectory shares it. Throws InputError if a moving axis lacks a limit,
  /// Cancelled when stopped.
  Trajectory simulate(const MachinePath& path, const Machine& machine, const Settings& settings,
                      Progress* progress = nullptr) const;
  /// The same for a programmed path, by read() and on_machine().
  Trajectory simulate(std::shared_ptr<const Toolpath> programmed, const Machine& machine,
                      const Settings& settings, Progress* progress = nullptr) const;
  /// The same for a copy of `programmed`.
  Trajectory simulate(const Toolpath& programmed, const Machine& machine, const Settings& settings,
                      Progress* progress = nullptr) const;
  /// The path of simulate(), including dwells; its motion may be incomplete.
  Trajectory lay_path(const MachinePath& path, const Machine& machine, const Settings& settings,
                      Progress* progress = nullptr) const;
  /// Why a motion of this model is not faster at `state`, one of its states, with the numbers of the limit
  /// there. Cost: a few elements around the place, up to some thousand on ramps over many short blocks.
  Explanation explain(const SimulatedMotion& motion, const State& state) const;

 private:
  using Run = std::function<Trajectory(const std::shared_ptr<const Toolpath>& path)>;
  /// Does `run` on `path`, with collinear blocks merged if merge_collinear_mm is set, and returns the result
  /// on the blocks of `path`.
  Trajectory on_merged(std::shared_ptr<const Toolpath> path, const Settings& settings, const Run& run) const;
  virtual ControlReading do_read(const std::shared_ptr<const Toolpath>& toolpath,
                                 const Settings& /*settings*/, const Progress* /*progress*/) const {
    return {toolpath, {}};
  }
  virtual Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                 const Settings& settings, Progress* progress) const = 0;
  /// True if do_simulate() makes another model run the path, which then merges its blocks.
  virtual bool takes_path_of_another() const { return false; }
  /// Default for models whose limits are the shared ones (explanation/explainer.h). The motion has pieces.
  virtual Explanation do_explain(const SimulatedMotion& motion, const State& state) const;
  /// Default for models whose path does not depend on the motion.
  virtual Trajectory do_lay_path(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                                 const Settings& settings, Progress* progress) const {
    return do_simulate(toolpath, machine, settings, progress);
  }
};

/// All models in listed order.
const std::vector<const ControlModel*>& all_models();
/// Throws InputError with the nearest id for an unknown one.
const ControlModel& find_model(std::string_view id);
/// The specs of every model's own settings, for reading machine files.
std::vector<SettingSpec> all_model_settings();
/// Specs of the settings used by `model`: common ones, its own, then machine_settings().
const std::vector<SettingSpec>& settings_of(const ControlModel& model);

/// Settings of a run: fallbacks, then the machine's values; contains every key of settings_of(model) that is
/// not optional.
Settings complete_settings(const ControlModel& model, const Machine& machine);

/// Keys for apply_setting(): those of settings_of(model), then "X.velocity" and the rest of axis_specs().
std::vector<std::string> assignable_keys(const ControlModel& model);
/// The KEY of KEY=VALUE. Throws InputError if there is none.
std::string assigned_key(const std::string& assignment);
/// Applies KEY=VALUE of --set to machine ("X.jerk") or settings ("alpha"). Throws InputError naming key,
/// value, bounds and the nearest valid key.
void apply_setting(const std::string& assignment, const ControlModel& model, Machine& machine,
                   Settings& settings);

}  // namespace feedscope
