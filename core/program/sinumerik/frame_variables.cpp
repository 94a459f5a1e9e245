// The part of SinumerikReader that reads the control's frame variables, and those of the program: DEF FRAME.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

namespace {

/// Number of a settable frame by its G word: G500 is 0, G54 is 1, G505 is 5.
int frame_number(int g) {
  return g >= 500 ? g - 500 : g - 53;
}

constexpr double most_frames = 100;

[[noreturn]] void throw_frame(std::uint32_t column, std::string message) {
  throw ReadFault{
      "frame-value", column, std::move(message),
      "the frame stays as it is; write CTRANS, CROT, CSCALE, CMIRROR with axes and values, joined by "
      "\":\", or a variable that holds a frame"};
}

}  // namespace

/// "$P_PFRAME=...", "$P_IFRAME=...", "$P_UIFR[1]=...", "$P_UIFR[1,X,TR]=...", whose name has just been read.
/// False, and nothing taken, for other variables.
bool SinumerikReader::run_frame_variable(Scanner& scanner, std::string_view name) {
  if (name == "P_UIFR") {
    require(scanner, '[');
    const int number = frame_index(scanner);
    const auto known = settable_frames_.find(number);
    FrameValue value = known == settable_frames_.end() ? FrameValue() : known->second;
    assign_frame(scanner, value, scanner.take(','));
    settable_frames_[number] = value;
    return true;
  }
  if (name == "P_IFRAME") {
    assign_frame(scanner, settable_frame_, scanner.take('['));
    finish_spline();
    frames_.set_settable(settable_frame_.frame());
    set_frame();
    return true;
  }
  if (name != "P_PFRAME") {
    return false;
  }
  finish_spline();
  if (scanner.take('[')) {
    set_programmed_part(scanner);
  } else {
    FrameValue value;
    assign_frame(scanner, value, false);
    frames_.replace(value.frame());
  }
  set_frame();
  return true;
}

/// The number of a settable frame.
int SinumerikReader::frame_index(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const double number = std::floor(values_.read(scanner) + 0.5);
  if (!(number >= 0 && number < most_frames)) {
    throw ReadFault{"array-index", column,
                    fmt::format("{} is no settable frame, they go from 0 to {}", number, most_frames - 1),
                    "correct the number"};
  }
  return static_cast<int>(number);
}

/// Behind the name or its "[": a part, as "X,TR]=5", or the whole, as "]=CTRANS(X,5)".
void SinumerikReader::assign_frame(Scanner& scanner, FrameValue& value, bool one_part) {
  if (!one_part) {
    scanner.take(']');
    require(scanner, '=');
    value = read_frame(scanner);
    return;
  }
  const std::uint32_t column = scanner.column();
  const std::string_view axis = scanner.name();
  require(scanner, ',');
  const std::optional<FrameValue::Part> part = FrameValue::part(scanner.name());
  require(scanner, ']');
  require(scanner, '=');
  const double number = values_.read_bounded(scanner);
  if (!part) {
    throw_frame(column, "a frame has no such part");
  }
  set_frame_part(value, *part, axis, number, column);
}

void SinumerikReader::set_frame_part(FrameValue& value, FrameValue::Part part, std::string_view axis,
                                     double number, std::uint32_t column) {
  const int index = linear_axis(axis);
  if (index < 0) {
    report_axis(axis, column, number);
    return;
  }
  if (part == FrameValue::Part::scale && number == 0) {
    throw_frame(column, "a scale factor is zero");
  }
  const bool angle = part == FrameValue::Part::angle;
  const bool length = part == FrameValue::Part::shift || part == FrameValue::Part::fine_shift;
  if (!value.set(part, index, angle ? units::from_deg(number) : length ? to_mm(number) : number)) {
    throw_frame(column, "a part of a chain of frames cannot be set");
  }
}

/// Of the programmable frame, whose shifts alone have parts.
void SinumerikReader::set_programmed_part(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const int axis = linear_axis(scanner.name());
  require(scanner, ',');
  const std::optional<FrameValue::Part> part = FrameValue::part(scanner.name());
  require(scanner, ']');
  require(scanner, '=');
  const double number = to_mm(values_.read_bounded(scanner));
  if (axis >= 0 && part == FrameValue::Part::shift) {
    frames_.set_coarse(axis, number);
  } else if (axis >= 0 && part == FrameValue::Part::fine_shift) {
    frames_.set_fine(axis, number);
  } else {
    throw_frame(column, "of $P_PFRAME only shifts of X, Y and Z (TR, FI) are set one by one");
  }
}

/// One frame or several, joined by ":": what stands behind acts inside of what stands before.
FrameValue SinumerikReader::read_frame(Scanner& scanner) {
  FrameValue value = frame_operand(scanner);
  while (scanner.take(':')) {
    value = FrameValue(value.frame() * frame_operand(scanner).frame());
  }
  return value;
}

FrameValue SinumerikReader::frame_operand(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (scanner.take('$')) {
    const std::string name = upper_case(scanner.name());
    if (name == "P_PFRAME") {
      return FrameValue(frames_.programmed());
    }
    if (name == "P_IFRAME") {
      return settable_frame_;
    }
    if (name == "P_UIFR") {
      require(scanner, '[');
      const int number = frame_index(scanner);
      require(scanner, ']');
      const auto known = settable_frames_.find(number);
      return known == settable_frames_.end() ? FrameValue() : known->second;
    }
    throw_frame(column, fmt::format("{} is known to the machine only", feedscope::quoted("$" + name)));
  }
  const std::string_view name = scanner.name();
  if (const auto variable = frame_variables_.find(upper_case(name)); variable != frame_variables_.end()) {
    return variable->second;
  }
  constexpr auto functions =
      std::to_array<std::pair<std::string_view, FrameValue::Part>>({{"CTRANS", FrameValue::Part::shift},
                                                                    {"CFINE", FrameValue::Part::fine_shift},
                                                                    {"CROT", FrameValue::Part::angle},
                                                                    {"CSCALE", FrameValue::Part::scale},
                                                                    {"CMIRROR", FrameValue::Part::mirror}});
  const auto function = std::find_if(functions.begin(), functions.end(),
                                     [&](const auto& entry) { return letters::same(entry.first, name); });
  if (function == functions.end()) {
    throw_frame(column, fmt::format("{} is no frame that is read", feedscope::quoted(std::string(name))));
  }
  return frame_of_list(scanner, function->second);
}

/// "(X,10,Y,5)"; of a mirror image the axes alone.
FrameValue SinumerikReader::frame_of_list(Scanner& scanner, FrameValue::Part part) {
  FrameValue value;
  require(scanner, '(');
  while (!scanner.take(')')) {
    const std::uint32_t column = scanner.column();
    const std::string_view axis = scanner.name();
    if (axis.empty()) {
      throw_frame(column, "an axis is missing here");
    }
    double number = 1;
    if (part != FrameValue::Part::mirror) {
      require(scanner, ',');
      number = values_.read_bounded(scanner);
    }
    set_frame_part(value, part, axis, number, column);
    if (!scanner.take(',') && scanner.peek() != ')') {
      throw_frame(scanner.column(), "\",\" or \")\" is missing here");
    }
  }
  return value;
}

/// "F1=..." of a variable that DEF FRAME has made.
bool SinumerikReader::run_frame_assignment(Scanner& scanner, std::string_view name) {
  const char after = scanner.peek();
  if (frame_variables_.empty() || (after != '=' && after != '[')) {
    return false;
  }
  const auto variable = frame_variables_.find(upper_case(name));
  if (variable == frame_variables_.end()) {
    return false;
  }
  assign_frame(scanner, variable->second, scanner.take('['));
  return true;
}

/// Behind "DEF FRAME".
void SinumerikReader::define_frames(Scanner& scanner) {
  do {
    const std::uint32_t column = scanner.column();
    const std::string_view name = scanner.name();
    if (name.empty() || scanner.peek() == '[') {
      throw ReadFault{"definition", column, "an array of frames, or one without a name, is not read",
                      "define frames one by one"};
    }
    frame_variables_[upper_case(name)] = scanner.take('=') ? read_frame(scanner) : FrameValue();
  } while (scanner.take(','));
}

/// Of ReadOptions.
void SinumerikReader::take_given_offsets() {
  for (const auto& [name, zero] : options().offsets.all()) {
    const int g =
        name.find_first_not_of("0123456789", 1) == std::string::npos ? std::stoi(name.substr(1)) : 0;
    const int number = frame_number(g);
    if (g >= 54 && number > 0) {
      FrameValue& frame = settable_frames_[number];
      for (int axis = 0; axis < 3; ++axis) {
        frame.set(FrameValue::Part::shift, axis, zero[axis]);
      }
    }
  }
}

/// G54 to G599: the frame that the program has given this number, else none.
void SinumerikReader::change_work_offset(int number, std::uint32_t column) {
  const int before = modal_.work_offset;
  modal_.work_offset = number;
  const auto known = [this](int g) { return settable_frames_.find(frame_number(g)); };
  const auto found = known(number);
  const bool said =
      found != settable_frames_.end() && (before == 0 || known(before) != settable_frames_.end());
  if (path().has_moved() && before != 0 && before != number && !said) {
    report(Severity::warning, "work-offset", number, column, [&] {
      return Text{fmt::format("G{} follows G{} on the way", number, before),
                  fmt::format("offsets that are not given are assumed as zero, so parts of the path lie over "
                              "each other; give them as an import option, --offset G{}=X,Y,Z",
                              number)};
    });
  }
  constexpr int suppressed = 500;
  std::optional<Vec3> zero = number == suppressed ? std::optional<Vec3>(Vec3::Zero()) : std::nullopt;
  if (found != settable_frames_.end()) {
    zero = found->second.frame().to_shown(Vec3::Zero());
  }
  path().use_work_offset(fmt::format("G{}", number), zero);
  if (settable_frames_.empty()) {
    return;
  }
  finish_spline();
  settable_frame_ = found == settable_frames_.end() ? FrameValue() : found->second;
  frames_.set_settable(settable_frame_.frame());
  set_frame();
}

}  // namespace feedscope
