// The part of SinumerikReader that switches cutter radius compensation: G40, G41, G42, G450, G451.
#include <fmt/format.h>

#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

/// "$TC_DP6[tool, edge]=radius", whose name has just been read.
void SinumerikReader::set_tool_radius(Scanner& scanner) {
  require(scanner, '[');
  const double tool = values_.read(scanner);
  require(scanner, ',');
  const double edge = values_.read(scanner);
  require(scanner, ']');
  require(scanner, '=');
  const std::uint32_t column = scanner.column();
  const double radius = values_.read(scanner);
  if (!(radius >= 0)) {
    throw ReadFault{"tool-radius", column, fmt::format("a tool radius of {} is negative", radius),
                    "it is not taken; write a radius of zero or more"};
  }
  tool_radii_.set(fmt::format("{},{}", tool, edge), to_mm(radius));
}

/// T, D, plane and the G words of this block.
void SinumerikReader::apply_compensation() {
  const Function* const word = groups_[static_cast<std::size_t>(Group::compensation)];
  const bool other_plane = groups_[static_cast<std::size_t>(Group::plane)] != nullptr;
  const bool other_corner = groups_[static_cast<std::size_t>(Group::corner)] != nullptr;
  if (words_.has('T')) {
    choose_tool(fmt::format("{}", words_['T'].value));
  }
  if (words_.has('D')) {
    modal_.edge = words_['D'].value;
  }
  if (word == nullptr) {
    compensation_column_ = words_.has('D') ? words_['D'].column : 0;
  }
  if (word != nullptr) {
    modal_.compensation = word->action == Action::compensation_off ? nullptr : word;
  } else if (modal_.compensation == nullptr || !(other_plane || other_corner || words_.has('D'))) {
    return;
  }
  if (modal_.compensation == nullptr || modal_.edge == 0) {
    path().end_compensation();
    return;
  }
  const std::string cutter = fmt::format("{},{}", modal_.tool, modal_.edge);
  const std::optional<double> radius = use_cutter(cutter, tool_radii_.find(cutter));
  if (!radius) {
    report_tool_radius(cutter);
    path().end_compensation();
    return;
  }
  const bool left = modal_.compensation->action == Action::compensation_left;
  path().set_compensation(left ? ToolSide::left : ToolSide::right, *radius,
                          modal_.corner_lines ? OutsideCorner::lines : OutsideCorner::arc, modal_.plane,
                          compensation_column_);
}

void SinumerikReader::choose_tool(const std::string& name) {
  modal_.tool = name;
  modal_.edge = 1;
  select_tool(name);
}

void SinumerikReader::report_tool_radius(const std::string& cutter) {
  report(Severity::error, "tool-radius", 0, compensation_column_, [&] {
    const std::string tool = modal_.tool.empty() ? std::string("the tool, which no T names,")
                                                 : fmt::format("T{} D{}", modal_.tool, modal_.edge);
    return Text{fmt::format("{}: the radius of {} is not known", modal_.compensation->name, tool),
                fmt::format("the path shown is the programmed contour; {}, or set it with $TC_DP6[T,D]=",
                            radius_hint(cutter))};
  });
}

}  // namespace feedscope
