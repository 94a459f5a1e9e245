#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/asked_program.h"
#include "app/commands/command.h"
#include "app/comparison_text.h"
#include "app/exit_codes.h"
#include "app/headline_text.h"
#include "app/merge_text.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/program_difference_text.h"
#include "app/run_options.h"
#include "app/run_remarks.h"
#include "app/study_text.h"
#include "app/watch.h"
#include "core/analysis/difference/program_difference.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/run/control_dialect.h"
#include "core/base/error.h"
#include "core/export/export.h"
#include "core/export/merge.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/commands/language_option.h"
#include "app/picture_size.h"
#include "ui/window/panels/pictures_of_panels.h"
#endif

namespace feedscope {
namespace {

struct CompareOptions : ProgramOptions {
  std::string other;  ///< a newer version of the program; may be empty
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<std::string> tolerances;  // [mm], as typed
  std::vector<std::string> set;
  std::string load;                 // name of a load file
  std::vector<std::string> sweeps;  // as typed
  std::string within;               // [mm], as typed
  std::string operations;           // as typed
  std::vector<std::string> merge;   // JSON files
  std::string csv;
  std::string json;
  std::string png;
  std::string size;      // as typed, WxH
  std::string language;  // of the picture
};

/// A requested file and its contents.
struct Result {
  std::string name;
  std::function<std::string(const LoadedProgram&, const Study&)> contents;
};

std::vector<ComparedRun> plain_runs(const Study& study) {
  return {study.runs.begin(), study.runs.end()};
}

/// Whether there is nothing to write beyond compare without --sweep, --within and --operations.
bool is_plain(const Study& study) {
  return study.sweeps.empty() && !study.within && study.operations.empty();
}

#ifdef FEEDSCOPE_WITH_UI
Result picture(const CompareOptions& options, const StudyRequest& request, const std::vector<Setup>& setups) {
  std::optional<ui::PictureSize> size;
  if (!options.size.empty()) {
    size = parse_picture_size(options.size);
  }
  if (!request.sweeps.empty()) {
    ui::check_study_size(request.sweeps, setups.size(), size);
    return {options.png, [&options, size](const LoadedProgram& program, const Study& study) {
              return ui::to_png(ui::draw_study(program, study, options.set, size,
                                               QString::fromStdString(options.language)));
            }};
  }
  ui::check_comparison_size(setups, size);
  return {options.png, [&options, size](const LoadedProgram& program, const Study& study) {
            return ui::to_png(ui::draw_comparison(program, plain_runs(study), options.set, size,
                                                  QString::fromStdString(options.language)));
          }};
}
#endif

std::vector<Result> results_of(const CompareOptions& options, [[maybe_unused]] const StudyRequest& request,
                               [[maybe_unused]] const std::vector<Setup>& setups) {
  std::vector<Result> results{
      {options.csv,
       [](const LoadedProgram&, const Study& study) {
         return is_plain(study) ? comparison_csv(plain_runs(study)) : study_csv(study);
       }},
      {options.json, [](const LoadedProgram& program, const Study& study) {
         return is_plain(study) ? comparison_json(program, plain_runs(study)) : study_json(program, study);
       }}};
#ifdef FEEDSCOPE_WITH_UI
  if (!options.png.empty()) {
    results.push_back(picture(options, request, setups));
  }
#endif
  std::erase_if(results, [](const Result& result) { return result.name.empty(); });
  return results;
}

/// Result files, opened before the work begins and moved to their place after all are written.
class ResultFiles {
 public:
  ResultFiles(const std::vector<std::string>& inputs, std::vector<Result> results)
      : results_(std::move(results)) {
    std::vector<std::string> names;
    for (const Result& result : results_) {
      names.push_back(result.name);
    }
    for (const std::string& input : inputs) {
      check_outputs(input, names);
    }
    for (const std::string& name : names) {
      streams_.push_back(&files_.add(name));
      to_standard_output_ = to_standard_output_ || name == "-";
    }
  }

  void write(const LoadedProgram& program, const Study& study) {
    for (std::size_t i = 0; i < results_.size(); ++i) {
      *streams_[i] << results_[i].contents(program, study);
    }
    files_.commit();
  }

  bool to_standard_output() const { return to_standard_output_; }

 private:
  std::vector<Result> results_;
  OutputFiles files_;
  std::vector<std::ostream*> streams_;  // of files_, in the order of results_
  bool to_standard_output_ = false;
};

StudyRequest request_of(const CompareOptions& options, const AskedProgram& asked) {
  StudyRequest request{options.machines, options.models, {}, options.set, {}, {}, {}, asked.setups};
  if (request.machines.empty() && !asked.is_session()) {
    request.machines = {default_machine_of(asked.dialect())};
  }
  for (const std::string& text : options.tolerances) {
    request.tolerances.push_back(parse_tolerance(text));
  }
  request.load = asked_load(options.load);
  for (const std::string& text : options.sweeps) {
    request.sweeps.push_back(parse_sweep(text));
  }
  if (!options.within.empty()) {
    request.within = parse_length(options.within, "--within");
  }
  if (!options.operations.empty()) {
    request.split = operation_split(options.operations);
  }
  return request;
}

std::string text_of(const CompareOptions& options, const LoadedProgram& program, const Study& study) {
  const std::string headline = headline_text(plain_runs(study), names_among(study), study.within);
  std::string text = headline.empty() ? "" : wrapped(headline, 0) + "\n\n";
  if (!study.sweeps.empty()) {
    return text + study_text(program, study, options.set);
  }
  text += comparison_text(program, plain_runs(study), options.set);
  if (study.within && headline.empty()) {
    text += "\n" + fastest_text(study);
  }
  for (const StudyRun& run : study.runs) {
    if (!run.operations.empty()) {
      text += fmt::format("\nOperations: {} on {}\n{}", run.setup.model->info().id, run.setup.machine.name,
                          operations_text(study, run));
    }
  }
  return text;
}

int merge(const CompareOptions& options) {
  std::vector<NamedText> files;
  for (const std::string& name : options.merge) {
    files.push_back({name, SourceText::from_file(name).text()});
    check_outputs(name, {options.csv, options.json});
  }
  std::optional<double> within;
  if (!options.within.empty()) {
    within = parse_length(options.within, "--within");
  }
  const MergedComparison merged = merge_comparisons(files, within);
  OutputFiles results;
  if (!options.csv.empty()) {
    results.add(options.csv) << merged_csv(merged);
  }
  if (!options.json.empty()) {
    results.add(options.json) << merged_json(merged);
  }
  results.commit();
  if (options.csv != "-" && options.json != "-") {
    fmt::print("{}", merge_text(merged));
  }
  return exit_code::done;
}

/// Compares two programs on one setup.
int compare_two(const CompareOptions& options) {
  const auto refuse = [&](bool given, const char* option) {
    if (given) {
      throw InputError(fmt::format("{} has no effect on two programs; give one program", option));
    }
  };
  refuse(!options.sweeps.empty(), "--sweep");
  refuse(!options.within.empty(), "--within");
  refuse(!options.operations.empty(), "--operations");
  refuse(!options.csv.empty(), "--csv");
  refuse(!options.png.empty(), "--png");
  const auto one = [](const std::vector<std::string>& values, const char* option) {
    if (values.size() > 1) {
      throw InputError(fmt::format("two programs are compared on one setup; give {} once, not {} times",
                                   option, values.size()));
    }
    return values.empty() ? std::string() : values.front();
  };
  const std::string tolerance = one(options.tolerances, "--tolerance");
  SetupRequest request{one(options.machines, "--machine"), one(options.models, "--model"),
                       tolerance.empty() ? std::nullopt : std::optional(parse_tolerance(tolerance)),
                       options.set};
  for (const std::string& file : {options.file, options.other}) {
    if (names_session(file)) {
      throw InputError(fmt::format(
          "'{}' is a session; two programs are compared on one setup: give the NC programs themselves",
          file));
    }
  }
  const ReadOptions reading = options.reading();
  const auto old_source = std::make_shared<const SourceText>(SourceText::from_file(options.file));
  const auto new_source = std::make_shared<const SourceText>(SourceText::from_file(options.other));
  request.dialect = dialect_of(options, *new_source);
  Setup setup = make_setup(request);
  setup.load = asked_load(options.load);
  for (const std::string& input : {options.file, options.other, options.load}) {
    check_outputs(input, {options.json});
  }
  OutputFiles files;
  std::ostream* const json = options.json.empty() ? nullptr : &files.add(options.json);
  Run old;
  Run now;
  ProgramDifference difference;
  {
    Watch watch;
    const ReadOptions how = reading_on(reading, setup.machine);
    old =
        simulate_run(load_program(old_source, watch.stage("reading"), how), setup, watch.stage("simulating"));
    now =
        simulate_run(load_program(new_source, watch.stage("reading"), how), setup, watch.stage("simulating"));
    difference = compare_programs(old, now);
  }
  if (json != nullptr) {
    *json << program_difference_json(old, now, difference);
  }
  files.commit();
  if (!tolerance.empty()) {
    note_unused_tolerances({tolerance}, {now.setup});
  }
  const RemarkedSetup remarked{&now.setup, remarks(now)};
  note_remarks({&remarked, 1});
  for (const Run* run : {&old, &now}) {
    print_messages(*run);
  }
  if (options.json != "-") {
    fmt::print("{}", program_difference_text(old, now, difference));
  }
  return std::max(exit_code_of(old), exit_code_of(now));
}

int compare(const CompareOptions& options) {
  if (!options.merge.empty()) {
    if (!options.file.empty()) {
      throw InputError(fmt::format("--merge accepts JSON files only, not the program '{}'", options.file));
    }
    return merge(options);
  }
  if (options.file.empty()) {
    throw InputError("no program given; give one, or the results of others with --merge");
  }
  if (!options.other.empty()) {
    return compare_two(options);
  }
  const AskedProgram asked = asked_program(options, {{"--machine", !options.machines.empty()},
                                                     {"--model", !options.models.empty()},
                                                     {"--tolerance", !options.tolerances.empty()},
                                                     {"--set", !options.set.empty()}});
  const StudyRequest request = request_of(options, asked);
  std::vector<Setup> setups;
  for (StudySetup& one : setups_to_study(request)) {
    setups.push_back(std::move(one.setup));
  }
  ResultFiles files({options.file, asked.file, options.load}, results_of(options, request, setups));
  LoadedProgram program;
  Study study;
  {
    Watch watch;
    program =
        load_program(asked.source, watch.stage("reading"), reading_on(asked.reading, setups.front().machine));
    study = run_study(program, request, watch.stage("simulating"));
  }
  files.write(program, study);
  const bool replaces_tolerance =
      std::ranges::any_of(request.sweeps, [](const Sweep& sweep) { return sweep.key == "tolerance"; });
  if (!request.tolerances.empty() || replaces_tolerance) {
    note_replaced_tolerance(*program.toolpath, setups);
  }
  note_unused_reading(*program.program, asked.reading);
  std::vector<RemarkedSetup> remarked;
  for (const StudyRun& run : study.runs) {
    remarked.push_back({&run.setup, run.remarks});
  }
  note_remarks(remarked);
  print_diagnostics(*program.program);
  if (!files.to_standard_output()) {
    fmt::print("{}", text_of(options, program, study));
  }
  const bool out_of_reach = std::ranges::any_of(study.runs, &StudyRun::out_of_reach);
  return has_errors(program.program->diagnostics) || out_of_reach ? exit_code::program_errors
                                                                  : exit_code::done;
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "Simulate a program on several machines, models and tolerances, side by side, or two programs");
  add_program_options(*command, *options);
  const auto add_list = [&](const char* name, std::vector<std::string>& values, const std::string& text) {
    return command->add_option(name, values, text + "; repeat for more")->allow_extra_args(false);
  };
  add_list("--machine", options->machines, machine_help())->type_name("ID|FILE");
  add_list("--model", options->models, "Control model [all]")->type_name("ID");
  add_list("--tolerance", options->tolerances,
           "Contour tolerance in mm, instead of the program's own [otherwise the machine's]")
      ->type_name("MM");
  add_set_option(*command, options->set);
  add_load_option(*command, options->load);
  command->get_option("FILE")->required(false);
  command
      ->add_option(
          "NEW", options->other,
          "Another version of the program: where it takes less or more time, matched by the path, on "
          "one machine with one model")
      ->type_name("");
  add_list("--sweep", options->sweeps,
           "Study a setting: tolerance=0.005:0.1:log12, X.jerk=10:50:lin5, filters=\"2;3\"")
      ->type_name("KEY=RANGE");
  command
      ->add_option("--within", options->within, "Maximum contour error in mm of the run that is recommended")
      ->type_name("MM");
  command->add_option("--operations", options->operations, "Numbers by operation: tool or comment")
      ->type_name("tool|comment");
  command
      ->add_option("--merge", options->merge,
                   "Merge files that --json wrote for several programs, without FILE")
      ->type_name("JSON");
  command->add_option("--csv", options->csv, "Write the numbers, one row per run; - for standard output")
      ->type_name("FILE");
  command->add_option("--json", options->json, "Write numbers and messages; - for standard output")
      ->type_name("FILE");
#ifdef FEEDSCOPE_WITH_UI
  CLI::Option* png =
      command
          ->add_option("--png", options->png,
                       "Draw the runs as bars, a sweep as curves, two as a map; - for standard output")
          ->type_name("FILE");
  command
      ->add_option("--size", options->size,
                   "Width and height of the picture [1280 x the height that the runs need]")
      ->type_name("WxH")
      ->needs(png);
  add_language_option(*command, options->language);
  command->get_option("--language")->needs(png);
#endif
  return {command, [options] {
            move_tolerance(options->set, options->tolerances);
            return compare(*options);
          }};
}

}  // namespace feedscope
