#include "core/load/load_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_name.h"

namespace feedscope {
namespace {

void check_tool(const Engagement& operation, const std::vector<std::string>& used) {
  if (operation.tool.empty() || std::find(used.begin(), used.end(), operation.tool) != used.end()) {
    return;
  }
  if (used.empty()) {
    throw InputError(message(NC_("core",
                                 "the load file has an operation for tool {}, but the program changes to no "
                                 "tool; omit 'tool', so that the operation applies to all motions"),
                             operation.tool));
  }
  const std::string nearest = nearest_name(operation.tool, used);
  throw InputError(message(
      NC_("core", "the load file has an operation for tool {}, which the program never changes to; {}"),
      operation.tool,
      nearest.empty() ? message(NC_("core", "its tools are {}"), fmt::to_string(fmt::join(used, ", ")))
                      : message(NC_("core", "did you mean tool {}?"), nearest)));
}

void check_lines(const Engagement& operation, std::uint32_t line_count) {
  for (const ProgramLines& range : operation.lines) {
    if (range.last > line_count) {
      throw InputError(message(NC_("core",
                                   "the load file has an operation for lines {}-{}, but the program has {} "
                                   "lines; correct the range"),
                               range.first, range.last, line_count));
    }
  }
}

}  // namespace

LoadModel::LoadModel(LoadSetup setup, const Program& program, const Toolpath& toolpath)
    : setup_(std::move(setup)), spindles_(toolpath.spindles) {
  if (const Message problem = overlap_problem(setup_.operations); !problem.empty()) {
    throw InputError(problem);
  }
  std::vector<std::string> used;
  for (const SpindleState& spindle : spindles_) {
    if (spindle.tool >= 0) {
      used.push_back(CutterRadii::key(program.tools[static_cast<std::size_t>(spindle.tool)].name));
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const Engagement& operation : setup_.operations) {
    check_tool(operation, used);
    check_lines(operation, program.source->line_count());
    if (const Message problem = operation_problem(operation); !problem.empty()) {
      throw InputError(message(NC_("core", "operation of {}: {}"), describe(operation), problem));
    }
    Material material = find_material(operation.material, setup_.materials);
    operations_.push_back({operation, material, CuttingForce(operation, material)});
  }
  by_tool_.resize(program.tools.size() + 1);
  for (std::size_t tool = 0; tool < by_tool_.size(); ++tool) {
    ByTool& found = by_tool_[tool];
    const std::string name = tool == 0 ? "" : CutterRadii::key(program.tools[tool - 1].name);
    for (std::size_t i = 0; i < setup_.operations.size(); ++i) {
      const Engagement& operation = setup_.operations[i];
      const bool of_tool = !operation.tool.empty() && operation.tool == name;
      if (!of_tool && !operation.tool.empty()) {
        continue;
      }
      for (const ProgramLines& range : operation.lines) {
        found.ranges.push_back({range, static_cast<int>(i)});
      }
      if (operation.lines.empty() && (of_tool || found.elsewhere < 0)) {
        found.elsewhere = static_cast<int>(i);
      }
    }
    std::sort(found.ranges.begin(), found.ranges.end(),
              [](const Range& a, const Range& b) { return a.lines.first < b.lines.first; });
  }
}

int LoadModel::operation_of(std::uint16_t spindle, std::uint32_t line) const {
  const ByTool& found = by_tool_[static_cast<std::size_t>(spindles_[spindle].tool + 1)];
  const auto behind =
      std::upper_bound(found.ranges.begin(), found.ranges.end(), line,
                       [](std::uint32_t wanted, const Range& range) { return wanted < range.lines.first; });
  if (behind != found.ranges.begin() && line <= std::prev(behind)->lines.last) {
    return std::prev(behind)->operation;
  }
  return found.elsewhere;
}

double LoadModel::speed_of(int operation, std::uint16_t spindle) const {
  const SpindleState& state = spindles_[spindle];
  if (state.turning != SpindleState::Turning::as_said) {
    return 0;
  }
  const auto& own = setup_.operations[static_cast<std::size_t>(operation)].spindle_speed;
  return state.speed > 0 ? state.speed : own.value_or(0);
}

}  // namespace feedscope
