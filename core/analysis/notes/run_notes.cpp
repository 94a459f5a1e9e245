#include "core/analysis/notes/run_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "core/analysis/notes/ignored_path_control.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/unadvised_tolerance.h"
#include "core/analysis/notes/unreachable_feed.h"
#include "core/analysis/run/control_dialect.h"
#include "core/base/translatable.h"
#include "core/drives/drive_response.h"
#include "core/toolpath/rotary_resolver.h"

namespace feedscope {

std::string unused_work_offsets(const Program& program, const Machine& machine) {
  std::vector<std::string> names;
  const auto& read_with = program.given_offsets.all();
  for (const OffsetUse& use : program.work_offsets) {
    const auto of_machine = machine.work_offsets.all().find(use.name);
    const auto given = read_with.find(use.name);
    if (of_machine != machine.work_offsets.all().end() &&
        (given == read_with.end() || given->second != of_machine->second)) {
      names.push_back(use.name);
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<PoorDamping> poorly_damped(const Machine& machine) {
  constexpr double much = 0.1;
  std::vector<PoorDamping> axes;
  for (std::size_t i = 0; i < machine.drives.size(); ++i) {
    const double overshoot = drive_overshoot(machine.drives[i]);
    if (overshoot >= much) {
      axes.push_back({machine.drives.name(i), overshoot});
    }
  }
  return axes;
}

std::string axes_without_drive(const Machine& machine) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < machine.drives.size(); ++i) {
    if (machine.drives[i].follows_exactly()) {
      names.emplace_back(1, machine.drives.name(i));
    }
  }
  return names.size() == machine.drives.size() ? "" : fmt::format("{}", fmt::join(names, ", "));
}

std::vector<Message> drive_notes(const Machine& machine) {
  std::vector<Message> notes;
  for (const PoorDamping& drive : poorly_damped(machine)) {
    notes.push_back(message(NC_("core",
                                "The drive of axis {0} is poorly damped: it overshoots a step by {1:.0f} %; "
                                "a smaller {0}.kv or {0}.velocity_lag damps it better."),
                            drive.axis, 100 * drive.overshoot));
  }
  if (const std::string axes = axes_without_drive(machine); !axes.empty()) {
    notes.push_back(message(NC_("core", "No drive is given for {}: followed exactly."), axes));
  }
  return notes;
}

const char* jump_note(const Setup& setup) {
  const Guarantees promised = setup.model->guarantees(setup.settings);
  if (promised.limits_jerk) {
    return nullptr;
  }
  if (setup.model->info().limits.jumps_in_corners) {
    return QT_TRANSLATE_NOOP("core",
                             "No jerk is limited: the acceleration jumps, and where blocks meet the velocity "
                             "of an axis, too. There is no largest jerk, and the largest accelerations are "
                             "those between the jumps.");
  }
  const bool has_ramps = promised.continuity != Continuity::position;
  return has_ramps ? QT_TRANSLATE_NOOP("core",
                                       "No jerk is limited: the acceleration jumps, and there is no largest "
                                       "jerk.")
                   : nullptr;
}

const char* limits_note(const Setup& setup) {
  const Guarantees promised = setup.model->guarantees(setup.settings);
  const bool holds = promised.lines.acceleration.of != KeptLimit::Of::nothing;
  return holds || !promised.limits_jerk
             ? nullptr
             : QT_TRANSLATE_NOOP(
                   "core",
                   "This model holds no acceleration and jerk limits of the axes: largest values "
                   "may be above what the machine allows.");
}

const char* tip_note(const Toolpath& path) {
  return std::ranges::none_of(path.segment_turns, &SegmentTurn::at_tip)
             ? nullptr
             : QT_TRANSLATE_NOOP(
                   "core",
                   "Velocity, acceleration and jerk of X, Y and Z are those of the tool's tip in "
                   "the part; where rotary axes turn, the axes of the machine move otherwise.");
}

const char* rotary_limits_note(const Toolpath& path, const Setup& setup) {
  if (path.segment_turns.empty()) {
    return nullptr;
  }
  if (!setup.model->guarantees(setup.settings).holds_rotary_ramps) {
    return QT_TRANSLATE_NOOP(
        "core",
        "This model does not hold the limits of rotary axes in full: their largest values may be "
        "above what the machine allows.");
  }
  return path.turn_joints.empty()
             ? nullptr
             : QT_TRANSLATE_NOOP(
                   "core",
                   "Where blocks meet along which rotary axes turn, acceleration and jerk of axes may be "
                   "above their limits for a short time: rounding of the angles, corners and ramps add up "
                   "there. Their velocity steps by some percent at both ends of a corner blend, which is "
                   "shorter than the corner; the accelerations shown do not hold these steps.");
}

const char* missing_axes_note(const Toolpath& path, const Machine& machine) {
  return path.rotary_moves.empty() || !machine.kinematics.empty()
             ? nullptr
             : QT_TRANSLATE_NOOP(
                   "core",
                   "The program turns rotary axes, which this machine does not have: the time of their "
                   "turns is missing, and they hold no feed. Choose a machine that has them, such as "
                   "five-axis-table-ac.");
}

const char* feed_override_note(const Setup& setup) {
  return feed_override(setup)
             ? QT_TRANSLATE_NOOP("core",
                                 "A feed override is set: feeds and times called programmed are those of the "
                                 "program with the override.")
             : nullptr;
}

std::vector<const char*> figure_notes(const Toolpath& path, const Setup& setup) {
  std::vector<const char*> notes{feed_override_note(setup),
                                 missing_axes_note(path, setup.machine),
                                 tip_note(path),
                                 rotary_limits_note(path, setup),
                                 limits_note(setup),
                                 jump_note(setup)};
  std::erase(notes, nullptr);
  if (setup.settings.has(exact_stop_window_key) && setup.settings.number(exact_stop_window_key) > 0 &&
      !has_drives(setup.machine)) {
    notes.push_back(
        QT_TRANSLATE_NOOP("core",
                          "The exact stop window has no effect: the machine gives no drive (kv_1_s), so "
                          "that its axes are where they should be at once."));
  }
  const std::vector<const char*> left_out = setup.model->left_out(path, setup.settings);
  notes.insert(notes.end(), left_out.begin(), left_out.end());
  return notes;
}

std::optional<UnreachableFeed> feed_beyond_machine(const LoadedProgram& program, const Toolpath& path,
                                                   const Setup& setup) {
  std::optional<LargestFeed> largest = program.largest_feed;
  if (largest) {
    constexpr double whole = 100;  // [%]
    largest->feed *= feed_override(setup).value_or(whole) / whole;
  }
  return unreachable_feed(largest, path, setup.machine);
}

const Diagnostic& most_severe(const std::vector<Diagnostic>& faults) {
  return *std::ranges::max_element(faults, std::ranges::less(), &Diagnostic::severity);
}

Message machine_fault_note(const std::vector<Diagnostic>& faults) {
  const auto errors = std::ranges::count(faults, Severity::error, &Diagnostic::severity);
  if (errors < std::ssize(faults)) {
    const Diagnostic& note = most_severe(faults);
    return faults.size() == 1 ? message(NC_("core", "Rotary axes: line {}: {}."), note.line, note.message)
                              : message(NC_("core", "Rotary axes: line {}: {}. {} more."), note.line,
                                        note.message, faults.size() - 1);
  }
  if (faults.empty()) {
    return {};
  }
  const Diagnostic& first = faults.front();
  return faults.size() == 1
             ? message(NC_("core", "Positions of rotary axes that the machine does not reach: line {}: {}."),
                       first.line, first.message)
             : message(NC_("core",
                           "Positions of rotary axes that the machine does not reach: line {}: {}. {} more."),
                       first.line, first.message, faults.size() - 1);
}

std::vector<Message> run_notes(const LoadedProgram& program, const Setup& setup) {
  std::vector<Message> notes = ignored_path_control(program, setup);
  if (const auto mismatch = control_mismatch(setup.machine, program.program->dialect)) {
    notes.insert(notes.begin(), describe(*mismatch));
  }
  const std::string offsets = unused_work_offsets(*program.program, setup.machine);
  if (!offsets.empty()) {
    notes.insert(
        notes.begin(),
        message(NC_("core", "The program was read with work offsets other than those of the machine ({})."),
                offsets));
  }
  if (Message refused = refused_note(refused_lines(program, setup)); !refused.empty()) {
    notes.push_back(std::move(refused));
  }
  // The toolpath of a run is already adapted to its setup.
  const std::shared_ptr<const Toolpath> path =
      program.toolpath->programmed
          ? program.toolpath
          : with_rotary_moves(program.toolpath, setup.machine, setup.settings, nullptr);
  if (Message faults = machine_fault_note(path->machine_faults); !faults.empty()) {
    notes.push_back(std::move(faults));
  }
  for (const char* const note : figure_notes(*path, setup)) {
    notes.emplace_back(Translatable{note});
  }
  if (const auto unadvised =
          unadvised_tolerance(program.chord_error, tolerance_in_force(program.feed_controls, setup))) {
    notes.push_back(describe(*unadvised));
  }
  if (const auto feed = feed_beyond_machine(program, *path, setup)) {
    notes.push_back(describe(*feed));
  }
  const std::vector<Message> of_drives = drive_notes(setup.machine);
  notes.insert(notes.end(), of_drives.begin(), of_drives.end());
  return notes;
}

}  // namespace feedscope
