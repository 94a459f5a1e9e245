#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/comparison_text.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/watch.h"
#include "core/export/export.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/picture_size.h"
#include "ui/window_picture.h"
#endif

namespace feedscope {
namespace {

struct CompareOptions : ProgramOptions {
  std::vector<std::string> machines;
  std::vector<std::string> models;
  std::vector<std::string> tolerances;  // as typed, mm
  std::vector<std::string> set;
  std::string csv;
  std::string json;
  std::string png;
  std::string size;  // as typed, WxH
};

/// A file that was asked for, and what goes into it.
struct Result {
  std::string name;
  std::function<std::string(const LoadedProgram&, const std::vector<ComparedRun>&)> contents;
};

#ifdef FEEDSCOPE_WITH_UI
Result picture(const CompareOptions& options, const std::vector<Setup>& setups) {
  std::optional<ui::PictureSize> size;
  if (!options.size.empty()) {
    size = parse_picture_size(options.size);
  }
  ui::check_comparison_size(setups, size);
  return {options.png, [&options, size](const LoadedProgram& program, const std::vector<ComparedRun>& runs) {
            return ui::to_png(ui::draw_comparison(program, runs, options.set, size));
          }};
}
#endif

std::vector<Result> results_of(const CompareOptions& options,
                               [[maybe_unused]] const std::vector<Setup>& setups) {
  std::vector<Result> results{
      {options.csv,
       [](const LoadedProgram&, const std::vector<ComparedRun>& runs) { return comparison_csv(runs); }},
      {options.json, [](const LoadedProgram& program, const std::vector<ComparedRun>& runs) {
         return comparison_json(program, runs);
       }}};
#ifdef FEEDSCOPE_WITH_UI
  if (!options.png.empty()) {
    results.push_back(picture(options, setups));
  }
#endif
  std::erase_if(results, [](const Result& result) { return result.name.empty(); });
  return results;
}

/// Result files that are opened before the work begins and moved to their place after all are written.
class ResultFiles {
 public:
  ResultFiles(const std::string& input, std::vector<Result> results) : results_(std::move(results)) {
    std::vector<std::string> names;
    for (const Result& result : results_) {
      names.push_back(result.name);
    }
    check_outputs(input, names);
    for (const std::string& name : names) {
      files_.push_back(std::make_unique<OutputFile>(name));
      to_standard_output_ = to_standard_output_ || name == "-";
    }
  }

  void write(const LoadedProgram& program, const std::vector<ComparedRun>& runs) {
    for (std::size_t i = 0; i < results_.size(); ++i) {
      files_[i]->stream() << results_[i].contents(program, runs);
    }
    for (const auto& file : files_) {
      file->commit();
    }
  }

  bool to_standard_output() const { return to_standard_output_; }

 private:
  std::vector<Result> results_;
  std::vector<std::unique_ptr<OutputFile>> files_;
  bool to_standard_output_ = false;
};

int compare(const CompareOptions& options) {
  std::vector<double> tolerances;
  for (const std::string& text : options.tolerances) {
    tolerances.push_back(parse_tolerance(text));
  }
  const std::vector<Setup> setups =
      setups_to_compare(options.machines, options.models, tolerances, options.set);
  const auto source = std::make_shared<const SourceText>(SourceText::from_file(options.file));
  ResultFiles files(options.file, results_of(options, setups));
  LoadedProgram program;
  std::vector<ComparedRun> runs;
  {
    Watch watch;
    program = load_program(source, watch.stage("reading"), options.reading());
    runs = compare_runs(program, setups, watch.stage("simulating"));
  }
  files.write(program, runs);
  if (!tolerances.empty()) {
    note_replaced_tolerance(*program.toolpath);
  }
  print_diagnostics(*program.program);
  if (!files.to_standard_output()) {
    fmt::print("{}", comparison_text(program, runs, options.set));
  }
  return has_errors(program.program->diagnostics) ? exit_code::program_errors : exit_code::done;
}

}  // namespace

Command add_compare_command(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare", "Simulate a program on several machines, models and tolerances, side by side");
  add_program_options(*command, *options);
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
#ifdef FEEDSCOPE_WITH_UI
  CLI::Option* png =
      command->add_option("--png", options->png, "Draw the runs as bars; - for standard output")
          ->type_name("FILE");
  command
      ->add_option("--size", options->size, "Width and height of the picture [1280 and what the runs need]")
      ->type_name("WxH")
      ->needs(png);
#endif
  return {command, [options] { return compare(*options); }};
}

}  // namespace feedscope
