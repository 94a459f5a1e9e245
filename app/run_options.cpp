#include "app/run_options.h"

#include <fmt/format.h>

#include <cstdio>

namespace feedscope {

SetupRequest RunOptions::request() const {
  SetupRequest request{machine, model, {}, set};
  if (!tolerance.empty()) {
    request.tolerance = parse_tolerance(tolerance);
  }
  return request;
}

double parse_tolerance(const std::string& text) {
  SettingSpec number;
  number.key = "--tolerance";
  number.unit = "mm";
  return std::get<double>(parse_setting(number, text));
}

void add_program_option(CLI::App& command, std::string& file) {
  command.add_option("FILE", file, "NC program; - for standard input")->required();
}

void add_run_options(CLI::App& command, RunOptions& values) {
  add_program_option(command, values.file);
  command
      .add_option("--machine", values.machine,
                  fmt::format("Machine id or machine file [{}]", default_machine))
      ->type_name("ID|FILE");
  command.add_option("--model", values.model, "Control model [the machine's own]")->type_name("ID");
  command.add_option("--tolerance", values.tolerance, "Contour tolerance in mm [the machine's own]")
      ->type_name("MM");
  add_set_option(command, values.set);
}

void add_set_option(CLI::App& command, std::vector<std::string>& assignments) {
  command
      .add_option(
          "--set", assignments,
          "Change a setting of the model (alpha=2) or a limit of an axis (X.jerk=20); repeat for more")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void note_unused_tolerance(const RunOptions& options, const Setup& setup) {
  if (!options.tolerance.empty() && !contour_tolerance(setup)) {
    fmt::print(stderr, "feedscope: note: model '{}' does not read a contour tolerance\n",
               setup.model->info().id);
  }
}

}  // namespace feedscope
