#include "core/program/sinumerik/language/frame_variables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/program/sinumerik/language/names.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

namespace {

constexpr double frame_count = 100;

constexpr auto constructors =
    std::to_array<std::pair<std::string_view, FrameValue::Part>>({{"CTRANS", FrameValue::Part::shift},
                                                                  {"CFINE", FrameValue::Part::fine_shift},
                                                                  {"CROT", FrameValue::Part::angle},
                                                                  {"CSCALE", FrameValue::Part::scale},
                                                                  {"CMIRROR", FrameValue::Part::mirror}});

[[noreturn]] void throw_frame(std::uint32_t column, Message what) {
  throw ReadFault{"frame-value", column, std::move(what),
                  NC_("core",
                      "the frame does not change; write CTRANS, CROT, CSCALE, CMIRROR with axes and values, "
                      "joined by \":\", or a variable that holds a frame")};
}

}  // namespace

bool FrameVariables::run_system_variable(Scanner& scanner, std::string_view name) {
  if (name == "P_UIFR") {
    require(scanner, '[');
    const int number = index(scanner);
    FrameValue value = coordinates_.settable(number);
    assign(scanner, value, scanner.take(','));
    coordinates_.set_settable(number, value);
    return true;
  }
  if (name == "P_IFRAME") {
    FrameValue value = coordinates_.settable_in_force();
    assign(scanner, value, scanner.take('['));
    coordinates_.set_settable_in_force(value);
    return true;
  }
  if (name != "P_PFRAME") {
    return false;
  }
  splines_.finish();
  if (scanner.take('[')) {
    set_programmed_part(scanner);
  } else {
    FrameValue value;
    assign(scanner, value, false);
    coordinates_.set_programmed(value.frame());
  }
  return true;
}

/// Reads the number of a settable frame.
int FrameVariables::index(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const double number = std::floor(values_.read(scanner) + 0.5);
  if (!(number >= 0 && number < frame_count)) {
    throw ReadFault{"array-index", column,
                    message(NC_("core", "{} is not a settable frame from 0 to {}"), number, frame_count - 1),
                    NC_("core", "correct the number")};
  }
  return static_cast<int>(number);
}

/// Reads the rest after the name or its "[": a part, as "X,TR]=5", or the whole, as "]=CTRANS(X,5)".
void FrameVariables::assign(Scanner& scanner, FrameValue& value, bool one_part) {
  if (!one_part) {
    scanner.take(']');
    require(scanner, '=');
    value = read(scanner);
    return;
  }
  const std::uint32_t column = scanner.column();
  const std::string_view axis = scanner.name();
  require(scanner, ',');
  const std::string_view name = scanner.name();
  const std::optional<FrameValue::Part> part = FrameValue::part(name);
  require(scanner, ']');
  require(scanner, '=');
  const double number = values_.read_bounded(scanner);
  if (!part) {
    throw_frame(column,
                message(NC_("core", "{} is not a part of a frame (TR, FI, RT, SC, MI)"), in_quotes(name)));
  }
  set_part(value, *part, axis, number, column);
}

void FrameVariables::set_part(FrameValue& value, FrameValue::Part part, std::string_view axis, double number,
                              std::uint32_t column) {
  const int linear = linear_axis(axis);
  if (linear < 0) {
    other_axes_.move(axis, {.value = number, .column = column, .reading = Reading::absolute});
    return;
  }
  if (part == FrameValue::Part::scale && number == 0) {
    throw_frame(column, NC_("core", "a scale factor is zero"));
  }
  const bool angle = part == FrameValue::Part::angle;
  const bool length = part == FrameValue::Part::shift || part == FrameValue::Part::fine_shift;
  if (!value.set(part, linear, angle ? units::from_deg(number) : length ? to_mm(number) : number)) {
    throw_frame(column, NC_("core", "parts of a chain of frames cannot be set"));
  }
  value.set_by_program[static_cast<std::size_t>(linear)] |= part == FrameValue::Part::shift;
}

/// Sets a part of the programmable frame; only its shifts have parts.
void FrameVariables::set_programmed_part(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const int axis = linear_axis(scanner.name());
  require(scanner, ',');
  const std::optional<FrameValue::Part> part = FrameValue::part(scanner.name());
  require(scanner, ']');
  require(scanner, '=');
  const double number = to_mm(values_.read_bounded(scanner));
  const bool fine = part == FrameValue::Part::fine_shift;
  if (axis < 0 || !(fine || part == FrameValue::Part::shift)) {
    throw_frame(column,
                NC_("core", "in $P_PFRAME only shifts of X, Y and Z (TR, FI) can be set individually"));
  }
  coordinates_.set_programmed_shift(axis, number, fine);
}

/// Reads one frame or several joined by ":", each inside the previous one.
FrameValue FrameVariables::read(Scanner& scanner) {
  FrameValue value = operand(scanner);
  while (scanner.take(':')) {
    const FrameValue inner = operand(scanner);
    FrameValue chain(value.frame() * inner.frame());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      chain.set_by_program[axis] = value.set_by_program[axis] && inner.set_by_program[axis];
    }
    value = chain;
  }
  return value;
}

FrameValue FrameVariables::operand(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('$')) {
    return system_operand(scanner, column);
  }
  const std::string_view name = scanner.name();
  if (const auto variable = variables_.find(upper_case(name)); variable != variables_.end()) {
    return variable->second;
  }
  const auto constructor = std::find_if(constructors.begin(), constructors.end(),
                                        [&](const auto& entry) { return letters::same(entry.first, name); });
  if (constructor == constructors.end()) {
    throw_frame(column,
                message(NC_("core", "{} is not a supported frame"), feedscope::in_quotes(std::string(name))));
  }
  return frame_of_list(scanner, constructor->second);
}

/// Reads the name after "$", which is in `column`.
FrameValue FrameVariables::system_operand(Scanner& scanner, std::uint32_t column) {
  const std::string name = upper_case(scanner.name());
  if (name == "P_PFRAME") {
    return FrameValue(coordinates_.programmed());
  }
  if (name == "P_IFRAME") {
    return coordinates_.settable_in_force();
  }
  if (name == "P_UIFR") {
    require(scanner, '[');
    const int number = index(scanner);
    require(scanner, ']');
    return coordinates_.settable(number);
  }
  throw_frame(column,
              message(NC_("core", "{} is a control-internal value"), feedscope::in_quotes("$" + name)));
}

/// Reads "(X,10,Y,5)"; for a mirror image only the axes.
FrameValue FrameVariables::frame_of_list(Scanner& scanner, FrameValue::Part part) {
  FrameValue value;
  value.set_by_program.fill(true);
  require(scanner, '(');
  while (!scanner.take(')')) {
    const std::uint32_t column = scanner.column();
    const std::string_view axis = scanner.name();
    if (axis.empty()) {
      throw_frame(column, NC_("core", "an axis is missing here"));
    }
    double number = 1;
    if (part != FrameValue::Part::mirror) {
      require(scanner, ',');
      number = values_.read_bounded(scanner);
    }
    set_part(value, part, axis, number, column);
    if (!scanner.take(',') && scanner.peek() != ')') {
      throw_frame(scanner.column(), NC_("core", "\",\" or \")\" is missing here"));
    }
  }
  return value;
}

bool FrameVariables::run_assignment(Scanner& scanner, std::string_view name) {
  const char after = scanner.peek();
  if (variables_.empty() || (after != '=' && after != '[')) {
    return false;
  }
  const auto variable = variables_.find(upper_case(name));
  if (variable == variables_.end()) {
    return false;
  }
  assign(scanner, variable->second, scanner.take('['));
  return true;
}

void FrameVariables::define(Scanner& scanner) {
  do {
    const std::uint32_t column = scanner.column();
    const std::string_view name = scanner.name();
    if (name.empty() || scanner.peek() == '[') {
      throw ReadFault{"definition", column,
                      NC_("core", "DEF FRAME of an array, or without a name, is not supported"),
                      NC_("core", "define frames one by one")};
    }
    variables_[upper_case(name)] = scanner.take('=') ? read(scanner) : FrameValue();
  } while (scanner.take(','));
}

}  // namespace feedscope::sinumerik
