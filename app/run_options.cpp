#include "app/run_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "core/analysis/unfollowed.h"
#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {

namespace {

/// The radius stands behind the last "=".
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

/// Three numbers behind the "=".
void add_offset(WorkOffsets& offsets, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, std::min(equals, assignment.size()));
  const auto refuse = [&] {
    throw InputError(
        fmt::format("--offset '{}' is not OFFSET=X,Y,Z; write the offset as the program names it, and its "
                    "three coordinates in "
                    "mm with decimal points, such as --offset G55=100,0,0",
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
  std::size_t from = equals + 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? assignment.find(',', from) : assignment.size();
    if (comma == std::string::npos) {
      refuse();
    }
    const std::string part = assignment.substr(from, comma - from);
    if (part.find(',') != std::string::npos) {
      refuse();
    }
    zero[axis] = std::get<double>(parse_setting(number, part));
    from = comma + 1;
  }
  offsets.set(name, zero);
}

}  // namespace

SetupRequest RunOptions::request() const {
  SetupRequest request{machine, model, {}, set};
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

void add_program_options(CLI::App& command, ProgramOptions& values) {
  std::vector<std::string_view> dialects;
  for (const DialectInfo& info : all_dialects()) {
    dialects.push_back(info.id);
  }
  command.add_option("FILE", values.file, "NC program; - for standard input")->required();
  command
      .add_option("--dialect", values.dialect,
                  fmt::format("Language of the program: {} [recognised]", fmt::join(dialects, ", ")))
      ->type_name("ID");
  command.add_flag("--skip-deleted", values.skip_deleted, "Leave out blocks that begin with /");
  command
      .add_option("--repeat-limit", values.repeat_limit,
                  fmt::format("Lines that loops and calls may run [{}]", values.repeat_limit))
      ->type_name("N");
  command
      .add_option("--call-depth", values.call_depth,
                  fmt::format("Calls inside each other [{}]", values.call_depth))
      ->type_name("N");
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
          "Tool table with cutter radii: of LinuxCNC, Sinumerik, Fanuc (G10), Heidenhain (TOOL.T), or a "
          "list with headings [tool.tbl, TOOL.T, to.ini or tools.csv beside the program]")
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
                  "Unit of a tool table that does not name it: mm or inch [mm]")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  command.add_flag("--wear-only", values.wear_only,
                   "The path is already compensated: cutters have radius 0 unless --tool gives one");
  command.add_flag("--simulate-cut-off", values.simulate_cut_off,
                   "Simulate a program even if its loops or cycles were cut off at --repeat-limit");
}

void add_run_options(CLI::App& command, RunOptions& values) {
  add_program_options(command, values);
  command
      .add_option("--machine", values.machine,
                  fmt::format("Machine id or machine file [{}]", default_machine))
      ->type_name("ID|FILE");
  command.add_option("--model", values.model, "Control model [the machine's own]")->type_name("ID");
  command
      .add_option("--tolerance", values.tolerance,
                  "Contour tolerance in mm, instead of the program's own [or else the machine's]")
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

void note_replaced_tolerance(const Toolpath& toolpath) {
  if (const PathControl* own = find_own_tolerance(toolpath.path_controls)) {
    fmt::print(stderr, "feedscope: note: --tolerance replaces the program's own path control ({})\n",
               describe(*own));
  }
}

void note_unfollowed(const Toolpath& toolpath, const std::vector<Setup>& setups) {
  std::set<std::string> said;
  for (const Setup& setup : setups) {
    for (const std::string& sentence : unfollowed(toolpath, setup)) {
      std::string note = fmt::format("model '{}': {}", setup.model->info().id, sentence);
      if (said.insert(note).second) {
        fmt::print(stderr, "feedscope: note: {}\n", note);
      }
    }
  }
}

void note_unused_tolerance(const RunOptions& options, const Setup& setup) {
  if (!options.tolerance.empty() && !contour_tolerance(setup)) {
    fmt::print(stderr, "feedscope: note: model '{}' does not read a contour tolerance\n",
               setup.model->info().id);
  }
}

}  // namespace feedscope
