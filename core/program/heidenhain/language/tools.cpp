#include "core/program/heidenhain/language/tools.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace feedscope::heidenhain {

std::optional<std::string> Tools::read_name(Scanner& scanner) const {
  const char first = letters::to_upper(scanner.peek());
  const bool is_text = first == '"' || (first == 'Q' && letters::to_upper(scanner.peek_at(1)) == 'S');
  if (is_text) {
    return labels_.read(scanner);
  }
  if (letters::is_digit(first) || first == 'Q') {
    return fmt::format("{}", read_value(scanner));
  }
  return std::nullopt;
}

void Tools::call(const ToolCall& call) {
  contour_.flush();
  if (call.tool) {
    modal_.tool = *call.tool;
    machining_.tools.select(modal_.tool);
    path().begin_line(lines().shown_line(), context_.statement.place(0));
    machining_.tools.change_to(modal_.tool);
    modal_.tool_radius = radius_of(modal_.tool);
    if (modal_.tool_radius) {
      *modal_.tool_radius += call.radius_excess;
    }
  }
  if (call.plane) {
    contour_.set_plane(*call.plane);
    modal_.pole_plane = *call.plane;
  }
  if (call.speed) {
    modal_.spindle_speed = *call.speed;
    path().set_spindle_speed(modal_.spindle_speed / 60);
  }
  if (call.feed && *call.feed != 0) {
    feeds_.apply_tool_call(call.feed_word, *call.feed, call.feed_column);
  }
}

void Tools::select_side(const MotionWords& words) {
  switch (words.side) {
    case SideWord::none:
      return;
    case SideWord::off:
      modal_.side = 0;
      return;
    case SideWord::left:
      modal_.side = 1;
      break;
    case SideWord::right:
      modal_.side = -1;
      break;
  }
  if (!machining_.tools.use_radius_of(modal_.tool, defined_radii_.find(modal_.tool))) {
    report(Severity::error, "tool-radius", 0, words.side_column, [&] {
      return Text{
          message(NC_("core", "{}: the radius of the tool is not known"),
                  std::string_view(modal_.side > 0 ? "RL" : "RR")),
          message(NC_("core",
                      "the path shown is the programmed contour; {}, or write a TOOL DEF with R before the "
                      "tool call"),
                  ToolRack::radius_hint(modal_.tool))};
    });
  }
}

void Tools::run_spindle(int m, std::uint32_t column) {
  switch (m) {
    case 3:
    case 4:
    case 13:
    case 14:
      if (!machining_.tools.spindle_turns()) {
        end_contour(column);
        machining_.tools.start_spindle();
      }
      break;
    case 5:
    case 19:
      machining_.tools.stop_spindle();
      break;
    default:
      break;
  }
}

std::optional<double> Tools::number() const {
  double number = 0;
  const auto [end, status] =
      std::from_chars(modal_.tool.data(), modal_.tool.data() + modal_.tool.size(), number);
  return status == std::errc() && end == modal_.tool.data() + modal_.tool.size() ? std::optional(number)
                                                                                 : std::nullopt;
}

std::optional<double> Tools::radius_of(const std::string& tool) const {
  return machining_.tools.radius_of(tool, defined_radii_.find(tool));
}

}  // namespace feedscope::heidenhain
