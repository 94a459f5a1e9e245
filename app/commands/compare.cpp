#include <fmt/format.h>

#include <memory>

#include "app/commands/command.h"
#include "app/comparison_text.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/watch.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

struct CompareOptions {
  std::string file;
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<std::string> tolerances;  // as typed, mm
  std::vector<std::string> set;
  std::string csv;
  std::string json;
};

int compare(const CompareOptions& options) {
  std::vector<double> tolerances;
  for (const std::string& text : options.tolerances) {
    tolerances.push_back(parse_tolerance(text));
  }
  const std::vector<Setup> setups =
      setups_to_compare(options.machines, options.models, tolerances, options.set);
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
    fmt::print("{}", comparison_text(program, runs, options.set));
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
  add_set_option(*command, options->set);
  command->add_option("--csv", options->csv, "Write the figures, one row a run; - for standard output")
      ->type_name("FILE");
  command->add_option("--json", options->json, "Write figures and messages; - for standard output")
      ->type_name("FILE");
  return {command, [options] { return compare(*options); }};
}

}  // namespace feedscope
