#include <fmt/format.h>

#include <memory>
#include <optional>
#include <ostream>

#include "app/asked_program.h"
#include "app/commands/command.h"
#include "app/number_option.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/run_remarks.h"
#include "app/watch.h"
#include "core/export/contour.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

struct SimulateOptions {
  RunOptions run;
  std::string csv;
  std::string step;  // [s], as typed
  std::string json;
  std::string blends;
  std::string contour;
  std::string load;
  std::size_t contour_places = 20;
  std::optional<std::size_t> number;  ///< of a run of a session, from 1
};

std::optional<double> parse_step(const std::string& text) {
  if (text.empty()) {
    return std::nullopt;
  }
  SettingSpec number;
  number.key = "--step";
  number.unit = "s";
  number.minimum_allowed = false;
  return std::get<double>(parse_setting(number, text));
}

/// The machine's interpolation period [s], whether or not the model reads it.
double default_step(const Setup& setup) {
  for (const Settings* settings : {&setup.settings, &setup.machine.settings}) {
    if (settings->has("interpolation_period_s")) {
      return settings->number("interpolation_period_s");
    }
  }
  return 0.001;
}

/// The requested outputs, opened before the work begins and moved to their place after it.
class Results {
 public:
  explicit Results(const SimulateOptions& options)
      : places_(options.contour_places),
        csv_(open(options.csv)),
        json_(open(options.json)),
        blends_(open(options.blends)),
        contour_(open(options.contour)) {
    for (const std::string* name : {&options.csv, &options.json, &options.blends, &options.contour}) {
      to_standard_output_ = to_standard_output_ || *name == "-";
    }
  }

  void write(const Run& run, double step, Watch& watch) {
    if (csv_) {
      write_csv(*csv_, *run.trajectory, step, watch.stage("writing"), run.sources);
    }
    std::optional<ContourReport> contour;
    if (contour_) {
      contour = contour_report(run, places_, watch.stage("contour error"));
      *contour_ << contour_places_csv(*contour);
    }
    if (json_) {
      *json_ << simulation_json(run, figures_of(run), contour ? &*contour : nullptr);
    }
    if (blends_) {
      write_blends(*blends_, *run.trajectory, watch.stage("writing"));
    }
    files_.commit();
  }

  bool to_standard_output() const { return to_standard_output_; }

 private:
  std::ostream* open(const std::string& name) { return name.empty() ? nullptr : &files_.add(name); }

  std::size_t places_;
  OutputFiles files_;
  // In files_; nullptr if not requested.
  std::ostream* csv_;
  std::ostream* json_;
  std::ostream* blends_;
  std::ostream* contour_;
  bool to_standard_output_ = false;
};

int simulate(const SimulateOptions& options) {
  const AskedProgram asked = asked_program(options.run, given_of_run(options.run));
  Setup setup = asked_setup(options.run, options.number, asked);
  setup.load = asked_load(options.load, std::move(setup.load));
  const double step = parse_step(options.step).value_or(default_step(setup));
  for (const std::string& input : {options.run.file, asked.file}) {
    check_outputs(input, {options.csv, options.json, options.blends, options.contour});
  }
  check_outputs(options.load, {options.csv, options.json, options.blends, options.contour}, "the load file");
  Results results(options);
  Run run;
  {
    Watch watch;
    const LoadedProgram program =
        load_program(asked.source, watch.stage("reading"), reading_on(asked.reading, setup.machine));
    run = simulate_run(program, setup, watch.stage("simulating"));
    results.write(run, step, watch);
  }
  tell_of_run(run, options.run, asked.reading);
  if (!results.to_standard_output()) {
    fmt::print("{}", summary_text(run));
  }
  return exit_code_of(run);
}

}  // namespace

Command add_simulate_command(CLI::App& app) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Simulate an NC program on a machine and write the results");
  add_run_options(*command, options->run);
  add_run_number_option(*command, options->number);
  add_load_option(*command, options->load);
  command->add_option("--csv", options->csv, "Write the motion, one row per step; - for standard output")
      ->type_name("FILE");
  command
      ->add_option("--step", options->step, "Time between two rows in s [the machine's interpolation period]")
      ->type_name("S");
  command->add_option("--json", options->json, "Write numbers and messages; - for standard output")
      ->type_name("FILE");
  command
      ->add_option("--blends", options->blends,
                   "Write the inserted corner blends as CSV; - for standard output")
      ->type_name("FILE");
  command
      ->add_option(
          "--contour", options->contour,
          "Write the places of feed motions farthest from the programmed path as CSV, and add them and a "
          "histogram of the contour error to --json; - for standard output")
      ->type_name("FILE");
  add_number_option(
      *command, "--contour-places", whole_numbers(1, 1'000'000),
      [options](double count) { options->contour_places = static_cast<std::size_t>(count); },
      "Number of these places [20]")
      ->needs("--contour")
      ->type_name("N");
  return {command, [options] {
            move_tolerance(options->run);
            return simulate(*options);
          }};
}

}  // namespace feedscope
