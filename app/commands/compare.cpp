#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/watch.h"
#include "core/base/units.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

struct CompareOptions {
  std::string file;
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<std::string> tolerances;  // as typed, mm
  std::string csv;
  std::string json;
};

std::string tolerance_text(const Setup& setup) {
  const std::string key = "contour_tolerance_mm";
  return setup.settings.has(key) ? fmt::format("{}", setup.settings.number(key)) : "-";
}

std::vector<std::string> name_of(const ComparedRun& run) {
  return {run.setup.machine.id, run.setup.model->info().id, tolerance_text(run.setup)};
}

std::string times_table(const std::vector<ComparedRun>& runs) {
  TextTable table;
  table.add({"machine", "model", "tolerance [mm]", "cycle time", "against cam", "mean feed [mm/min]",
             "contour error [mm]"});
  for (const ComparedRun& run : runs) {
    std::vector<std::string> row = name_of(run);
    row.push_back(time_text(run.summary.cycle_time));
    row.push_back(fmt::format("x {:.3f}", run.against_cam()));
    row.push_back(fmt::format("{:.1f}", units::to_mm_min(run.summary.mean_feed)));
    row.push_back(fmt::format("{:.4f}", run.summary.max_contour_error));
    table.add(std::move(row));
  }
  return table.text("llrrrrr");
}

std::string peaks_table(const std::vector<ComparedRun>& runs) {
  TextTable table;
  table.add({"machine", "model", "tolerance [mm]", "velocity X Y Z", "acceleration X Y Z", "jerk X Y Z"});
  for (const ComparedRun& run : runs) {
    std::vector<std::string> row = name_of(run);
    const auto shares = [&](double AxisPeaks::*peak, double AxisLimits::*limit) {
      std::string text;
      for (std::size_t i = 0; i < run.summary.axes.size(); ++i) {
        const double share = run.summary.axes[i].*peak / (run.setup.machine.axes[i].*limit);
        text += fmt::format("{:>7}", std::isfinite(share) ? fmt::format("{:.0f} %", 100 * share) : "-");
      }
      return text;
    };
    row.push_back(shares(&AxisPeaks::velocity, &AxisLimits::velocity));
    row.push_back(shares(&AxisPeaks::acceleration, &AxisLimits::acceleration));
    row.push_back(shares(&AxisPeaks::jerk, &AxisLimits::jerk));
    table.add(std::move(row));
  }
  return table.text("llrrrr");
}

/// The three causes that most of the time goes to.
std::string causes_table(const std::vector<ComparedRun>& runs) {
  constexpr std::size_t shown = 3;
  TextTable table;
  table.add({"machine", "model", "tolerance [mm]", "first", "second", "third"});
  for (const ComparedRun& run : runs) {
    std::vector<std::string> row = name_of(run);
    const auto& times = run.summary.time_by_cause;
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return times[a] > times[b]; });
    for (std::size_t i = 0; i < shown; ++i) {
      const double time = times[order[i]];
      row.push_back(time > 0 ? fmt::format("{:.0f} % {}", 100 * time / run.summary.cycle_time,
                                           cause_title(all_causes()[order[i]]))
                             : "");
    }
    table.add(std::move(row));
  }
  return table.text("llrlll");
}

int compare(const CompareOptions& options) {
  std::vector<double> tolerances;
  for (const std::string& text : options.tolerances) {
    tolerances.push_back(parse_tolerance(text));
  }
  const std::vector<Setup> setups = setups_to_compare(options.machines, options.models, tolerances);
  check_outputs(options.file, {options.csv, options.json});
  const auto source = std::make_shared<const SourceText>(SourceText::from_file(options.file));
  const auto open = [](const std::string& name) {
    return name.empty() ? nullptr : std::make_unique<OutputFile>(name);
  };
  const auto csv = open(options.csv);
  const auto json = open(options.json);
  LoadedProgram program;
  std::vector<ComparedRun> runs;
  {
    Watch watch;
    program = load_program(source, watch.stage("reading"));
    runs = compare_runs(program, setups, watch.stage("simulating"));
  }
  if (csv) {
    csv->stream() << comparison_csv(runs);
    csv->commit();
  }
  if (json) {
    json->stream() << comparison_json(program, runs);
    json->commit();
  }
  print_diagnostics(*program.program);
  if (options.csv != "-" && options.json != "-") {
    fmt::print("{}\n\n{}\nLargest values, of the limits\n{}\nTime by limiting cause\n{}",
               program.program->source->name(), times_table(runs), peaks_table(runs), causes_table(runs));
  }
  return has_errors(program.program->diagnostics) ? exit_code::program_errors : exit_code::done;
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare", "Simulate a program on several machines, models and tolerances, side by side");
  add_program_option(*command, options->file);
  const auto add_list = [&](const char* name, std::vector<std::string>& values, const std::string& text) {
    return command->add_option(name, values, text + "; repeat for more")->allow_extra_args(false);
  };
  add_list("--machine", options->machines, fmt::format("Machine id or machine file [{}]", default_machine))
      ->type_name("ID|FILE");
  add_list("--model", options->models, "Control model [all]")->type_name("ID");
  add_list("--tolerance", options->tolerances, "Contour tolerance in mm [the machine's own]")
      ->type_name("MM");
  command->add_option("--csv", options->csv, "Write the figures, one row a run; - for standard output")
      ->type_name("FILE");
  command->add_option("--json", options->json, "Write figures and messages; - for standard output")
      ->type_name("FILE");
  return {command, [options] { return compare(*options); }};
}

}  // namespace feedscope
