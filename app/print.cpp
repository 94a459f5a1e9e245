#include "app/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <sstream>

#include "core/analysis/notes/not_counted.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/tolerance_in_force.h"
#include "core/base/clock_text.h"
#include "core/base/units.h"
#include "core/machine/contour_tolerance.h"
#include "core/models/guarantees.h"

namespace feedscope {
namespace {

/// Characters on screen of a UTF-8 text.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return right ? space + text : text + space;
}

std::string peak_and_limit(double peak, double limit) {
  return std::isnan(peak) ? "jumps" : fmt::format("{:.4g} of {:.4g}", peak, limit);
}

/// "; 10 on blends" where the limit on blends differs.
std::string blend_limit(const Machine& machine, char axis) {
  const double on_blends = axis_limit(machine, axis, "blend_jerk");
  return on_blends == axis_limit(machine, axis, "jerk") ? "" : fmt::format("; {:.4g} on blends", on_blends);
}

void add_linear_peaks(TextTable& table, const Machine& machine, char axis, const AxisPeaks& peak) {
  table.add({fmt::format("axis {}", axis),
             peak_and_limit(units::to_m_min(peak.velocity), axis_limit(machine, axis, "velocity")),
             peak_and_limit(units::to_m(peak.acceleration), axis_limit(machine, axis, "acceleration")),
             peak_and_limit(units::to_m(peak.jerk), axis_limit(machine, axis, "jerk")) +
                 (std::isnan(peak.jerk) ? std::string() : blend_limit(machine, axis))});
}

std::string axis_table(const Run& run) {
  TextTable table;
  table.add(
      {run.summary.rotary ? "of the tip" : "", "velocity [m/min]", "acceleration [m/s2]", "jerk [m/s3]"});
  for (std::size_t i = 0; i < run.summary.axes.size(); ++i) {
    add_linear_peaks(table, run.setup.machine, run.summary.axes.name(i), run.summary.axes[i]);
  }
  return table.text("lrrr");
}

/// Figures of the rotary axes; empty for a run in which none turns.
std::string rotary_text(const Run& run) {
  if (!run.summary.rotary) {
    return "";
  }
  const RotaryFigures& figures = *run.summary.rotary;
  std::string text;
  if (figures.linear) {
    TextTable table;
    table.add({"of the machine, where rotary axes turn", "[m/min]", "[m/s2]", "[m/s3]"});
    for (std::size_t i = 0; i < coordinate_names.size(); ++i) {
      add_linear_peaks(table, run.setup.machine, coordinate_names[i], (*figures.linear)[i]);
    }
    text += table.text("lrrr");
  }
  TextTable table;
  table.add({"", "velocity [rev/min]", "acceleration [rev/s2]", "jerk [rev/s3]"});
  for (const RotaryAxis& axis : run.setup.machine.kinematics.rotary) {
    const AxisPeaks& peak = figures.rotary[rotary_names.find(axis.name)];
    table.add({fmt::format("axis {}", axis.name),
               peak_and_limit(units::to_turns_min(peak.velocity), units::to_turns_min(axis.velocity)),
               peak_and_limit(units::to_turns(peak.acceleration), units::to_turns(axis.acceleration)),
               peak_and_limit(units::to_turns(peak.jerk), units::to_turns(axis.jerk))});
  }
  text += table.text("lrrr");
  if (const OrientationError& error = figures.orientation; error.line > 0) {
    text += fmt::format("  the tool leans from its programmed direction by {:.3g} deg at most (line {})\n",
                        units::to_deg(error.angle), error.line);
  }
  return text;
}

/// Figures of the actual path; empty where all axes follow exactly.
std::string actual_text(const Summary& summary) {
  if (!summary.actual) {
    return "";
  }
  const ActualFigures& actual = *summary.actual;
  TextTable table;
  for (std::size_t i = 0; i < coordinate_names.size(); ++i) {
    const double error = actual.largest_following_error[static_cast<Eigen::Index>(i)];
    table.add({fmt::format("following error of {}", coordinate_names[i]),
               fmt::format("{:.1f} um", units::to_um(error)), ""});
  }
  const ActualPlace& worst = actual.worst;
  table.add({"contour error of the actual path", fmt::format("{:.1f} um", units::to_um(worst.error)),
             worst.error > 0 ? fmt::format("line {}; the set path is {:.1f} um off there", worst.line,
                                           units::to_um(worst.of_control))
                             : ""});
  table.add(
      {"mean of it over the cutting", fmt::format("{:.1f} um", units::to_um(actual.mean_contour_error)), ""});
  return "\nDrives, largest values\n" + table.text("lrl");
}

/// "380 N (line 52, at 1.234 s)".
std::string load_figure(const LoadFigure& figure, const LoadQuantity& quantity, bool with_place) {
  const std::string value = fmt::format("{:.4g} {}", in_file_unit(quantity, figure.largest),
                                        shown_unit(info_of(quantity.id).dimension).text);
  return with_place ? fmt::format("{} (line {}, at {:.3f} s)", value, figure.line, figure.time) : value;
}

void add_limit(TextTable& table, const LimitFigures& limit, double cutting_time) {
  const auto longest =
      std::max_element(limit.places.begin(), limit.places.end(),
                       [](const LoadPlace& a, const LoadPlace& b) { return a.to - a.from < b.to - b.from; });
  const std::string where =
      longest == limit.places.end()
          ? ""
          : fmt::format("; {}, the longest in lines {}-{} at {:.3f} s",
                        limit.count == 1 ? "1 place" : fmt::format("{} places", limit.count),
                        longest->first_line, longest->last_line, longest->from);
  table.add({std::string(title_of(limit.limit)),
             fmt::format("{:.3f} s, {:.1f} % of the cutting", limit.time,
                         cutting_time > 0 ? 100 * limit.time / cutting_time : 0),
             fmt::format("{:.3f} s at the programmed feed{}", limit.programmed_time, where)});
}

/// The cutting load; empty without a load file.
std::string load_text(const Summary& summary) {
  if (!summary.load) {
    return "";
  }
  const LoadFigures& load = *summary.load;
  std::string out =
      fmt::format("\nCutting load over {:.3f} s; {}\n", load.all.cutting_time, load_assumptions());
  if (load.all.cutting_time > 0) {
    TextTable table;
    table.add({"", "largest", "mean", "largest if at the programmed feed", "mean"});
    for (std::size_t i = 0; i < load_quantity_count; ++i) {
      const LoadQuantity& quantity = load_quantities()[i];
      const auto mean = [&](const LoadFigure& figure) {
        return fmt::format("{:.4g}", in_file_unit(quantity, figure.mean));
      };
      const LoadFigure& predicted = load.all.predicted[i];
      const LoadFigure& programmed = load.all.programmed[i];
      table.add({std::string(info_of(quantity.id).title), load_figure(predicted, quantity, true),
                 mean(predicted), load_figure(programmed, quantity, false), mean(programmed)});
    }
    out += table.text("lrrrr");
  }
  TextTable times;
  for (const LimitFigures& limit : load.limits) {
    add_limit(times, limit, load.all.cutting_time);
  }
  for (const auto& [state, why] :
       {std::pair(LoadState::no_operation, "feed motions without an operation"),
        std::pair(LoadState::plunge, "plunging and drilling, not modelled"),
        std::pair(LoadState::no_spindle, "spindle stands or has no known speed")}) {
    if (const double time = load.time[static_cast<std::size_t>(state)]; time > 0) {
      times.add({why, fmt::format("{:.3f} s", time), "no load computed"});
    }
  }
  return out + times.text("lrl");
}

/// Indices of the positive times, the longest first.
std::vector<std::size_t> longest_first(const std::vector<double>& times) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] > 0) {
      order.push_back(i);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return times[a] > times[b]; });
  return order;
}

/// Time of pauses that the program or the machine demands [s].
double pauses_of(const Summary& summary) {
  double time = 0;
  for (std::size_t i = 0; i < summary.time_by_cause.size(); ++i) {
    time += is_pause(all_causes()[i].kind) ? summary.time_by_cause[i] : 0;
  }
  return time;
}

std::string cause_table(const Summary& summary) {
  TextTable table;
  const auto add = [&](const std::string& title, double time) {
    const double percent = 100 * time / summary.cycle_time;
    if (time >= 0.5e-3 || percent >= 0.05) {  // else both would be printed as zero
      table.add({title, fmt::format("{:.3f} s", time), fmt::format("{:.1f} %", percent)});
    }
  };
  for (const std::size_t i : longest_first(summary.time_by_cause)) {
    add(cause_title(all_causes()[i]), summary.time_by_cause[i]);
    if (all_causes()[i].kind == CauseKind::ramp_down) {
      for (const std::size_t place : longest_first(summary.time_by_slower_place)) {
        add(fmt::format("  of which: {}", cause_title(all_causes()[place])),
            summary.time_by_slower_place[place]);
      }
    }
  }
  return table.text("lrr");
}

/// The line of a diagnostic with a caret under its place; a long line is cut around it.
std::string marked_line(const Program& program, const Diagnostic& diagnostic) {
  constexpr std::size_t widest = 100;
  constexpr std::size_t before = 60;
  const SourceText* text = program.source.get();
  for (const auto& called : program.called_files) {
    text = called->name() == diagnostic.file ? called.get() : text;
  }
  if (diagnostic.line == 0 || diagnostic.column == 0) {
    return "";
  }
  const std::string_view line = text->line(diagnostic.line);
  const std::size_t column = std::min<std::size_t>(diagnostic.column - 1, line.size());
  const std::size_t from = column > before ? column - before : 0;
  std::string shown, indent;
  for (std::size_t i = from; i < std::min(line.size(), from + widest); ++i) {
    const bool plain = line[i] >= ' ' && line[i] <= '~';
    shown += plain ? line[i] : line[i] == '\t' ? ' ' : '?';
  }
  indent.assign(column - from, ' ');
  return fmt::format("  {}\n  {}^\n", shown, indent);
}

}  // namespace

std::string TextTable::text(std::string_view alignments) const {
  std::vector<std::size_t> widths(alignments.size(), 0);
  for (const Row& row : rows_) {
    for (std::size_t i = 0; i < row.cells.size() && !row.heading; ++i) {
      widths[i] = std::max(widths[i], width_of(row.cells[i]));
    }
  }
  std::string out;
  for (const Row& row : rows_) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      line += (i > 0         ? "   "
               : row.heading ? ""
                             : " ") +
              padded(row.cells[i], widths[i], alignments[i] == 'r');
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t columns = 100;
  std::istringstream words(text);
  std::string out;
  std::size_t at = indent;
  for (std::string word; words >> word;) {
    const std::size_t width = width_of(word);
    if (out.empty()) {
      at += width;
    } else if (at + 1 + width > columns) {
      out += "\n" + std::string(indent, ' ');
      at = indent + width;
    } else {
      out += ' ';
      at += 1 + width;
    }
    out += word;
  }
  return out;
}

std::string time_text(double seconds) {
  const std::string text = fmt::format("{:.3f} s", seconds);
  return seconds < 60 ? text : fmt::format("{} ({})", text, clock_text(seconds));
}

std::string signed_text(double value, int decimals) {
  const std::string text = fmt::format("{:+.{}f}", value, decimals);
  const bool is_zero = std::isfinite(value) && text.find_first_of("123456789") == std::string::npos;
  return is_zero ? text.substr(1) : text;
}

std::string without_pauses_text(double pauses) {
  return pauses > 0 ? fmt::format(", without pauses of {}", time_text(pauses)) : "";
}

void print_diagnostics(const Program& program, DiagnosticStyle style) {
  print_diagnostics(program.diagnostics, program, style);
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics, const Program& program,
                       DiagnosticStyle style) {
  for (const RepeatedDiagnostic& diagnostic : without_repeats(diagnostics)) {
    fmt::print(stderr, "{}\n", format(*diagnostic.first, program.source->name()));
    if (style == DiagnosticStyle::with_source) {
      fmt::print(stderr, "{}", marked_line(program, *diagnostic.first));
    }
    if (const std::string repeats = repeats_text(diagnostic).english(); !repeats.empty()) {
      fmt::print(stderr, "  {}\n", repeats);
    }
  }
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics, std::string_view file) {
  for (const RepeatedDiagnostic& diagnostic : without_repeats(diagnostics)) {
    const std::string repeats = repeats_text(diagnostic).english();
    fmt::print(stderr, "{}\n{}", format(*diagnostic.first, file),
               repeats.empty() ? "" : fmt::format("  {}\n", repeats));
  }
}

std::string figure_title(const SourceFigure& figure) {
  std::string title(figure.title);
  title.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(title.front())));
  return title;
}

std::string figure_unit(const SourceFigure& figure) {
  return figure.dimension == Dimension::error ? "[mm]"
                                              : fmt::format("[{}]", shown_unit(figure.dimension).text);
}

std::string figure_text(const SourceFigure& figure, const Summary& summary) {
  const std::optional<double> value = figure.of(summary);
  if (!value) {
    return "-";
  }
  return figure.dimension == Dimension::error
             ? fmt::format("{:.4f}", *value)
             : fmt::format("{:.{}f}", *value * shown_unit(figure.dimension).factor,
                           shown_unit(figure.dimension).decimals);
}

std::string not_run_text(std::size_t lines) {
  return lines == 0   ? ""
         : lines == 1 ? " The control refuses 1 line of the program; it is not run."
                      : fmt::format(" The control refuses {} lines of the program; they are not run.", lines);
}

std::string summary_text(const Run& run) {
  const Summary& s = run.summary;
  const Program& program = *run.input.program;
  std::string out = fmt::format("{} on {} ({}), model {}\n\n", program.source->name(), run.setup.machine.name,
                                run.setup.machine.control, run.setup.model->info().id);
  TextTable figures;
  figures.add({"cycle time", is_refused(run)
                                 ? "none: the control refuses the program, none of its feed motions is run"
                                 : time_text(s.cycle_time)});
  if (const std::string missing = describe(s.not_counted).english(); !missing.empty()) {
    figures.add({"not in the cycle time", missing});
  }
  figures.add({"programmed time", time_text(s.programmed_time)});
  const auto tolerance = tolerance_in_force(run.input.feed_controls, run.setup);
  const bool own = run.setup.model->guarantees(run.setup.settings).own_tolerances;
  const bool of_program = follows_program_tolerance(run.setup.settings);
  figures.add({"tolerance", tolerance           ? describe(tolerance)
                            : own && of_program ? "P of G64 in the program, else blend_tolerance_mm"
                            : own               ? "blend_tolerance_mm in place of P of G64"
                                                : "none: not used by the model"});
  figures.add({"path length", fmt::format("{:.3f} mm", run.trajectory->path_length())});
  figures.add({"mean feed", fmt::format("{:.1f} mm/min with rapids{}", units::to_mm_min(s.mean_feed),
                                        without_pauses_text(pauses_of(s)))});
  figures.add({"peak feed", fmt::format("{:.1f} mm/min", units::to_mm_min(s.peak_feed))});
  const std::string where =
      s.max_contour_error > 0 ? fmt::format(" (line {}, at {:.3f} s)", s.worst_place.line, s.worst_place.time)
                              : "";
  const std::size_t count = run.trajectory->path().curve_count();
  const std::string curves =
      count == 0 ? "" : fmt::format(", {} smooth {}", count, count == 1 ? "curve" : "curves");
  const std::string blends = fmt::format(", {} corner blends", run.trajectory->blend_count());
  const bool in_rapid = s.cutting_contour_error < s.max_contour_error;
  const std::string cutting =
      in_rapid ? fmt::format(" in a rapid, {:.4f} mm in feed motions", s.cutting_contour_error) : "";
  figures.add({"contour error", fmt::format("at most {:.4f} mm{}{}{}{}", s.max_contour_error, where, cutting,
                                            blends, curves)});
  using About = Remark::About;
  std::string below;
  for (const Message& text : texts_about(remarks(run), {About::programmed, About::time, About::values})) {
    below += "  " + wrapped(text.english(), 2) + "\n";
  }
  return out + figures.text("ll") + "\nLargest values\n" + axis_table(run) + rotary_text(run) + below +
         actual_text(s) + load_text(s) + "\nTime by limiting cause\n" + cause_table(s);
}

}  // namespace feedscope
