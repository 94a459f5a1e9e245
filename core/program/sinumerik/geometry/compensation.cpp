#include "core/program/sinumerik/geometry/compensation.h"

#include <fmt/format.h>

#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

void Compensation::set_tool_radius(Scanner& scanner) {
  require(scanner, '[');
  const double tool = values_.read(scanner);
  require(scanner, ',');
  const double edge = values_.read(scanner);
  require(scanner, ']');
  require(scanner, '=');
  const std::uint32_t column = scanner.column();
  const double radius = values_.read(scanner);
  if (!(radius >= 0)) {
    throw ReadFault{"tool-radius", column, message(NC_("core", "tool radius {} is negative"), radius),
                    NC_("core", "it is ignored; write a radius of zero or more")};
  }
  radii_.set(fmt::format("{},{}", tool, edge), to_mm(radius));
}

void Compensation::choose_tool(const std::string& name) {
  modes_.tool = name;
  modes_.edge = 1;
  machining_.tools.select(name);
}

void Compensation::run() {
  const Function* const word = functions_[Group::compensation];
  if (words_.has('T')) {
    choose_tool(fmt::format("{}", words_['T'].value));
  }
  if (words_.has('D')) {
    modes_.edge = words_['D'].value;
  }
  const std::uint32_t edge_column = words_.has('D') ? words_['D'].column : 0;
  if (word != nullptr) {
    modes_.side = word->action == Action::compensation_off ? nullptr : word;
  } else if (modes_.side == nullptr || !(functions_[Group::plane] != nullptr ||
                                         functions_[Group::corner] != nullptr || words_.has('D'))) {
    return;
  }
  if (modes_.side == nullptr || modes_.edge == 0) {
    path().end_compensation();
    return;
  }
  begin(word != nullptr ? functions_.compensation_column : edge_column);
}

void Compensation::begin(std::uint32_t column) {
  const std::string cutter = fmt::format("{},{}", modes_.tool, modes_.edge);
  const std::optional<double> radius = machining_.tools.use_radius_of(cutter, radii_.find(cutter));
  if (!radius) {
    report_radius(cutter, column);
    path().end_compensation();
    return;
  }
  const bool left = modes_.side->action == Action::compensation_left;
  path().set_compensation(left ? ToolSide::left : ToolSide::right, *radius,
                          {.corner = modes_.corner_meeting ? OutsideCorner::meeting : OutsideCorner::arc},
                          modal_.plane, column);
}

void Compensation::report_radius(const std::string& cutter, std::uint32_t column) const {
  report(Severity::error, "tool-radius", 0, column, [&] {
    const std::string_view side = modes_.side->name;
    return Text{
        modes_.tool.empty()
            ? message(NC_("core", "{} without a tool: its radius is not known"), side)
            : message(NC_("core", "{}: the radius of T{} D{} is not known"), side, modes_.tool, modes_.edge),
        message(NC_("core", "the path shown is the programmed contour; {}, or set it with $TC_DP6[T,D]="),
                ToolRack::radius_hint(cutter))};
  });
}

}  // namespace feedscope::sinumerik
