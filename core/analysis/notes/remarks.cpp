#include "core/analysis/notes/remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "core/analysis/notes/ignored_path_control.h"
#include "core/analysis/notes/not_counted.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/undetermined_limits.h"
#include "core/analysis/run/control_dialect.h"
#include "core/analysis/run/tolerance_in_force.h"
#include "core/drives/drive_response.h"

namespace feedscope {
namespace {

using About = Remark::About;

/// Data that the rules examine.
struct Examined {
  const Run& run;
  UnitSystem units;

  const Setup& setup() const { return run.setup; }
  const Machine& machine() const { return run.setup.machine; }
  const Toolpath& path() const { return *run.path; }  ///< as the machine runs it
  Guarantees promised() const { return run.setup.model->guarantees(run.setup.settings); }

  /// "0.02 mm"; at most `decimals` in metric units, which an inch has about one and a half more of.
  Message amount(double value, Dimension dimension, int decimals) const {
    const ShownUnit& unit = shown_unit(dimension, units);
    const int digits = units == UnitSystem::metric || decimals == 0 ? decimals : decimals + 1;
    std::string number = fmt::format("{:.{}f}", value * unit.factor, digits);
    if (digits > 0) {
      number.erase(number.find_last_not_of('0') + 1);
      number.erase(number.find_last_not_of('.') + 1);
    }
    return Message::of({"{} {}"},
                       {Message::number(std::move(number)), Message::as_written(std::string(unit.text))});
  }
};

Message other_offsets(const Examined& of) {
  const std::string offsets = unused_work_offsets(*of.run.input.program, of.machine());
  return offsets.empty()
             ? Message()
             : message(NC_("core",
                           "The program was read with work offsets other than those of the machine ({})."),
                       offsets);
}

Message other_control(const Examined& of) {
  const auto mismatch = control_mismatch(of.machine(), of.run.input.program->dialect);
  return mismatch ? describe(*mismatch) : Message();
}

Message refused(const Examined& of) {
  return refused_note(of.run.lines_not_run);
}

/// Faults of rotary axes: the first of the most severe ones, and their number.
Message machine_faults(const Examined& of) {
  const std::vector<Diagnostic>& faults = of.run.path.faults;
  if (faults.empty()) {
    return {};
  }
  const Diagnostic& first = *std::ranges::max_element(faults, std::ranges::less(), &Diagnostic::severity);
  const bool all_errors =
      std::ranges::all_of(faults, [](const Diagnostic& fault) { return fault.severity == Severity::error; });
  const std::size_t more = faults.size() - 1;
  if (all_errors) {
    return more == 0
               ? message(
                     NC_("core", "Positions of rotary axes that the machine does not reach: line {}: {}."),
                     first.line, first.message)
               : message(NC_("core",
                             "Positions of rotary axes that the machine does not reach: line {}: {}. {} "
                             "more."),
                         first.line, first.message, more);
  }
  return more == 0
             ? message(NC_("core", "Rotary axes: line {}: {}."), first.line, first.message)
             : message(NC_("core", "Rotary axes: line {}: {}. {} more."), first.line, first.message, more);
}

Message override_of_feeds(const Examined& of) {
  const auto percent = feed_override(of.setup());
  return percent ? message(NC_("core", "Programmed means with the feed override of {:.4g} %."), *percent)
                 : Message();
}

Message missing_axes(const Examined& of) {
  return of.path().rotary_moves.empty() || !of.machine().kinematics.empty()
             ? Message()
             : NC_("core",
                   "The program turns rotary axes, which this machine does not have: the time of their "
                   "turns is missing, and they hold no feed. Choose a machine that has them, such as "
                   "five-axis-table-ac.");
}

/// For rotary axes that turn under tool centre point control.
Message figures_of_the_tip(const Examined& of) {
  return std::ranges::none_of(of.path().segment_turns, &SegmentTurn::at_tip)
             ? Message()
             : NC_("core",
                   "Velocity, acceleration and jerk of X, Y and Z are those of the tool's tip in "
                   "the part; where rotary axes turn, the axes of the machine move otherwise.");
}

Message limits_of_rotary_axes(const Examined& of) {
  if (of.path().segment_turns.empty()) {
    return {};
  }
  if (!of.promised().holds_rotary_ramps) {
    return NC_("core",
               "This model does not hold the limits of rotary axes in full: their largest values may be "
               "above what the machine allows.");
  }
  return of.path().turn_joints.empty()
             ? Message()
             : NC_("core",
                   "Where blocks meet along which rotary axes turn, acceleration and jerk of axes may be "
                   "above their limits for a short time: rounding of the angles, corners and ramps add up "
                   "there. Their velocity steps by some percent at both ends of a corner blend, which is "
                   "shorter than the corner; the accelerations shown do not hold these steps.");
}

/// For a model whose jerk limit ignores the limits of the axes.
Message ignored_limits(const Examined& of) {
  const Guarantees promised = of.promised();
  const bool holds = promised.lines.acceleration.of != KeptLimit::Of::nothing;
  return holds || !promised.limits_jerk
             ? Message()
             : NC_("core",
                   "This model holds no acceleration and jerk limits of the axes: largest values "
                   "may be above what the machine allows.");
}

/// For a model in which axes change their velocity within no time.
Message jumps(const Examined& of) {
  const Guarantees promised = of.promised();
  if (!promised.limits_jerk && of.setup().model->info().jumps_in_corners) {
    return NC_("core",
               "No jerk is limited: the acceleration jumps, and where blocks meet the velocity "
               "of an axis, too. There is no largest jerk, and the largest accelerations are "
               "those between the jumps.");
  }
  return !promised.limits_jerk && promised.continuity == Continuity::position
             ? NC_("core",
                   "Speed and acceleration jump, which this model does not limit: the largest values are "
                   "those between the jumps.")
             : Message();
}

Message idle_stop_window(const Examined& of) {
  const Settings& settings = of.setup().settings;
  return settings.has(exact_stop_window_key) && settings.number(exact_stop_window_key) > 0 &&
                 !has_drives(of.machine())
             ? NC_("core",
                   "The exact stop window has no effect: the machine gives no drive (kv_1_s), so "
                   "that its axes are where they should be at once.")
             : Message();
}

/// For a contour tolerance below the chord error: the tool follows the chords. Wider ones than advised are
/// usual and change nothing.
Message narrow_tolerance(const Examined& of) {
  const std::optional<ChordError>& error = of.run.input.chord_error;
  const auto tolerance = tolerance_in_force(of.run.input.feed_controls, of.setup());
  if (!error || !tolerance) {
    return {};
  }
  const double share = tolerance->min / error->value;
  return share >= least_advised_tolerance || is_advised_tolerance(share)
             ? Message()
             : message(
                   NC_("core",
                       "The contour tolerance of {} is {:.0f} % of the estimated chord error of the short "
                       "lines ({}); Heidenhain advises 110 to 200 %."),
                   of.amount(tolerance->min, Dimension::length, 4), 100 * share,
                   of.amount(error->value, Dimension::length, 4));
}

Message unreachable(const Examined& of) {
  const auto feed = feed_beyond_machine(of.run.input, of.path(), of.setup());
  return feed ? message(NC_("core",
                            "Line {} asks for a feed of {}; all axes of this machine together reach {}: what "
                            "is lost against the programmed feed tells little there."),
                        feed->programmed.line, of.amount(feed->programmed.feed, Dimension::feed, 0),
                        of.amount(feed->reachable, Dimension::feed, 0))
              : Message();
}

Message not_in_cycle_time(const Examined& of) {
  Message note = not_counted_note(of.run.summary.not_counted);
  return note.empty() ? note : Message::of({"{}."}, {std::move(note)});
}

using Texts = std::vector<Message>;

Texts path_control_not_followed(const Examined& of) {
  return ignored_path_control(of.run.input, of.setup());
}

Texts left_out_by_model(const Examined& of) {
  Texts texts;
  for (const char* const sentence : of.setup().model->left_out(of.path(), of.setup().settings)) {
    texts.emplace_back(Translatable{sentence});
  }
  return texts;
}

Texts states_of_drives(const Examined& of) {
  return drive_remarks(of.machine());
}

Texts guesses_that_limit(const Examined& of) {
  Texts texts;
  for (const UndeterminedLimit& limit : undetermined_limits(of.run)) {
    texts.push_back(describe(limit));
  }
  return texts;
}

template <Message (*text)(const Examined&)>
Texts one(const Examined& of) {
  Message found = text(of);
  return found.empty() ? Texts() : Texts{std::move(found)};
}

struct RemarkRule {
  About about;
  Texts (*texts)(const Examined& of);  ///< empty where the rule does not apply
};

/// In the order of the remarks.
constexpr auto remark_rules = std::to_array<RemarkRule>({
    {About::validity, one<other_offsets>},
    {About::validity, one<other_control>},
    {About::path_control, path_control_not_followed},
    {About::validity, one<refused>},
    {About::faults, one<machine_faults>},
    {About::programmed, one<override_of_feeds>},
    {About::time, one<missing_axes>},
    {About::values, one<figures_of_the_tip>},
    {About::values, one<limits_of_rotary_axes>},
    {About::time, one<ignored_limits>},
    {About::values, one<jumps>},
    {About::time, one<idle_stop_window>},
    {About::time, left_out_by_model},
    {About::time, one<narrow_tolerance>},
    {About::programmed, one<unreachable>},
    {About::drives, states_of_drives},
    {About::time, guesses_that_limit},
    {About::not_counted, one<not_in_cycle_time>},
});

}  // namespace

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

std::vector<Message> drive_remarks(const Machine& machine) {
  constexpr double much = 0.1;  // overshoot of a step
  std::vector<Message> found;
  std::vector<std::string> without;
  for (std::size_t i = 0; i < machine.drives.size(); ++i) {
    if (const double overshoot = drive_overshoot(machine.drives[i]); overshoot >= much) {
      found.push_back(
          message(NC_("core",
                      "The drive of axis {0} is poorly damped: it overshoots a step by {1:.0f} %; "
                      "a smaller {0}.kv or {0}.velocity_lag damps it better."),
                  machine.drives.name(i), 100 * overshoot));
    }
    if (machine.drives[i].follows_exactly()) {
      without.emplace_back(1, machine.drives.name(i));
    }
  }
  if (!without.empty() && without.size() < machine.drives.size()) {
    found.push_back(message(NC_("core", "No drive is given for {}: followed exactly."),
                            fmt::format("{}", fmt::join(without, ", "))));
  }
  return found;
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

std::vector<Remark> remarks(const Run& run, UnitSystem units) {
  std::vector<Remark> found;
  for (const RemarkRule& rule : remark_rules) {
    for (Message& text : rule.texts({run, units})) {
      found.push_back({rule.about, std::move(text)});
    }
  }
  return found;
}

std::vector<Message> texts_about(std::span<const Remark> remarks,
                                 std::initializer_list<Remark::About> topics) {
  std::vector<Message> texts;
  for (const Remark& remark : remarks) {
    if (std::ranges::find(topics, remark.about) != topics.end()) {
      texts.push_back(remark.text);
    }
  }
  return texts;
}

}  // namespace feedscope
