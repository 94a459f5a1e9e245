#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"

namespace feedscope {

/// Work offsets in the machine file that the program uses but was not read with, as when several machines run
/// it: "G54, G55"; empty if none.
std::string unused_work_offsets(const Program& program, const Machine& machine);

/// A drive that overshoots a step by a tenth or more.
struct PoorDamping {
  char axis = ' ';
  double overshoot = 0;  ///< as drive_overshoot()
};
std::vector<PoorDamping> poorly_damped(const Machine& machine);
/// Axes without a drive on a machine with drives: "Z", "X and Z"; empty if all or none have one.
std::string axes_without_drive(const Machine& machine);
/// Notes on damping and missing drives, one sentence each.
std::vector<Message> drive_notes(const Machine& machine);

/// For a model with ramps but without a jerk limit: which largest values it lacks; else null. Translatable.
const char* jump_note(const Setup& setup);

/// For a model whose jerk limit ignores the limits of the axes: that these may be exceeded; else null.
/// Translatable.
const char* limits_note(const Setup& setup);
/// For rotary axes that turn under tool centre point control: whose motion the figures of X, Y and Z are;
/// else null. Translatable.
const char* tip_note(const Toolpath& path);

/// For rotary axes that turn along feed motions: that the model does not respect their limits fully, or which
/// of them it exceeds near block transitions; else null. Translatable.
const char* rotary_limits_note(const Toolpath& path, const Setup& setup);
/// For a program that turns rotary axes on a machine without any; else null. Translatable.
const char* missing_axes_note(const Toolpath& path, const Machine& machine);
/// The notes above that apply, in a fixed order, then ControlModel::left_out(); `path`: as the machine runs
/// it.
std::vector<const char*> figure_notes(const Toolpath& path, const Setup& setup);

/// Largest feed of `program`, with the override of the setup, if the machine cannot reach it in any
/// direction; `path`: as the machine runs it.
std::optional<UnreachableFeed> feed_beyond_machine(const LoadedProgram& program, const Toolpath& path,
                                                   const Setup& setup);

/// First of the most severe faults; `faults` must not be empty.
const Diagnostic& most_severe(const std::vector<Diagnostic>& faults);
/// Faults of the machine on the program, in one sentence; empty if there are none.
Message machine_fault_note(const std::vector<Diagnostic>& faults);

/// Notes on a run that restrict the use of its figures, one sentence each: a control that does not read the
/// program's dialect, work offsets of the machine that the program was not read with, ignored_path_control(),
/// refused_note(), jump_note(), a tolerance that Heidenhain advises against, feed_beyond_machine(), then
/// drive_notes().
std::vector<Message> run_notes(const LoadedProgram& program, const Setup& setup);

}  // namespace feedscope
