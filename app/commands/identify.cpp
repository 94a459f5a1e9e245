#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/identification_text.h"
#include "app/number_option.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/trace_columns_option.h"
#include "app/watch.h"
#include "core/analysis/agreement/servo_period.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/export/identification.h"
#include "core/identification/part_times.h"
#include "core/identification/recordings.h"
#include "core/trace/read_trace.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/commands/language_option.h"
#include "app/identification_report.h"
#include "app/option_text.h"
#include "ui/paper/picture_file.h"
#endif

namespace feedscope {
namespace {

struct IdentifyCommandOptions {
  std::vector<std::string> traces;
  std::vector<std::string> programs;
  std::vector<std::string> models;
  std::vector<std::string> fit;
  std::vector<std::string> set;
  std::string machine;
  std::string dialect;
  std::string columns;
  std::string out;
  std::string json;
  std::string report;              ///< PDF or HTML
  std::string language;            ///< of the report
  std::string picture;             ///< of the test program
  std::optional<double> size;      ///< of the test program [mm]
  std::optional<double> feed_max;  ///< of the test program [mm/min]
};

std::vector<std::string> keys_of(const std::vector<std::string>& lists) {
  std::vector<std::string> keys;
  for (const std::string& list : lists) {
    for (std::size_t begin = 0; begin <= list.size();) {
      const auto end = std::min(list.find(',', begin), list.size());
      if (end > begin) {
        keys.push_back(list.substr(begin, end - begin));
      }
      begin = end + 1;
    }
  }
  return keys;
}

void check(const IdentifyCommandOptions& options) {
  if (options.programs.empty()) {
    throw InputError("identify needs the program of each trace: --program FILE...");
  }
  if (options.programs.size() != 1 && options.programs.size() != options.traces.size()) {
    throw InputError(fmt::format("{} traces and {} programs: give one program for each trace, or one for all",
                                 options.traces.size(), options.programs.size()));
  }
  if (options.models.empty() && options.machine.empty()) {
    throw InputError("identify needs the model that is fitted: --model ID, see feedscope models");
  }
  for (const std::string& input : options.traces) {
    check_outputs(input, {options.out, options.json, options.report}, "a trace");
  }
  for (const std::string& input : options.programs) {
    check_outputs(input, {options.out, options.json, options.report});
  }
#ifdef FEEDSCOPE_WITH_UI
  if (!options.report.empty()) {
    check_report_name(options.report);
  } else if (options.language != usual_language()) {
    throw InputError("--language has no effect without --report; give --report FILE.pdf too");
  }
#endif
}

/// The recordings and their programs as the command line names them.
class Work {
 public:
  /// Throws InputError for an unreadable file or an unknown model.
  Work(const IdentifyCommandOptions& options, Watch& watch) : options_(options), watch_(watch) {
    TraceColumns columns = asked_columns(options.columns);
    ReadOptions reading;
    if (!options.dialect.empty()) {
      reading.dialect = dialect_of_id(options.dialect);
    }
    for (const std::string& file : options.programs) {
      programs_.push_back(load_program(std::make_shared<const SourceText>(SourceText::from_file(file)),
                                       watch.stage("programs"), reading));
    }
    for (const std::string& model : options.models.empty() ? std::vector<std::string>{""} : options.models) {
      starts_.push_back(start_of(model));
      columns.machine_period =
          columns.machine_period > 0 ? columns.machine_period : servo_period_of(starts_.back());
    }
    traces_.resize(options.traces.size());
    tables_.resize(options.traces.size());
    for (std::size_t i = 0; i < options.traces.size(); ++i) {
      const std::string& file = options.traces[i];
      const LoadedProgram& program = programs_[programs_.size() == 1 ? 0 : i];
      if (is_section_times_file(file)) {
        tables_[i] = read_section_times(file);
        recordings_.add(tables_[i], file, program);
      } else {
        const auto trace = std::make_shared<const Trace>(read_trace(file, columns, watch.stage("traces")));
        notes_.push_back({file, trace->notes});
        traces_[i] = trace;
        recordings_.add(trace, program);
      }
    }
  }

  /// Initial setup of each requested model.
  const std::vector<Setup>& starts() const { return starts_; }

  Identification fit(const Setup& start) {
    IdentifyOptions how;
    how.date = date_of_today();
    Identification found =
        recordings_.fit(start,
                        options_.fit.empty() ? recordings_.usual_parameters(start)
                                             : fit_parameters_of(start, keys_of(options_.fit)),
                        how, [this](const char* title) { return watch_.stage(title); });
    remarks_ = recordings_.remarks();
    return found;
  }

  /// Messages on each trace from reading it.
  const std::vector<std::pair<std::string, std::vector<Diagnostic>>>& notes() const { return notes_; }
  const std::vector<LoadedProgram>& programs() const { return programs_; }
  /// Messages on each trace on its program; known after fit().
  const std::vector<std::vector<Diagnostic>>& remarks() const { return remarks_; }
  /// By recording; null or empty where the recording is of the other kind.
  const std::vector<std::shared_ptr<const Trace>>& traces() const { return traces_; }
  const std::vector<std::vector<SectionTime>>& tables() const { return tables_; }

 private:
  Setup start_of(const std::string& model) const {
    SetupRequest request;
    request.machine = options_.machine.empty() ? usual_machine_of(model) : options_.machine;
    request.model = model;
    request.assignments = options_.set;
    request.dialect = programs_.front().program->dialect;
    return make_setup(request);
  }

  const IdentifyCommandOptions& options_;
  Watch& watch_;
  std::vector<std::pair<std::string, std::vector<Diagnostic>>> notes_;
  std::vector<LoadedProgram> programs_;
  std::vector<Setup> starts_;
  std::vector<std::shared_ptr<const Trace>> traces_;
  std::vector<std::vector<SectionTime>> tables_;
  Recordings recordings_;
  std::vector<std::vector<Diagnostic>> remarks_;
};

/// Result of each model, the best explanation first, and the models that failed.
struct Compared {
  std::vector<Identification> models;
  std::vector<UnfittedModel> unfitted;
};

/// Throws InputError if no model can be fitted.
Compared compare(Work& work) {
  Compared compared;
  for (const Setup& start : work.starts()) {
    try {
      compared.models.push_back(work.fit(start));
    } catch (const InputError& error) {
      compared.unfitted.push_back({start.model->info().title, error.message(), start.model->info().id});
    }
  }
  if (compared.models.empty()) {
    throw InputError(compared.unfitted.front().reason);
  }
  sort_by_explanation(compared.models);
  return compared;
}

#ifdef FEEDSCOPE_WITH_UI

std::string command_of(const IdentifyCommandOptions& options) {
  std::string command = "feedscope identify";
  const auto add = [&](const char* name, const std::string& value) {
    command += value.empty() ? "" : fmt::format(" {} {}", name, in_quotes(value));
  };
  for (const std::string& file : options.traces) {
    command += ' ' + in_quotes(file);
  }
  for (const auto& [name, values] :
       {std::pair("--program", &options.programs), std::pair("--model", &options.models),
        std::pair("--fit", &options.fit), std::pair("--set", &options.set)}) {
    for (const std::string& value : *values) {
      add(name, value);
    }
  }
  add("--machine", options.machine);
  add("--dialect", options.dialect);
  add("--columns", options.columns);
  add("--out", options.out);
  add("--language", options.language == usual_language() ? "" : options.language);
  add("--report", options.report);
  return command;
}

std::string report_of(const IdentifyCommandOptions& options, const Work& work, const Compared& found,
                      Watch& watch) {
  IdentificationReport report{found.models,        found.unfitted,  {}, options.out == "-" ? "" : options.out,
                              command_of(options), options.language};
  for (std::size_t i = 0; i < options.traces.size(); ++i) {
    report.recordings.push_back(
        {options.traces[i], work.traces()[i], work.tables()[i], i == 0 || options.programs.size() == 1});
  }
  return identification_report(report, options.report, watch);
}

#endif

/// Writes the test program for the machine; used without traces.
int write_program(const IdentifyCommandOptions& options) {
  if (!options.programs.empty() || !options.json.empty() || !options.columns.empty() ||
      !options.fit.empty() || !options.report.empty()) {
    throw InputError(
        "identify needs traces: feedscope identify TRACE... --program FILE... --model ID; for the test "
        "program "
        "write feedscope identify --program --dialect ID --out FILE");
  }
  if (options.dialect.empty()) {
    throw InputError("the test program needs --dialect: fanuc, linuxcnc, grbl, sinumerik, heidenhain or iso");
  }
  IdentificationProgramRequest request;
  request.dialect = dialect_of_id(options.dialect);
  request.size = options.size.value_or(request.size);
  request.feed_max = options.feed_max ? units::from_mm_min(*options.feed_max) : request.feed_max;
  const IdentificationProgram made = identification_program(request);
  const std::string out = options.out.empty() ? "-" : options.out;
#ifdef FEEDSCOPE_WITH_UI
  if (!options.picture.empty() && ui::picture_format_of(options.picture) != ui::PictureFormat::png) {
    throw InputError("--picture '" + options.picture + "' is written as PNG; end its name in .png");
  }
#endif
  OutputFiles files;
  files.add(out) << made.text;
  std::ostream* picture = options.picture.empty() ? nullptr : &files.add(options.picture);
  if (out == "-" && picture == nullptr) {
    files.commit();
    return exit_code::done;
  }
  SetupRequest asked;
  asked.machine = options.machine;
  asked.model = options.models.empty() ? "" : options.models.front();
  asked.assignments = options.set;
  asked.dialect = request.dialect;
  const Setup setup = make_setup(asked);
  ReadOptions reading;
  reading.dialect = request.dialect;
  const Run run = simulate_run(
      load_program(std::make_shared<const SourceText>(SourceText(out, made.text)), nullptr, reading), setup);
#ifdef FEEDSCOPE_WITH_UI
  if (picture != nullptr) {
    constexpr ui::PictureSize size{1280, 960};
    *picture << ui::to_png(ui::draw_run(run, size, ui::StandardView::top));
  }
#endif
  files.commit();
  if (out == "-") {
    return exit_code::done;
  }
  fmt::print("{}: X and Y within +-{:.4g} mm of the zero point, Z from it up to {:.4g} mm; {} on {}\n", out,
             request.size / 2, made.height, time_text(run.summary.cycle_time), setup.machine.id);
  const std::vector<LineTime> times = part_times(made, *run.trajectory);
  TextTable table;
  table.add({"line", "part", "time", "tells"});
  for (std::size_t i = 0; i < made.parts.size(); ++i) {
    const IdentificationProgramPart& part = made.parts[i];
    table.add({fmt::format("{}", part.line), part.title, time_text(times[i].time), part.tells});
  }
  fmt::print("{}{} sections, marked by comments{}\n", table.text("rlrl"), made.sections,
             request.dialect == Dialect::fanuc       ? "; their times are in #101 and on, in ms"
             : request.dialect == Dialect::sinumerik ? "; their times are in R1 and on, in s"
                                                     : "");
  return exit_code::done;
}

int identify_machine(const IdentifyCommandOptions& options) {
  if (options.traces.empty()) {
    return write_program(options);
  }
  if (options.size || options.feed_max || !options.picture.empty()) {
    throw InputError(
        "--size, --feed-max and --picture are of the test program; they have no effect on traces");
  }
  check(options);
  OutputFiles files;
  std::ostream* out = options.out.empty() ? nullptr : &files.add(options.out);
  std::ostream* json = options.json.empty() ? nullptr : &files.add(options.json);
#ifdef FEEDSCOPE_WITH_UI
  std::ostream* report = options.report.empty() ? nullptr : &files.add(options.report);
#endif
  Compared found;
  bool wrong_programs = false;
  {
    Watch watch;
    Work work(options, watch);
    for (const auto& [file, notes] : work.notes()) {
      print_diagnostics(notes, file);
    }
    for (const LoadedProgram& program : work.programs()) {
      print_diagnostics(*program.program);
      wrong_programs = wrong_programs || has_errors(program.program->diagnostics);
    }
    found = compare(work);
    for (std::size_t i = 0; i < options.traces.size(); ++i) {
      print_diagnostics(work.remarks()[i], options.traces[i]);
    }
#ifdef FEEDSCOPE_WITH_UI
    if (report != nullptr) {
      *report << report_of(options, work, found, watch);
    }
#endif
  }
  if (out != nullptr) {
    *out << write_machine(identified_machine(found.models.front(), options.out));
  }
  if (json != nullptr) {
    *json << identification_json(found.models, options.traces, found.unfitted);
  }
  files.commit();
  if (options.out != "-" && options.json != "-" && options.report != "-") {
    fmt::print("{}", identification_text(found.models, options.traces, found.unfitted));
    if (!options.out.empty()) {
      fmt::print("{}: machine file; see: feedscope machines {}\n{}", options.out, options.out,
                 undetermined_text(found.models.front()));
    }
  }
  return wrong_programs || !found.models.front().explains ? exit_code::program_errors : exit_code::done;
}

}  // namespace

Command add_identify_command(CLI::App& app) {
  const auto options = std::make_shared<IdentifyCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "identify",
      "Find the limits and settings of a machine from traces of its control; without traces: "
      "write the program that tells them");
  command->add_option("TRACE", options->traces,
                      "Traces, as feedscope trace reads them, or tables of section times (section,seconds)");
  command
      ->add_option("--program", options->programs,
                   "NC program of each trace, in their order; without traces and FILE: write the test "
                   "program")
      ->type_name("FILE")
      ->expected(0, -1);
  command->add_option("--model", options->models, "Model that is fitted; repeat to compare several")
      ->type_name("ID")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--fit", options->fit,
          "What is to be found, such as X.acceleration,jerk,blend_tolerance_mm,X.kv [limits of the axes, "
          "settings with a unit, and drives whose set and actual positions are recorded]")
      ->type_name("KEY,...")
      ->allow_extra_args(false);
  command
      ->add_option("--machine", options->machine, "Machine that is begun with [one of the model's control]")
      ->type_name("ID|FILE");
  add_set_option(*command, options->set);
  command->add_option("--dialect", options->dialect, "Dialect of the programs [auto-detected]")
      ->type_name("ID");
  add_columns_option(*command, options->columns);
  command->add_option("--out", options->out, "Machine file that is written; - for standard output")
      ->type_name("FILE.toml");
  command->add_option("--json", options->json, "Write numbers and uncertainties; - for standard output")
      ->type_name("FILE");
  add_number_option(
      *command, "--size", numbers(20, 2000), [options](double size) { options->size = size; },
      "Without traces: side of the square that the test program keeps to, in mm [200]")
      ->type_name("MM");
  add_number_option(
      *command, "--feed-max", numbers(100, 100'000), [options](double feed) { options->feed_max = feed; },
      "Without traces: largest feed of the test program, in mm/min [15000]")
      ->type_name("MM_MIN");
#ifdef FEEDSCOPE_WITH_UI
  command
      ->add_option("--report", options->report,
                   "Write a report of the first program on the machine that was found, with its traces")
      ->type_name("FILE.pdf|FILE.html");
  add_language_option(*command, options->language);
  command
      ->add_option("--picture", options->picture,
                   "Without traces: draw the test program from above, coloured by its feed")
      ->type_name("FILE.png");
#endif
  state_number_rule(*command);
  command->footer(
      command->get_footer() +
      "\nExample: feedscope identify sampler.txt --program part.ngc --model linuxcnc --out mill.toml"
      "\n         feedscope identify --program --dialect sinumerik --size 200 --feed-max 15000 --out "
      "test.mpf");
  return {command, [options] {
            std::erase(options->programs, "");  // --program without a value means the test program
            return identify_machine(*options);
          }};
}

}  // namespace feedscope
