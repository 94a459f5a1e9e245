#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/asked_program.h"
#include "app/commands/command.h"
#include "app/explanation_text.h"
#include "app/output_file.h"
#include "app/run_options.h"
#include "app/run_remarks.h"
#include "app/watch.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

struct ExplainOptions {
  RunOptions run;
  std::string operations;  ///< as typed
  std::string json;
  std::optional<std::size_t> number;  ///< of a run of a session, from 1
};

int explain(const ExplainOptions& options) {
  const AskedProgram asked = asked_program(options.run, given_of_run(options.run));
  const Setup setup = asked_setup(options.run, options.number, asked);
  const OperationSplit split =
      options.operations.empty() ? OperationSplit::none : operation_split(options.operations);
  for (const std::string& input : {options.run.file, asked.file}) {
    check_outputs(input, {options.json});
  }
  OutputFiles files;
  std::ostream* json = options.json.empty() ? nullptr : &files.add(options.json);
  Run run;
  TimeReport report;
  {
    Watch watch;
    const LoadedProgram program =
        load_program(asked.source, watch.stage("reading"), reading_on(asked.reading, setup.machine));
    run = simulate_run(program, setup, watch.stage("simulating"));
    report = time_report(run, split, watch.stage("trying changes"));
    if (json != nullptr) {
      *json << explanation_json(run, figures_of(run), report);
    }
    files.commit();
  }
  tell_of_run(run, options.run, asked.reading);
  if (options.json != "-") {
    fmt::print("{}", explanation_text(run, report, ProgramOptions::of(asked.file, asked.reading),
                                      asked.is_session() ? nullptr : &options.run));
  }
  return exit_code_of(run);
}

}  // namespace

Command add_explain_command(CLI::App& app) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* command =
      app.add_subcommand("explain", "Say where the time of an NC program goes and what would help");
  add_run_options(*command, options->run);
  add_run_number_option(*command, options->number);
  command
      ->add_option("--operations", options->operations,
                   "Operations by tool or by comment [by tool where several work, else by comment]")
      ->type_name("tool|comment");
  command->add_option("--json", options->json, "Write all of it; - for standard output")->type_name("FILE");
  return {command, [options] {
            move_tolerance(options->run);
            return explain(*options);
          }};
}

}  // namespace feedscope
