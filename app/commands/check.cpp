#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/asked_program.h"
#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/watch.h"
#include "core/analysis/notes/not_counted.h"
#include "core/analysis/run/program_facts.h"
#include "core/base/units.h"
#include "core/export/export.h"
#include "core/toolpath/machine_path.h"

namespace feedscope {
namespace {

struct CheckOptions : ProgramOptions {
  std::string json;
  std::string machine;  ///< id or file; "": none
};

struct CheckedProgram {
  LoadedProgram loaded;
  MachinePath path;
};

/// Reads the program for the machine, if one is given: its rotary axes turn, and the path includes the moves
/// that its positions add.
CheckedProgram load(const CheckOptions& options, const AskedProgram& asked, Progress* progress) {
  if (options.machine.empty()) {
    LoadedProgram loaded = load_program(asked.source, progress, asked.reading);
    return {loaded, {loaded.toolpath, {}}};
  }
  SetupRequest request;
  request.machine = options.machine;
  const Setup setup = make_setup(request);
  LoadedProgram loaded = load_program(asked.source, progress, reading_on(asked.reading, setup.machine));
  return {loaded, on_machine(loaded.toolpath, setup.machine, setup.settings, progress)};
}

/// Rounds a zero of either sign to 0.
double shown(double value) {
  constexpr double least = 5e-5;  // smaller values show as zero in four decimals [mm]
  return std::abs(value) < least ? 0 : value;
}

std::string range_text(const Bounds& bounds, Eigen::Index axis) {
  const bool programmed = std::isfinite(bounds.min[axis]) && std::isfinite(bounds.max[axis]);
  return programmed ? fmt::format("{:.4f} to {:.4f} mm", shown(bounds.min[axis]), shown(bounds.max[axis]))
                    : "not programmed";
}

std::string extent_text(const ProgramFacts& facts, Eigen::Index axis) {
  return fmt::format("{}; cutting {}; rapid {}", range_text(facts.bounds, axis),
                     range_text(facts.cutting_bounds, axis), range_text(facts.rapid_bounds, axis));
}

std::string tools_text(const Program& program) {
  std::vector<std::string> names;
  for (const ToolChange& tool : program.tools) {
    names.push_back(fmt::format("{} (line {})", tool.name, tool.line));
  }
  return names.empty() ? "none programmed" : fmt::format("{}", fmt::join(names, ", "));
}

std::string cutters_text(const Program& program) {
  std::vector<std::string> texts;
  for (const CutterUse& use : program.cutters) {
    const std::string radius = use.source == CutterSource::unknown
                                   ? std::string("radius not known")
                                   : fmt::format("radius {:.6g} mm ({})", use.radius, to_string(use.source));
    texts.push_back(fmt::format("{} (line {}): {}", use.tool, use.line, radius));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string offsets_text(const Program& program) {
  std::vector<std::string> texts;
  for (const OffsetUse& use : program.work_offsets) {
    texts.push_back(fmt::format("{} (line {}): {} motion{}{}", use.name, use.line, use.blocks,
                                use.blocks == 1 ? "" : "s", use.given ? "" : ", assumed as zero"));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string facts_text(const Program& program, const ProgramFacts& facts) {
  TextTable table;
  table.add({"dialect", std::string(info_of(program.dialect).title)});
  table.add({"unit", describe(program.unit).english()});
  table.add({"lines", fmt::format("{}; {} blocks run", facts.lines, facts.blocks)});
  table.add({"segments", fmt::format("{}: {} lines, {} arcs, {} dwells", facts.segments,
                                     facts.segments - facts.arcs - facts.dwells, facts.arcs, facts.dwells)});
  for (std::size_t i = 0; i < coordinate_names.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    table.add({fmt::format("{} range", coordinate_names[i]), extent_text(facts, axis)});
  }
  table.add({"path length",
             fmt::format("{:.3f} mm, {:.3f} mm of it rapid", facts.path_length, facts.rapid_length)});
  if (facts.segments > 0) {
    table.add({"start", "X0 Y0 Z0, assumed; not in the ranges if the first move is a rapid"});
  }
  if (facts.dwells > 0) {
    table.add({"dwell time", time_text(facts.dwell_time)});
  }
  table.add({"feeds", facts.largest_feed > 0
                          ? fmt::format("{:.6g} to {:.6g} mm/min", units::to_mm_min(facts.min_feed),
                                        units::to_mm_min(facts.largest_feed))
                          : "none programmed"});
  if (facts.chord_error) {
    table.add({"chord error", fmt::format("about {:.2g} mm, estimated from {} short lines",
                                          facts.chord_error->value, facts.chord_error->chords)});
  }
  table.add({"tools", tools_text(program)});
  if (!program.cutters.empty()) {
    table.add({"cutters", cutters_text(program)});
  }
  if (!program.work_offsets.empty()) {
    table.add({"work offsets", offsets_text(program)});
  }
  if (const std::string events = describe(facts.not_counted).english(); !events.empty()) {
    table.add({"not in the cycle time", events});
  }
  table.add({"calls", fmt::format("{}", program.call_count)});
  std::string label = "path control";
  std::vector<PathControlRange> ranges = facts.path_control;
  std::ranges::stable_sort(ranges, {}, &PathControlRange::first_line);
  for (const PathControlRange& range : ranges) {
    const std::string lines = range.first_line == range.last_line
                                  ? fmt::format("line {}", range.first_line)
                                  : fmt::format("lines {} to {}", range.first_line, range.last_line);
    table.add({std::exchange(label, ""), fmt::format("{}: {}", lines, describe(range.control).english())});
  }
  return table.text("ll");
}

int check(const CheckOptions& options) {
  const AskedProgram asked = asked_program(options);
  for (const std::string& input : {options.file, asked.file}) {
    check_outputs(input, {options.json});
  }
  CheckedProgram checked;
  {
    Watch watch;
    checked = load(options, asked, watch.stage("reading"));
  }
  const auto& [loaded, path] = checked;
  const ProgramFacts facts = facts_of(*loaded.program, *path);
  note_unused_reading(*loaded.program, asked.reading);
  print_diagnostics(*loaded.program, DiagnosticStyle::with_source);
  print_diagnostics(path.faults, *loaded.program);
  if (!options.json.empty()) {
    OutputFile json(options.json);
    json.stream() << check_json(loaded, path);
    json.commit();
  }
  if (options.json != "-") {
    fmt::print("{}\n{}", asked.source->name(), facts_text(*loaded.program, facts));
  }
  return has_errors(loaded.program->diagnostics) || has_errors(path.faults) ? exit_code::program_errors
                                                                            : exit_code::done;
}

}  // namespace

Command add_check_command(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Read an NC program and report its contents and errors");
  add_program_options(*command, *options);
  command
      ->add_option("--machine", options->machine,
                   "Also what this machine cannot do: ID or FILE; its rotary axes are read")
      ->type_name("ID|FILE");
  command->add_option("--json", options->json, "Write facts and messages; - for standard output")
      ->type_name("FILE");
  return {command, [options] { return check(*options); }};
}

}  // namespace feedscope
