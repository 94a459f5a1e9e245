#include "core/program/tools/tool_rack.h"

#include <algorithm>

namespace feedscope {
namespace {

constexpr std::string_view no_tool = "0";

}  // namespace

ToolRack::ToolRack(const ReadOptions& options, SubprogramFiles& files, Program& program, PathWriter& path,
                   const LineRunner& lines, DiagnosticLog& log)
    : program_(program), path_(path), lines_(lines), log_(log), cutters_(options, files) {}

std::int32_t ToolRack::index_of(std::string_view name) const {
  const auto found = std::find_if(program_.tools.begin(), program_.tools.end(),
                                  [&](const ToolChange& tool) { return tool.name == name; });
  return found == program_.tools.end() ? -1 : static_cast<std::int32_t>(found - program_.tools.begin());
}

void ToolRack::select(std::string_view name) {
  if (index_of(name) < 0) {
    program_.tools.push_back({std::string(name), lines_.shown_line()});
  }
}

void ToolRack::change_to(std::string_view name) {
  if (in_spindle_ != name) {
    in_spindle_ = name;
    if (name != no_tool && !name.empty()) {
      select(name);
    }
    path_.spindle().set_tool(index_of(name));
    spindle_turns_ = false;
    path_.spindle().set_stands(spindle_commanded_);
    path_.pause(Pause::tool_change);
  }
}

void ToolRack::start_spindle() {
  spindle_commanded_ = true;
  path_.spindle().set_stands(false);
  if (!spindle_turns_) {
    spindle_turns_ = true;
    path_.pause(Pause::spindle_start);
  }
}

void ToolRack::stop_spindle() {
  spindle_turns_ = false;
  spindle_commanded_ = true;
  path_.spindle().set_stands(true);
}

std::optional<double> ToolRack::radius_of(std::string_view tool, std::optional<double> programmed) {
  const Cutters::Found found = cutters_.find(tool, programmed);
  return found.source == CutterSource::unknown ? std::nullopt : std::optional(found.radius);
}

std::optional<double> ToolRack::use_radius_of(std::string_view tool, std::optional<double> programmed) {
  const Cutters::Found found = cutters_.find(tool, programmed);
  const std::string key = CutterRadii::key(tool);
  const auto known = std::find_if(program_.cutters.begin(), program_.cutters.end(),
                                  [&](const CutterUse& use) { return use.tool == key; });
  if (known == program_.cutters.end()) {
    program_.cutters.push_back({key, found.radius, lines_.shown_line(), found.source});
  } else {
    known->radius = found.radius;
    known->source = found.source;
  }
  if (!cutters_.table_fault().empty()) {
    log_.add(Severity::warning, "tool-table", 0, lines_.place(0), [&] {
      return DiagnosticLog::Text{
          cutters_.table_fault(),
          NC_("core", "the table in the program's folder is not used; correct it, or name another one")};
    });
  } else if (found.source == CutterSource::table) {
    log_.add(Severity::info, "tool-table", 1, lines_.place(0), [&] {
      return DiagnosticLog::Text{
          message(NC_("core", "cutter radii are those of tool table '{}'"), cutters_.table_name()), {}};
    });
  }
  return found.source == CutterSource::unknown ? std::nullopt : std::optional(found.radius);
}

Message ToolRack::radius_hint(std::string_view tool) {
  return message(NC_("core",
                     "give it as an import option (--tool {}=RADIUS) or in a tool table, or say that the "
                     "path is already compensated (--wear-only)"),
                 CutterRadii::key(tool));
}

}  // namespace feedscope
