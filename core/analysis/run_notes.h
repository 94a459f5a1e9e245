#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/analysis/run.h"

namespace feedscope {

/// The work offsets that the machine file gives and the program uses, but was not read with, as it is when
/// several machines run it: "G54, G55"; empty: none.
std::string unused_work_offsets(const Program& program, const Machine& machine);

/// A drive that overshoots a step by a tenth or more.
struct PoorDamping {
  char axis = ' ';
  double overshoot = 0;  ///< as drive_overshoot()
};
std::vector<PoorDamping> poorly_damped(const Machine& machine);
/// Axes without a drive on a machine with drives: "Z", "X and Z"; empty: all have one, or none.
std::string axes_without_drive(const Machine& machine);
/// Both in words, one sentence each.
std::vector<Message> drive_notes(const Machine& machine);

/// Of a model that limits no jerk though it has ramps: which of the largest values it has not; else null;
/// translatable.
const char* jump_note(const Setup& setup);

/// Of a model that limits jerk, but by no limits of the axes: that these may be exceeded; else null;
/// translatable.
const char* limits_note(const Setup& setup);
/// Where rotary axes turn under tool centre point control: whose motion the figures of X, Y and Z are; else
/// null; translatable.
const char* tip_note(const Toolpath& path);

/// Where rotary axes turn along feed motions: that the model does not hold their limits in full, or which of
/// them it exceeds beside places where blocks meet; else null; translatable.
const char* rotary_limits_note(const Toolpath& path, const Setup& setup);
/// Of a program that turns rotary axes, on a machine that has none; else null; translatable.
const char* missing_axes_note(const Toolpath& path, const Machine& machine);
/// The notes above that apply, in a fixed order, then ControlModel::left_out(); `path`: as the machine runs
/// it.
std::vector<const char*> figure_notes(const Toolpath& path, const Setup& setup);

/// The largest feed of `program`, with the override of the setup, where the machine reaches it in no
/// direction; `path`: as the machine runs it.
std::optional<UnreachableFeed> feed_beyond_machine(const LoadedProgram& program, const Toolpath& path,
                                                   const Setup& setup);

/// The first of those that are most severe; `faults`: one at least.
const Diagnostic& most_severe(const std::vector<Diagnostic>& faults);
/// What of the program the machine cannot do, in one sentence; empty if nothing.
Message machine_fault_note(const std::vector<Diagnostic>& faults);

/// What is to be known of a run before its figures are trusted, one sentence each: a control that does not
/// read the program's dialect, a machine that gives work offsets which the program was not read with,
/// ignored_path_control(), refused_note(), jump_note(), a tolerance that Heidenhain advises against,
/// feed_beyond_machine(), then drive_notes().
std::vector<Message> run_notes(const LoadedProgram& program, const Setup& setup);

}  // namespace feedscope
