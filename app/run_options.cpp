#include "app/run_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "app/number_option.h"
#include "core/analysis/run/control_dialect.h"
#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {

namespace {

/// Largest whole number up to which a double is exact.
constexpr double largest_count = 9007199254740992;

/// Reads TOOL=RADIUS; the radius follows the last "=".
void add_radius(CutterRadii& radii, const std::string& assignment) {
  const std::size_t equals = assignment.rfind('=');
  if (equals == std::string::npos || CutterRadii::key(assignment.substr(0, equals)).empty()) {
    throw InputError(fmt::format(
        "--tool '{}' is not TOOL=RADIUS; write the tool as the program names it, and its radius in mm, "
        "such as --tool 1=5",
        assignment));
  }
  radii.set(assignment.substr(0, equals), parse_length(assignment.substr(equals + 1), "--tool"));
}

/// Reads three numbers after the "=", separated by commas, or by semicolons, which permit decimal commas.
void add_offset(WorkOffsets& offsets, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, std::min(equals, assignment.size()));
  const auto refuse = [&] {
    throw InputError(
        fmt::format("--offset '{}' is not OFFSET=X,Y,Z; write the offset as the program names it, and its "
                    "three coordinates in mm, such as --offset G55=100.5,0,0, or with decimal commas "
                    "--offset 'G55=100,5;0;0'",
                    assignment));
  };
  if (equals == std::string::npos || WorkOffsets::key(name).empty()) {
    refuse();
  }
  SettingSpec number;
  number.key = "--offset";
  number.unit = "mm";
  number.minimum = -1e6;
  number.maximum = 1e6;
  Vec3 zero;
  const char separator = assignment.find(';') != std::string::npos ? ';' : ',';
  std::size_t from = equals + 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? assignment.find(separator, from) : assignment.size();
    if (end == std::string::npos) {
      refuse();
    }
    const std::string part = assignment.substr(from, end - from);
    if (part.find(separator) != std::string::npos) {
      refuse();
    }
    zero[axis] = std::get<double>(parse_setting(number, part));
    from = end + 1;
  }
  offsets.set(name, zero);
}

}  // namespace

void move_tolerance(std::vector<std::string>& set, std::vector<std::string>& tolerances) {
  const std::size_t given = tolerances.size();
  for (const std::string& assignment : set) {
    const std::string key = assigned_key(assignment);
    if (key != "tolerance" && key != "contour_tolerance_mm") {
      continue;
    }
    if (given > 0) {
      throw InputError(fmt::format("--tolerance {} and --set {} both set the tolerance; omit one",
                                   tolerances.front(), assignment));
    }
    if (key == "tolerance") {
      tolerances.push_back(assignment.substr(key.size() + 1));
    }
  }
  if (tolerances.size() > given + 1) {
    throw InputError(fmt::format("--set tolerance={} and --set tolerance={} both set the tolerance; omit one",
                                 tolerances[given], tolerances[given + 1]));
  }
  std::erase_if(set, [](const std::string& assignment) { return assigned_key(assignment) == "tolerance"; });
}

void move_tolerance(RunOptions& options) {
  std::vector<std::string> tolerances;
  if (!options.tolerance.empty()) {
    tolerances.push_back(options.tolerance);
  }
  move_tolerance(options.set, tolerances);
  options.tolerance = tolerances.empty() ? "" : tolerances.front();
}

std::vector<GivenOption> given_of(const ProgramOptions& options) {
  const ProgramOptions usual;
  return {{"--dialect", !options.dialect.empty()},
          {"--unit", !options.unit.empty()},
          {"--skip-deleted", options.skip_deleted},
          {"--repeat-limit", options.repeat_limit != usual.repeat_limit},
          {"--call-depth", options.call_depth != usual.call_depth},
          {"--tool", !options.radii.empty()},
          {"--tools", !options.tool_table.empty()},
          {"--tools-unit", options.table_unit != usual.table_unit},
          {"--offset", !options.offsets.empty()},
          {"--wear-only", options.wear_only},
          {"--simulate-cut-off", options.simulate_cut_off}};
}

std::vector<GivenOption> given_of_run(const RunOptions& options) {
  return {{"--machine", !options.machine.empty()},
          {"--model", !options.model.empty()},
          {"--tolerance", !options.tolerance.empty()},
          {"--set", !options.set.empty()}};
}

Dialect dialect_of(const ProgramOptions& options, const SourceText& source) {
  return options.dialect.empty() ? recognise(source) : dialect_of_id(options.dialect);
}

SetupRequest RunOptions::request(Dialect program_dialect) const {
  SetupRequest request{machine, model, {}, set, program_dialect};
  if (!tolerance.empty()) {
    request.tolerance = parse_tolerance(tolerance);
  }
  return request;
}

double parse_length(const std::string& text, const std::string& option) {
  SettingSpec number;
  number.key = option;
  number.unit = "mm";
  return std::get<double>(parse_setting(number, text));
}

double parse_tolerance(const std::string& text) {
  return parse_length(text, "--tolerance");
}

ReadOptions ProgramOptions::reading() const {
  ReadOptions options;
  if (!dialect.empty()) {
    options.dialect = dialect_of_id(dialect);
  }
  if (!unit.empty()) {
    options.unit = unit == "inch" ? LengthUnit::inch : LengthUnit::mm;
  }
  options.skip_deleted_blocks = skip_deleted;
  options.repeat_limit = repeat_limit;
  options.call_depth = call_depth;
  for (const std::string& assignment : radii) {
    add_radius(options.radii, assignment);
  }
  for (const std::string& assignment : offsets) {
    add_offset(options.offsets, assignment);
  }
  options.tool_table = tool_table;
  options.table_unit = table_unit == "inch" ? units::from_inch(1) : 1;
  options.wear_only = wear_only;
  options.simulate_cut_off = simulate_cut_off;
  return options;
}

ProgramOptions ProgramOptions::of(const std::string& file, const ReadOptions& reading) {
  ProgramOptions options;
  options.file = file;
  options.dialect = reading.dialect ? std::string(info_of(*reading.dialect).id) : "";
  options.unit = reading.unit ? std::string(to_string(*reading.unit)) : "";
  options.skip_deleted = reading.skip_deleted_blocks;
  options.repeat_limit = reading.repeat_limit;
  options.call_depth = reading.call_depth;
  for (const auto& [tool, radius] : reading.radii.all()) {
    options.radii.push_back(fmt::format("{}={}", tool, radius));
  }
  for (const auto& [name, zero] : reading.offsets.all()) {
    options.offsets.push_back(fmt::format("{}={},{},{}", name, zero.x(), zero.y(), zero.z()));
  }
  options.tool_table = reading.tool_table.string();
  options.table_unit = reading.table_unit == 1 ? "mm" : "inch";
  options.wear_only = reading.wear_only;
  options.simulate_cut_off = reading.simulate_cut_off;
  return options;
}

std::string machine_help() {
  return fmt::format("Machine id or machine file [{}; {} for Heidenhain programs]", default_machine,
                     default_machine_of(Dialect::heidenhain));
}

CLI::Option* add_program_options(CLI::App& command, ProgramOptions& values, const std::string& name) {
  std::vector<std::string_view> dialects;
  for (const DialectInfo& info : all_dialects()) {
    dialects.push_back(info.id);
  }
  CLI::Option* file =
      command.add_option(name, values.file, "NC program, or a session (.feedscope); - for standard input")
          ->required();
  command
      .add_option("--dialect", values.dialect,
                  fmt::format("Dialect of the program: {} [auto-detected]", fmt::join(dialects, ", ")))
      ->type_name("ID");
  command
      .add_option(
          "--unit", values.unit,
          "Unit of lengths and feeds until the program sets one (G20, G71, BEGIN PGM n MM): mm or inch "
          "[mm, with a warning]")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  command.add_flag("--skip-deleted", values.skip_deleted, "Skip blocks that begin with /");
  add_number_option(
      command, "--repeat-limit", whole_numbers(0, largest_count),
      [&values](double count) { values.repeat_limit = static_cast<std::uint64_t>(count); },
      fmt::format("Maximum lines executed by loops and calls [{}]", values.repeat_limit))
      ->type_name("N");
  add_number_option(
      command, "--call-depth", whole_numbers(0, largest_count),
      [&values](double count) { values.call_depth = static_cast<std::size_t>(count); },
      fmt::format("Maximum call depth [{}]", values.call_depth))
      ->type_name("N");
  state_number_rule(command);
  command
      .add_option(
          "--tool", values.radii,
          "Cutter radius in mm of a tool as the program names it (D of Fanuc, T,D of Sinumerik); repeat for "
          "more")
      ->type_name("TOOL=MM")
      ->allow_extra_args(false);
  command
      .add_option(
          "--tools", values.tool_table,
          "Tool table with cutter radii: LinuxCNC, Sinumerik, Fanuc (G10) or Heidenhain (TOOL.T) format, or "
          "a list with headings [tool.tbl, TOOL.T, to.ini or tools.csv in the folder of the program]")
      ->type_name("FILE");
  command
      .add_option(
          "--offset", values.offsets,
          "Zero point in mm of a work offset as the program names it (G55, G54.1P3, G505); repeat for "
          "more [0,0,0]")
      ->type_name("OFFSET=X,Y,Z")
      ->allow_extra_args(false);
  command
      .add_option("--tools-unit", values.table_unit,
                  "Unit of a tool table that does not state it: mm or inch [mm]")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  command.add_flag("--wear-only", values.wear_only,
                   "The path is already compensated: cutters have radius 0 except those of --tool");
  command.add_flag("--simulate-cut-off", values.simulate_cut_off,
                   "Simulate a program even if its loops or cycles were cut off at --repeat-limit");
  return file;
}

CLI::Option* add_run_options(CLI::App& command, RunOptions& values, const std::string& name) {
  CLI::Option* file = add_program_options(command, values, name);
  command.add_option("--machine", values.machine, machine_help())->type_name("ID|FILE");
  command.add_option("--model", values.model, "Control model [the machine's own]")->type_name("ID");
  command
      .add_option("--tolerance", values.tolerance,
                  "Contour tolerance in mm, instead of the program's own [otherwise the machine's]")
      ->type_name("MM");
  add_set_option(command, values.set);
  return file;
}

void add_load_option(CLI::App& command, std::string& file) {
  command
      .add_option("--load", file,
                  "Load file (TOML) that says how the tools are engaged: adds chip thickness, cutting force, "
                  "torque and power at the predicted and the programmed feed to all results")
      ->type_name("FILE");
}

LoadSetup asked_load(const std::string& file, LoadSetup otherwise) {
  return file.empty() ? std::move(otherwise) : read_load_file(file);
}

void add_set_option(CLI::App& command, std::vector<std::string>& assignments) {
  command
      .add_option(
          "--set", assignments,
          "Change a setting of the model (alpha=2) or a limit of an axis (X.jerk=20); repeat for more")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void note_replaced_tolerance(const Toolpath& toolpath, const std::vector<Setup>& setups) {
  const bool used =
      std::ranges::any_of(setups, [](const Setup& setup) { return contour_tolerance(setup).has_value(); });
  if (const PathControl* own = find_own_tolerance(toolpath.path_controls); used && own != nullptr) {
    fmt::print(stderr, "feedscope: note: --tolerance replaces the program's own path control ({})\n",
               describe(*own).english());
  }
}

void note_unused_reading(const Program& program, const ReadOptions& asked) {
  const auto note = [](const std::string& given, const std::vector<std::string>& used, const char* none) {
    fmt::print(stderr, "feedscope: note: {} is not used; {}\n", given,
               used.empty() ? none : fmt::format("the program uses: {}", fmt::join(used, ", ")));
  };
  std::vector<std::string> offsets;
  for (const OffsetUse& use : program.work_offsets) {
    offsets.push_back(use.name);
  }
  for (const auto& [name, zero] : asked.offsets.all()) {
    if (std::ranges::find(offsets, name) == offsets.end()) {
      note(fmt::format("work offset '{}'", name), offsets, "the program uses no work offset");
    }
  }
  std::vector<std::string> tools;
  for (const CutterUse& use : program.cutters) {
    tools.push_back(CutterRadii::key(use.tool));
  }
  for (const auto& [tool, radius] : asked.radii.all()) {
    if (std::ranges::find(tools, tool) == tools.end()) {
      note(fmt::format("the cutter radius of tool '{}'", tool), tools,
           "the program uses no cutter radius compensation");
    }
  }
}

void note_unused_tolerances(const std::vector<std::string>& tolerances, const std::vector<Setup>& setups) {
  std::set<std::string> said;
  for (const Setup& setup : setups) {
    const std::string& model = setup.model->info().id;
    if (!tolerances.empty() && !contour_tolerance(setup) && said.insert(model).second) {
      fmt::print(stderr, "feedscope: note: model '{}' does not use a contour tolerance\n", model);
    }
  }
}

}  // namespace feedscope
