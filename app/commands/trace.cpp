#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>

#include "app/asked_program.h"
#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/run_remarks.h"
#include "app/trace_columns_option.h"
#include "app/watch.h"
#include "core/analysis/agreement/feed_share.h"
#include "core/analysis/agreement/held_stretches.h"
#include "core/analysis/agreement/servo_period.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/export/trace.h"
#include "core/trace/read_trace.h"

namespace feedscope {
namespace {

struct TraceOptions {
  RunOptions run;
  std::string trace;
  std::string columns;
  std::string json;
};

std::string trace_text(const Trace& trace) {
  std::string text =
      fmt::format("{}: {}, {} samples, {:.6g} s, one each {:.4g} ms ({})\n", trace.name, trace.format,
                  trace.size(), trace.duration(), units::to_ms(trace.period), title_of(trace.clock));
  for (const std::string& column : trace.columns) {
    text += fmt::format("  {}\n", column);
  }
  TextTable table;
  table.add({"axis", "from mm", "to mm", "fastest mm/min"});
  for (std::size_t axis = 0; axis < trace.place.size(); ++axis) {
    if (!trace.has(axis)) {
      continue;
    }
    const std::vector<double>& place = trace.place[axis];
    const auto [low, high] = std::ranges::minmax_element(place);
    double fastest = 0;
    constexpr std::size_t over = 4;  // samples
    for (std::size_t i = over; i < place.size(); ++i) {
      fastest =
          std::max(fastest, std::abs(place[i] - place[i - over]) / (trace.time[i] - trace.time[i - over]));
    }
    table.add({std::string(1, coordinate_names[axis]), fmt::format("{:.4f}", *low),
               fmt::format("{:.4f}", *high), fmt::format("{:.0f}", units::to_mm_min(fastest))});
  }
  return text + table.text("lrrr");
}

std::string agreement_text(const TraceOnProgram& found, const Agreement& agreement, const Run& run) {
  std::string text = fmt::format("\nbeside {} on {}, model {}:\n", run.input.program->source->name(),
                                 run.setup.machine.id, run.setup.model->info().id);
  if (!found.belongs()) {
    return text + "  not compared: the trace does not belong to this program\n";
  }
  if (found.pose.offset.norm() > 1e-3) {
    text += fmt::format("  offset of the trace: {:.4g} {:.4g} {:.4g} mm\n", found.pose.offset.x(),
                        found.pose.offset.y(), found.pose.offset.z());
  }
  TextTable table;
  table.add({"", "trace", "simulated", "difference"});
  table.add({agreement.whole ? "cycle time" : "time of the part compared", time_text(agreement.measured_time),
             time_text(agreement.simulated_time), signed_text(100 * agreement.time_error(), 2) + " %"});
  if (agreement.held_time > 0) {
    table.add({"  without standing still", time_text(agreement.measured_time - agreement.held_time),
               time_text(agreement.simulated_time),
               signed_text(100 * agreement.time_error_without_holds(), 2) + " %"});
  }
  table.add({"largest distance from the path", fmt::format("{:.4f} mm", agreement.distance),
             fmt::format("{:.4f} mm", agreement.simulated_distance), ""});
  for (const OperationAgreement& operation : agreement.operations) {
    const std::string line = title_of_line(operation.line);
    table.add({operation.title == line ? line : line + ": " + operation.title,
               time_text(operation.measured_time), time_text(operation.simulated_time),
               signed_text(operation.simulated_time - operation.measured_time, 3) + " s"});
  }
  text += table.text("lrrr");
  text += fmt::format("difference of the feeds over the path (rms): {:.1f} mm/min\n",
                      units::to_mm_min(agreement.feed_rms));
  if (!agreement.worst.empty()) {
    TextTable places;
    places.add({"worst places: line", "at mm", "trace mm/min", "simulated mm/min", "trace slower by ms"});
    for (const WorstPlace& place : agreement.worst) {
      places.add({fmt::format("{}", place.line), fmt::format("{:.3f}", place.s),
                  fmt::format("{:.0f}", units::to_mm_min(place.measured_feed)),
                  fmt::format("{:.0f}", units::to_mm_min(place.simulated_feed)),
                  signed_text(units::to_ms(place.lost), 2)});
    }
    text += places.text("rrrrr");
  }
  return text;
}

/// The program of the trace, and its setup.
struct Beside {
  AskedProgram asked;
  Setup setup;

  Run run(Watch& watch) const {
    const LoadedProgram program =
        load_program(asked.source, watch.stage("reading"), reading_on(asked.reading, setup.machine));
    return simulate_run(program, setup, watch.stage("simulating"));
  }
};

std::optional<Beside> beside(const TraceOptions& options) {
  if (options.run.file.empty()) {
    for (const auto& given : {given_of(options.run), given_of_run(options.run)}) {
      for (const auto& [name, is_given] : given) {
        if (is_given) {
          throw InputError(fmt::format("{} has no effect without a PROGRAM beside the trace", name));
        }
      }
    }
    return std::nullopt;
  }
  Beside found{asked_program(options.run, given_of_run(options.run)), {}};
  found.setup = found.asked.is_session() ? found.asked.setups[found.asked.current]
                                         : make_setup(options.run.request(found.asked.dialect()));
  return found;
}

int show_trace(const TraceOptions& options) {
  check_outputs(options.trace, {options.json}, "the trace itself");
  check_outputs(options.run.file, {options.json});
  TraceColumns columns = asked_columns(options.columns);
  const std::optional<Beside> program = beside(options);
  columns.machine_period = program ? servo_period_of(program->setup) : 0;
  OutputFiles files;
  std::ostream* json = options.json.empty() ? nullptr : &files.add(options.json);
  Trace trace;
  std::optional<Run> run;
  std::optional<TraceOnProgram> found;
  std::optional<Agreement> agreement;
  {
    Watch watch;
    trace = read_trace(options.trace, columns, watch.stage("trace"));
    if (program) {
      run = program->run(watch);
      const ProgrammedCourse course(*run->path, {trace.has(0), trace.has(1), trace.has(2)});
      Progress* const matching = watch.stage("matching");
      const double deviation = deviation_of(*run->trajectory, course, 1e-3, matching);
      found = find_on_program(trace, course, deviation, run->input.program->source.get(), matching);
      agreement = agreement_of(*found, course, *run, watch.stage("comparing"));
      add_held_remarks(*found, course, agreement->simulated);
      add_feed_remark(*found, *agreement, course, *run->path);
    }
  }
  print_diagnostics(trace.notes, options.trace);
  if (run) {
    tell_of_run(*run, options.run, program->asked.reading);
    print_diagnostics(found->remarks, options.trace);
  }
  if (json != nullptr) {
    *json << (run ? trace_json(trace, *found, *agreement, *run) : trace_json(trace));
    files.commit();
  }
  if (options.json != "-") {
    fmt::print("{}{}", trace_text(trace), run ? agreement_text(*found, *agreement, *run) : "");
  }
  if (found && !found->belongs()) {
    return exit_code::wrong_use;
  }
  return run ? exit_code_of(*run) : exit_code::done;
}

}  // namespace

Command add_trace_command(CLI::App& app) {
  const auto options = std::make_shared<TraceOptions>();
  CLI::App* command = app.add_subcommand(
      "trace", "Read what a control recorded, and lay it beside the simulation of its program");
  command
      ->add_option("FILE", options->trace,
                   "Trace: LinuxCNC halsampler, SINUMERIK trace (XML), TwinCAT Scope (text), or any table of "
                   "samples; packed by gzip or not")
      ->required();
  add_run_options(*command, options->run, "PROGRAM")->required(false);
  add_columns_option(*command, options->columns);
  command->add_option("--json", options->json, "Write numbers and messages; - for standard output")
      ->type_name("FILE");
  command->footer(
      command->get_footer() +
      "\nExample: feedscope trace scope.csv part.nc --machine my-mill.toml --json agreement.json");
  return {command, [options] {
            move_tolerance(options->run);
            return show_trace(*options);
          }};
}

}  // namespace feedscope
