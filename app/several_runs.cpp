#include "app/several_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "app/exit_codes.h"
#include "app/option_text.h"
#include "app/print.h"
#include "app/run_remarks.h"
#include "core/analysis/run/control_dialect.h"
#include "core/analysis/study/compare.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "ui/workbench/simulate_shown.h"

namespace feedscope {
namespace {

/// The assignments that at least one of `models` takes.
std::vector<std::string> taken_by_any(const std::vector<std::string>& models,
                                      std::vector<std::string> assignments) {
  std::erase_if(assignments, [&](const std::string& assignment) {
    return std::ranges::none_of(models, [&](const std::string& model) {
      const std::vector<std::string> keys = assignable_keys(find_model(model));
      return std::ranges::find(keys, assigned_key(assignment)) != keys.end();
    });
  });
  return assignments;
}

std::string options_of(const SeveralRunsOptions& asked, const std::string& machine, const Setup& setup) {
  const std::string& model = setup.model->info().id;
  std::string text = fmt::format("--machine {} --model {}", in_quotes(machine), model);
  const std::optional<double> tolerance = contour_tolerance(setup);
  if (!asked.tolerances.empty() && tolerance) {
    text += fmt::format(" --tolerance {}", *tolerance);
  }
  for (const std::string& assignment : taken_by_any({model}, asked.set)) {
    text += fmt::format(" --set {}", in_quotes(assignment));
  }
  if (!asked.load.empty()) {
    text += fmt::format(" --load {}", in_quotes(asked.load));
  }
  return text;
}

}  // namespace

void add_several_runs_options(CLI::App& command, SeveralRunsOptions& values) {
  add_program_options(command, values);
  const auto add_list = [&](const char* name, std::vector<std::string>& list, const std::string& text) {
    return command.add_option(name, list, text + "; repeat for more runs")->allow_extra_args(false);
  };
  add_list("--machine", values.machines, machine_help())->type_name("ID|FILE");
  add_list("--model", values.models, "Control model [the machine's own]")->type_name("ID");
  add_list("--tolerance", values.tolerances,
           "Contour tolerance in mm, instead of the program's own [otherwise the machine's]")
      ->type_name("MM");
  add_set_option(command, values.set);
  add_load_option(command, values.load);
}

std::vector<AskedRun> asked_runs(const SeveralRunsOptions& options, Dialect dialect) {
  std::vector<double> tolerances;
  for (const std::string& text : options.tolerances) {
    tolerances.push_back(parse_tolerance(text));
  }
  std::vector<AskedRun> runs;
  std::vector<std::string> all_used = options.models;
  const MachineLibrary library = shipped_machines();
  const LoadSetup load = asked_load(options.load);
  for (const std::string& machine :
       options.machines.empty() ? std::vector{default_machine_of(dialect)} : options.machines) {
    const std::vector<std::string> models =
        options.models.empty() ? std::vector{library.load(machine).model} : options.models;
    all_used.insert(all_used.end(), models.begin(), models.end());
    for (Setup& setup : setups_to_compare({machine}, models, tolerances, taken_by_any(models, options.set))) {
      const std::string text = options_of(options, machine, setup);
      setup.load = load;
      runs.push_back({std::move(setup), text});
    }
  }
  if (taken_by_any(all_used, options.set).size() < options.set.size()) {
    setups_to_compare(options.machines, all_used, {}, options.set);  // reports a key that no model knows
  }
  return runs;
}

std::string options_text(const SeveralRunsOptions& options) {
  std::string text = program_text(options);
  add_asked(text, "--machine", options.machines);
  add_asked(text, "--model", options.models);
  add_asked(text, "--tolerance", options.tolerances);
  add_asked(text, "--set", options.set);
  if (!options.load.empty()) {
    add_asked(text, "--load", {options.load});
  }
  return text;
}

std::vector<Setup> setups_of(const ui::ReportInput& input) {
  std::vector<Setup> setups;
  for (const ui::ReportRun& run : input.runs) {
    setups.push_back(run.shown->run.setup);
  }
  return setups;
}

int tell_of_shown_runs(const ui::ReportInput& input, const std::vector<std::string>& tolerances) {
  const std::vector<Setup> setups = setups_of(input);
  const Program& program = *input.program().program;
  if (!tolerances.empty()) {
    note_unused_tolerances(tolerances, setups);
    note_replaced_tolerance(*input.program().toolpath, setups);
  }
  std::vector<RemarkedSetup> remarked;
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    remarked.push_back({&setups[i], remarks(input.runs[i].shown->run)});
  }
  note_remarks(remarked);
  print_diagnostics(program);
  for (const ui::UnmadeRun& run : input.unmade) {
    fmt::print(stderr, "feedscope: {} could not be simulated: {}\n", run.name.toStdString(),
               run.why.english());
  }
  int code = input.unmade.empty() ? exit_code::done : exit_code::program_errors;
  std::set<std::string> machines;
  for (const ui::ReportRun& shown : input.runs) {
    const Run& run = shown.shown->run;
    if (machines.insert(run.setup.machine.id).second) {
      print_diagnostics(run.path.faults, program);
    }
    code = std::max(code, exit_code_of(run));
  }
  return code;
}

SimulatedRuns simulate_all(const ReadOptions& reading, const std::vector<ui::RunItem>& asked,
                           const LoadSetup& load, std::shared_ptr<const SourceText> source, Watch& watch,
                           const ui::ShownParts& parts) {
  const LoadedProgram program = load_program(std::move(source), watch.stage("reading"),
                                             reading_on(reading, asked.front().setup.file().machine));
  note_unused_reading(*program.program, reading);
  Progress& whole = *watch.stage("simulating");
  SimulatedRuns made;
  made.shown.resize(asked.size());
  std::vector<Message> faults(asked.size());
  in_parallel(asked.size(), [&](std::size_t i) {
    Progress part(whole, 1 / static_cast<double>(asked.size()));
    try {
      Setup setup = asked[i].setup.setup();
      setup.load = load;
      made.shown[i] = ui::simulate_shown(program, std::move(setup), &part, nullptr, parts);
    } catch (const InputError& error) {
      faults[i] = error.message();
    }
  });
  if (std::ranges::none_of(made.shown, [](const auto& shown) { return shown != nullptr; })) {
    throw InputError(faults.front());
  }
  const QStringList names = ui::run_titles(asked, program.feed_controls);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (made.shown[i] == nullptr) {
      made.unmade.push_back({names[static_cast<qsizetype>(i)], faults[i]});
    }
  }
  return made;
}

ui::ReportInput simulate_runs(const ReadOptions& reading, const std::vector<AskedRun>& runs,
                              std::shared_ptr<const SourceText> source, Watch& watch,
                              const ui::ShownParts& parts) {
  std::vector<ui::RunItem> items;
  for (const AskedRun& run : runs) {
    items.push_back({0, {}, {}, true, ui::SetupState(run.setup)});
  }
  SimulatedRuns made = simulate_all(reading, items, runs.front().setup.load, std::move(source), watch, parts);
  std::erase(made.shown, nullptr);
  ui::ReportInput input;
  input.runs = ui::report_runs(made.shown);
  input.unmade = std::move(made.unmade);
  return input;
}

}  // namespace feedscope
