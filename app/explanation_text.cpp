#include "app/explanation_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/option_text.h"
#include "app/print.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/setup_options.h"
#include "core/base/clock_text.h"
#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

constexpr std::size_t most_rows = 12;
constexpr double worth_a_row = 5e-4;  // of the cycle time

std::string percent(double part, double of) {
  return of > 0 ? fmt::format("{:.1f} %", 100 * part / of) : "-";
}

std::string gain_text(double seconds) {
  return fmt::format("{:.{}f} s", seconds, decimals_of_gain(seconds));
}

/// "Mean feed with rapids 1672.2 mm/min, without pauses of 4.000 s. "; empty if nothing moves.
std::string mean_feed_text(const TimeUse& use) {
  return use.mean_feed > 0 ? fmt::format("Mean feed with rapids {:.1f} mm/min{}. ",
                                         units::to_mm_min(use.mean_feed), without_pauses_text(use.pauses()))
                           : "";
}

std::string change_text(const Remedy& remedy, const Setup& setup);

/// "57.5 s more than the programmed feeds give (56.1 % of the cycle time; 2.28 times the programmed time).
/// Most is lost in corners, to ...".
std::string conclusion(const Run& run, const TimeReport& report) {
  const TimeUse& use = report.use;
  const std::string refused = refused_note(run.lines_not_run).english();
  if (is_refused(run)) {
    return wrapped(fmt::format("No feed motion is run: there is no cycle time to explain. {}", refused), 0) +
           "\n";
  }
  if (!(use.cycle_time > 0)) {
    return "Nothing in this program takes time.\n";
  }
  std::string text = fmt::format("{} for {} programmed: {} {} than the programmed feeds give",
                                 time_text(use.cycle_time), time_text(use.programmed_time),
                                 seconds_text(std::abs(use.lost())), use.lost() >= 0 ? "more" : "less");
  if (use.programmed_time > 0) {
    text += fmt::format(" ({} of the cycle time; {:.2f} times the programmed time)",
                        percent(std::abs(use.lost()), use.cycle_time), use.cycle_time / use.programmed_time);
  }
  text += ". ";
  text += mean_feed_text(use);
  if (!report.slow.groups.empty() && report.slow.groups.front().loss > worth_a_row * use.cycle_time) {
    const SlowGroup& most = report.slow.groups.front();
    text += fmt::format("Most is lost in {} to {}: {}. ", info_of(most.shape).title, lost_to(most),
                        seconds_text(most.loss));
  }
  if (!report.changes.best.empty()) {
    const TriedChange& best = report.changes.tried[report.changes.best.front()];
    text += fmt::format("The change that helps most, {}, gains {} ({}).", change_text(best.remedy, run.setup),
                        gain_text(use.cycle_time - best.cycle_time),
                        percent(use.cycle_time - best.cycle_time, use.cycle_time));
  } else if (!report.changes.tried.empty()) {
    text += "None of the changes that were simulated helps.";
  }
  if (!refused.empty()) {
    text += fmt::format(" {} The times are those of the other lines.", refused);
  }
  return wrapped(text, 0) + "\n";
}

std::string kinds_text(const TimeUse& use) {
  TextTable table;
  table.add({"", "time", "share", "programmed", "lost"});
  const auto add = [&](const std::string& title, const TimeShare& share) {
    table.add({title, seconds_text(share.time), percent(share.time, use.cycle_time),
               seconds_text(share.programmed), seconds_text(share.lost())});
  };
  for (std::size_t i = 0; i < time_kind_count; ++i) {
    if (use.kinds[i].time > 0 || use.kinds[i].programmed > 0) {
      add(std::string(time_kind_title(static_cast<TimeKind>(i))), use.kinds[i]);
    }
  }
  add("all", {use.cycle_time, use.programmed_time});
  return table.text("lrrrr");
}

std::string causes_text(const TimeUse& use) {
  TextTable table;
  table.add({"", "time", "share", "lost"});
  CauseCost rest;
  for (const CauseCost& cost : use.causes) {
    if (std::max(cost.time, std::abs(cost.lost)) > worth_a_row * use.cycle_time) {
      table.add({cause_title(cost.cause), seconds_text(cost.time), percent(cost.time, use.cycle_time),
                 seconds_text(cost.lost)});
    } else {
      rest.time += cost.time;
      rest.lost += cost.lost;
    }
  }
  // A row of its own: among "others" it would hide time that causes lose.
  constexpr double path_worth_a_row = 1e-4;
  if (std::abs(use.saved_by_path) > path_worth_a_row * use.cycle_time) {
    table.add({std::string(path_title(use)), "", "", seconds_text(-use.saved_by_path)});
  } else {
    rest.lost -= use.saved_by_path;
  }
  if (rest.time > 0) {
    table.add(
        {"others", seconds_text(rest.time), percent(rest.time, use.cycle_time), seconds_text(rest.lost)});
  }
  table.add({"all", seconds_text(use.cycle_time), percent(use.cycle_time, use.cycle_time),
             seconds_text(use.lost())});
  return table.text("lrrr");
}

/// Shortens a comment of any length; its line leads to the whole.
std::string short_title(const std::string& title) {
  std::string start = fmt::format("{:.50}", title);
  return start == title ? title : start + "...";
}

std::string operations_text(const TimeUse& use) {
  TextTable table;
  table.add({"", "line", "time", "share", "programmed", "lost", "rapids", "loses most to"});
  std::vector<const OperationTime*> shown;
  for (const OperationTime& operation : use.operations) {
    shown.push_back(&operation);
  }
  const std::size_t count = std::min(most_rows, shown.size());
  std::ranges::nth_element(
      shown, shown.begin() + static_cast<std::ptrdiff_t>(count == shown.size() ? count - 1 : count),
      [](const OperationTime* a, const OperationTime* b) { return a->all.time > b->all.time; });
  OperationTime rest;
  for (std::size_t i = count; i < shown.size(); ++i) {
    rest.all.time += shown[i]->all.time;
    rest.all.programmed += shown[i]->all.programmed;
    rest.rapid += shown[i]->rapid;
  }
  const std::size_t others = shown.size() - count;
  shown.resize(count);
  std::ranges::sort(shown);  // in program order
  const auto add = [&](const std::string& title, const std::string& line, const OperationTime& operation,
                       const std::string& cause) {
    table.add({title, line, seconds_text(operation.all.time), percent(operation.all.time, use.cycle_time),
               seconds_text(operation.all.programmed), seconds_text(operation.all.lost()),
               seconds_text(operation.rapid), cause});
  };
  for (const OperationTime* operation : shown) {
    add(short_title(operation->title), fmt::format("{}", operation->line), *operation,
        operation->loses() ? cause_title(operation->worst.cause) : "");
  }
  if (others > 0) {
    add(fmt::format("{} others", others), "", rest, "");
  }
  return table.text("lrrrrrrl");
}

/// "turn 12 to 90 deg, median 45".
std::string measure_text(const SlowGroup& group) {
  const PlaceShapeInfo& info = info_of(group.shape);
  if (info.measure.empty()) {
    return "";
  }
  const bool angle = info.dimension == Dimension::angle;
  const auto value = [&](double inside) {
    return fmt::format("{:.3g}", angle ? units::to_deg(inside) : inside);
  };
  const std::string unit = angle ? "deg" : "mm";
  const bool all_the_same = value(group.smallest) == value(group.largest);
  return all_the_same ? fmt::format("{} {} {}", info.measure, value(group.median), unit)
                      : fmt::format("{} {} to {} {}, median {}", info.measure, value(group.smallest),
                                    value(group.largest), unit, value(group.median));
}

std::string groups_text(const TimeReport& report) {
  TextTable table;
  table.add({"", "lost", "places", "lines", "worst at", "what they have in common"});
  double other = report.slow.other;
  std::size_t rows = 0;
  for (const SlowGroup& group : report.slow.groups) {
    if (rows == most_rows || group.loss < worth_a_row * report.use.cycle_time) {
      other += group.loss;
      continue;
    }
    ++rows;
    const SlowPlace& worst = group.worst.front();
    table.add({fmt::format("{}: {}", info_of(group.shape).title, lost_to(group)), seconds_text(group.loss),
               fmt::format("{}", group.count), fmt::format("{}-{}", group.first_line, group.last_line),
               fmt::format("{}", worst.line), measure_text(group)});
  }
  table.add({"elsewhere", seconds_text(other), "", "", "", ""});
  table.add({"all", seconds_text(report.slow.loss), "", "", "", ""});
  std::string text = table.text("lrrrrl");
  const double path = report.use.lost() - report.slow.loss;
  if (seconds_text(report.slow.loss) != seconds_text(report.use.lost())) {
    text +=
        "  " +
        wrapped(fmt::format("All of this is lost along the path against its programmed feed; it differs by "
                            "{} from what is lost above ({}).",
                            seconds_text(std::abs(path)), path_title(report.use)),
                2) +
        "\n";
  }
  return text;
}

/// "jerk of all axes +50 %" if the remedy changes nothing else of the setup; else "".
std::string all_axes_text(const Remedy& remedy, const Setup& setup) {
  std::optional<double> factor;
  std::string limit;
  for (const auto& [key, value] : remedy.changes) {
    const bool of_axis = key.size() > 2 && key[1] == '.' && std::holds_alternative<double>(value);
    if (!of_axis || (!limit.empty() && key.substr(2) != limit)) {
      return "";
    }
    limit = key.substr(2);
    const double now = std::get<double>(value) / axis_limit(setup.machine, key[0], limit);
    if (std::abs(now - factor.value_or(now)) > 1e-3) {
      return "";
    }
    factor = now;
  }
  return factor && remedy.changes.size() == setup.machine.axes.size() && remedy.changes.size() > 1
             ? fmt::format("{} of all axes {:+.3g} %", limit, 100 * (*factor - 1))
             : "";
}

SettingValue value_in_force(const Setup& setup, const std::string& key) {
  const std::vector<SettingSpec>& specs = settings_of(*setup.model);
  const auto spec = std::ranges::find(specs, key, &SettingSpec::key);
  const bool number = spec != specs.end() && spec->choices.empty();
  return number ? SettingValue(number_in_force(setup.settings, *spec)) : setup.settings.value(key);
}

/// "contour_tolerance_mm 0.2 (now 0.1)".
std::string change_text(const Remedy& remedy, const Setup& setup) {
  std::vector<std::string> parts;
  if (!remedy.machine.empty()) {
    parts.push_back(fmt::format("on {}", shipped_machines().load(remedy.machine).name));
  }
  const auto now = [&](const std::string& key) -> SettingValue {
    const bool of_axis = key.size() > 2 && key[1] == '.';
    return of_axis ? SettingValue(axis_limit(setup.machine, key[0], key.substr(2)))
           : is_tolerance(key) && remedy.before ? SettingValue(*remedy.before)
                                                : value_in_force(setup, key);
  };
  const auto text = [](const SettingValue& value) {
    return std::holds_alternative<double>(value) ? fmt::format("{:.5g}", std::get<double>(value))
                                                 : std::get<std::string>(value);
  };
  if (const std::string all = all_axes_text(remedy, setup); !all.empty()) {
    parts.push_back(all);
    return fmt::format("{}", fmt::join(parts, ", "));
  }
  for (const auto& [key, value] : remedy.changes) {
    if (key != program_tolerance_key) {
      parts.push_back(fmt::format("{} {} (now {})", key, text(value), text(now(key))));
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string error_text(const TriedChange& change) {
  return change.cutting_contour_error ? fmt::format("{:.4f} mm", *change.cutting_contour_error) : "";
}

/// "feedscope simulate part.nc --set X.jerk=20", which repeats the trial; "" where the program has to be
/// changed, or no file contains the session's machine. Another machine replaces all options of `asked`.
std::string command_text(const Remedy& remedy, const Setup& setup, const ProgramOptions& program,
                         const RunOptions* asked) {
  const std::string options = as_options(remedy, setup);
  if (options.empty()) {
    return "";
  }
  if (asked == nullptr) {
    const std::vector<std::string> shipped = shipped_machines().ids();
    const bool knows_all = std::ranges::find(shipped, setup.machine.id) != shipped.end();
    return knows_all || !remedy.machine.empty()
               ? fmt::format("feedscope simulate {} {}", program_text(program),
                             knows_all ? setup_options(with_remedy(setup, remedy)) : options)
               : "";
  }
  RunOptions kept = *asked;
  if (!remedy.machine.empty()) {
    kept = {};
  } else if (std::ranges::any_of(remedy.changes,
                                 [](const auto& change) { return change.first == contour_tolerance_key; })) {
    kept.tolerance.clear();
    std::erase_if(kept.set, [](const std::string& assignment) {
      return assigned_key(assignment) == contour_tolerance_key;
    });
  }
  return fmt::format("feedscope simulate {}{} {}", program_text(*asked), run_text(kept), options);
}

std::string changes_text(const Run& run, const TimeReport& report, const ProgramOptions& program,
                         const RunOptions* asked) {
  const ChangeTrials& trials = report.changes;
  const double now = report.use.cycle_time;
  TextTable table;
  table.add({"", "cycle time", "gain", "", "contour error", "change"});
  table.add(
      {"now", seconds_text(now), "", "", fmt::format("{:.4f} mm", run.summary.cutting_contour_error), ""});
  const auto add = [&](const std::string& rank, const TriedChange& change) {
    table.add({rank, seconds_text(change.cycle_time), gain_text(now - change.cycle_time),
               percent(now - change.cycle_time, now), error_text(change),
               change_text(change.remedy, run.setup)});
  };
  for (std::size_t i = 0; i < trials.best.size(); ++i) {
    add(fmt::format("{}.", i + 1), trials.tried[trials.best[i]]);
  }
  if (trials.together) {
    TriedChange together = *trials.together;
    table.add({"together", seconds_text(together.cycle_time), gain_text(now - together.cycle_time),
               percent(now - together.cycle_time, now), error_text(together), "those of this machine"});
  }
  std::size_t others = 0;
  for (std::size_t i = 0; i < trials.tried.size() && others < most_rows; ++i) {
    const bool is_best = std::ranges::find(trials.best, i) != trials.best.end();
    const double gain = now - trials.tried[i].cycle_time;
    if (!is_best && trials.tried[i].failure.empty() && gain > ChangeTrials::worth_it * now) {
      if (others++ == 0) {
        table.add_heading("Also simulated");
      }
      add("", trials.tried[i]);
    }
  }
  std::string commands;
  for (const std::size_t i : trials.best) {
    if (const std::string command = command_text(trials.tried[i].remedy, run.setup, program, asked);
        !command.empty()) {
      commands += fmt::format("  {}\n", command);
    }
  }
  return table.text("lrrrrl") + (commands.empty() ? "" : "\n" + commands);
}

}  // namespace

std::string explanation_text(const Run& run, const TimeReport& report, const ProgramOptions& program,
                             const RunOptions* asked) {
  const TimeUse& use = report.use;
  std::string out =
      fmt::format("{} on {} ({}), model {}\n\n{}", run.input.program->source->name(), run.setup.machine.name,
                  run.setup.machine.control, run.setup.model->info().id, conclusion(run, report));
  if (is_refused(run) || !(use.cycle_time > 0)) {
    return out;
  }
  using About = Remark::About;
  for (const Message& text :
       texts_about(remarks(run), {About::programmed, About::time, About::not_counted})) {
    out += wrapped(text.english(), 0) + "\n";
  }
  out += "\nWhat it consists of\n" + kinds_text(use);
  out += "\nWhat limits it, with braking for it\n" + causes_text(use);
  if (!use.operations.empty()) {
    out += fmt::format("\nOperations by {}\n", use.split == OperationSplit::tool ? "tool" : "comment");
    out += operations_text(use);
  }
  out += "\nPlaces that lose most\n" + groups_text(report);
  out += "\nWhat would help (each simulated; whether machine, tool and material bear it is not checked)\n" +
         changes_text(run, report, program, asked);
  return out;
}

}  // namespace feedscope
