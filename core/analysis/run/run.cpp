#include "core/analysis/run/run.h"

#include <algorithm>
#include <chrono>

#include "core/analysis/envelope/rotary_walk.h"
#include "core/analysis/run/beyond_machines.h"
#include "core/analysis/run/control_dialect.h"
#include "core/analysis/run/run_stages.h"
#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "core/limits/axis_share.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

class StopWatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

const SettingSpec& tolerance_spec() {
  const auto& specs = common_settings();
  return *std::find_if(specs.begin(), specs.end(),
                       [](const SettingSpec& spec) { return spec.key == contour_tolerance_key; });
}

std::vector<PathControl> controls_of_feed_motions(const Toolpath& toolpath) {
  std::vector<PathControl> controls;
  std::vector<bool> met(toolpath.path_controls.size());
  for (const Segment& segment : toolpath.segments) {
    const bool feeds = segment.kind != SegmentKind::dwell && !segment.rapid;
    if (feeds && !met[segment.path_control]) {
      met[segment.path_control] = true;
      controls.push_back(toolpath.path_controls[segment.path_control]);
    }
  }
  return controls;
}

Message place_and_message(const Diagnostic& said, const Program& program) {
  return message(NC_("core", "{}, line {}: {}"), said.file.empty() ? program.source->name() : said.file,
                 said.line, said.message);
}

/// `limit`, and the first error or omission in a program that does not end.
Message with_likely_cause(const Message& limit, const Program& program) {
  const auto cause = std::ranges::find_if(program.diagnostics, [](const Diagnostic& said) {
    return said.severity != Severity::info && said.code != "run-limit" && said.line > 0;
  });
  return cause == program.diagnostics.end() ? limit
                                            : message(NC_("core", "{}; before that, {} ({})"), limit,
                                                      place_and_message(*cause, program), cause->hint);
}

[[noreturn]] void throw_beyond_machines(const Program& program, const Diagnostic& fault) {
  throw InputError(message(NC_("core", "{}; {}"), place_and_message(fault, program), fault.hint));
}

[[noreturn]] void throw_refused(const Program& program) {
  const auto beyond = std::ranges::find(program.diagnostics, "beyond-machines", &Diagnostic::code);
  if (beyond != program.diagnostics.end()) {
    throw_beyond_machines(program, *beyond);
  }
  const auto limit = std::find_if(program.diagnostics.begin(), program.diagnostics.end(),
                                  [](const Diagnostic& d) { return d.code == "run-limit"; });
  const Message why = limit == program.diagnostics.end()
                          ? Message::as_written(program.source->name())
                          : with_likely_cause(place_and_message(*limit, program), program);
  throw InputError(message(NC_("core",
                               "{}; the program is not simulated: check its loops, raise the limit "
                               "(--repeat-limit), or simulate the part that was read (--simulate-cut-off)"),
                           why));
}

/// The messages of the reader, after that on the chord error and before that on a motion `beyond` machines.
Program with_path_messages(Program program, const LoadedProgram& loaded,
                           const std::optional<Diagnostic>& beyond) {
  if (loaded.chord_error) {
    program.diagnostics.insert(program.diagnostics.begin(),
                               chord_error_message(*loaded.chord_error, loaded.feed_controls));
  }
  if (beyond) {
    program.diagnostics.push_back(*beyond);
  }
  return program;
}

/// None without operations. Throws InputError as LoadModel does.
std::optional<LoadModel> load_model(const Run& run, const LoadSetup& load) {
  return load.empty() ? std::nullopt
                      : std::optional<LoadModel>(std::in_place, load, *run.input.program, *run.path);
}

void set_load(Run& run, std::optional<LoadModel> load) {
  run.sources.load = load ? std::make_shared<const RunLoad>(run.trajectory, *std::move(load)) : nullptr;
}

}  // namespace

std::vector<SettingSpec> machine_file_settings() {
  std::vector<SettingSpec> specs = all_model_settings();
  SettingSpec model;
  model.key = "model";
  for (const ControlModel* known : all_models()) {
    model.choices.push_back(known->info().id);
  }
  specs.push_back(std::move(model));
  return specs;
}

MachineLibrary shipped_machines() {
  return MachineLibrary(data_folder() / "machines", machine_file_settings());
}

LoadedProgram load_program(std::shared_ptr<const SourceText> source, Progress* progress,
                           const ReadOptions& options) {
  const StopWatch watch;
  LoadedProgram loaded;
  Program program;
  {
    ReadProgram read = read_program(std::move(source), progress, options);
    loaded.toolpath = std::make_shared<const Toolpath>(build_toolpath(read));
    program = std::move(read);  // without its blocks: a long program would take twice the memory
  }
  loaded.feed_controls = controls_of_feed_motions(*loaded.toolpath);
  loaded.chord_error = chord_error_of(*loaded.toolpath);
  loaded.largest_feed = largest_feed_of(*loaded.toolpath);
  const std::optional<Diagnostic> beyond = beyond_machines(*loaded.toolpath);
  loaded.refused = beyond || (program.cut_off && !options.simulate_cut_off);
  loaded.program = std::make_shared<const Program>(with_path_messages(std::move(program), loaded, beyond));
  loaded.read_time = watch.seconds();
  return loaded;
}

LoadedProgram load_program(const std::filesystem::path& file, Progress* progress,
                           const ReadOptions& options) {
  const StopWatch watch;
  LoadedProgram loaded =
      load_program(std::make_shared<const SourceText>(SourceText::from_file(file)), progress, options);
  loaded.read_time = watch.seconds();
  return loaded;
}

ReadOptions reading_on(ReadOptions options, const Machine& machine) {
  options.offsets.add_missing(machine.work_offsets);
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    options.rotary_axes += axis.name;
  }
  return options;
}

Setup make_setup(const SetupRequest& request) {
  Setup setup;
  setup.machine = shipped_machines().load(request.machine.empty() ? default_machine_of(request.dialect)
                                                                  : request.machine);
  setup.model = &find_model(request.model.empty() ? setup.machine.model : request.model);
  setup.settings = complete_settings(*setup.model, setup.machine);
  if (request.tolerance) {
    set_tolerance(setup, *request.tolerance);
  }
  for (const std::string& assignment : request.assignments) {
    apply_setting(assignment, *setup.model, setup.machine, setup.settings);
  }
  check_drives(setup.machine);
  if (!setup.machine.kinematics.empty()) {
    chain_of(setup.machine.kinematics);
  }
  return setup;
}

void set_tolerance(Setup& setup, double tolerance) {
  check_setting(tolerance_spec(), tolerance, "tolerance");
  if (setup.settings.has(contour_tolerance_key)) {
    for (auto& [key, value] : settings_for_tolerance(tolerance)) {
      setup.settings.set(key, value);
    }
  }
}

std::optional<double> contour_tolerance(const Setup& setup) {
  return setup.settings.has(contour_tolerance_key)
             ? std::optional(setup.settings.number(contour_tolerance_key))
             : std::nullopt;
}

std::optional<double> feed_override(const Setup& setup) {
  constexpr double as_programmed = 100;  // [%]
  if (!setup.settings.has(feed_override_key)) {
    return std::nullopt;
  }
  const double percent = setup.settings.number(feed_override_key);
  return percent == as_programmed ? std::nullopt : std::optional(percent);
}

Run simulate_motion(const LoadedProgram& input, Setup setup, Progress* progress) {
  if (input.refused) {
    throw_refused(*input.program);
  }
  const StopWatch watch;
  Run run;
  run.input = input;
  run.setup = std::move(setup);
  const ControlModel& model = *run.setup.model;
  ControlReading reading = model.read(input.toolpath, run.setup.settings, progress);
  const bool read_again = reading.path != input.toolpath;
  if (const auto beyond = read_again ? beyond_machines(*reading.path) : std::nullopt) {
    throw_beyond_machines(*input.program, *beyond);
  }
  run.lines_not_run = std::move(reading.refused);
  run.path = on_machine(std::move(reading.path), run.setup.machine, run.setup.settings, progress);
  std::optional<LoadModel> load = load_model(run, run.setup.load);
  run.trajectory = std::make_shared<const Trajectory>(
      model.simulate(run.path, run.setup.machine, run.setup.settings, progress));
  run.sources.limits_jerk = model.guarantees(run.setup.settings).limits_jerk;
  if (has_drives(run.setup.machine)) {
    run.sources.actual = std::make_shared<const ActualPath>(run.trajectory, run.setup.machine, progress);
  }
  run.sources.rotary = rotary_course_of(run.trajectory, run.setup.machine);
  set_load(run, std::move(load));
  run.simulate_time = watch.seconds();
  return run;
}

Run with_load(Run run, LoadSetup load, Progress* progress) {
  set_load(run, load_model(run, load));
  run.setup.load = std::move(load);
  run.summary.load.reset();
  if (run.sources.load) {
    run.summary.load = load_figures(*run.sources.load, progress);
  }
  return run;
}

void add_summary(Run& run, Progress* progress) {
  const StopWatch watch;
  run.summary =
      summarise(*run.trajectory, *run.path, axis_limit_vector(run.setup.machine, &AxisLimits::velocity),
                progress, run.sources.limits_jerk);
  if (run.sources.actual) {
    run.summary.actual = actual_figures(*run.sources.actual, progress);
  }
  if (run.sources.load) {
    run.summary.load = load_figures(*run.sources.load, progress);
  }
  if (run.sources.rotary) {
    run.summary.rotary = rotary_figures(run.sources.rotary, run.sources.limits_jerk, progress);
  }
  run.simulate_time += watch.seconds();
}

Run simulate_run(const LoadedProgram& input, Setup setup, Progress* progress) {
  constexpr double share_of_motion = 0.8;
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  Progress motion(whole, share_of_motion);
  Run run = simulate_motion(input, std::move(setup), &motion);
  Progress figures(whole, 1 - share_of_motion);
  add_summary(run, &figures);
  return run;
}

}  // namespace feedscope
