#include "core/program/heidenhain/language/m_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

/// M functions that change the path in a way that is not simulated.
struct UnreadFunction {
  int number = 0;
  Severity severity = Severity::info;
  Translatable subject;
  Translatable effect;
};

constexpr Translatable path_as_programmed = NC_("core", "the path is shown as programmed");
constexpr Translatable contour_as_usual = NC_("core", "the path with RL and RR is shown without it");
constexpr Translatable feed_as_programmed = NC_("core", "the programmed feed is shown");

constexpr auto unread_functions = std::to_array<UnreadFunction>({
    {97, Severity::warning, NC_("core", "small contour steps"), contour_as_usual},
    {98, Severity::warning, NC_("core", "open contour corners"), contour_as_usual},
    {103, Severity::warning, NC_("core", "feed factor for plunging"), feed_as_programmed},
    {109, Severity::info, NC_("core", "constant feed of the cutting edge"), feed_as_programmed},
    {110, Severity::info, NC_("core", "constant feed of the cutting edge on inside arcs"),
     feed_as_programmed},
    {112, Severity::info, NC_("core", "rounding between contour elements"), path_as_programmed},
    {114, Severity::warning, NC_("core", "rotary axes with tool compensation"),
     NC_("core", "X, Y and Z are shown as programmed")},
    {124, Severity::info, NC_("core", "filter of short lines"), path_as_programmed},
    {128, Severity::info, NC_("core", "tool centre point control"),
     NC_("core", "X, Y and Z of the tool tip are shown")},
    {130, Severity::warning, NC_("core", "positions in the untilted system"), path_as_programmed},
    {197, Severity::info, NC_("core", "tangential corners"), path_as_programmed},
});

}  // namespace

void MFunctions::read(Scanner& scanner, std::uint32_t column, MotionWords& words) const {
  scanner.take('M');
  if (scanner.at_end()) {
    // Older controls print words without a value.
    return;
  }
  const std::optional<double> number = scanner.number();
  if (!number || *number > 9999) {
    throw ReadFault{"malformed-number", column, NC_("core", "M without a number"),
                    NC_("core", "the block is skipped; write a function such as M3")};
  }
  const int function = static_cast<int>(*number);
  words.m_column = words.m_column == 0 ? column : words.m_column;
  if (words.m_count < static_cast<int>(words.m.size())) {
    words.m[static_cast<std::size_t>(words.m_count++)] = function;
  }
  // Words that belong to the function, not to the motion.
  const auto take_values = [&](std::string_view letters_of_function) {
    while (!scanner.at_end() &&
           letters_of_function.find(letters::to_upper(scanner.peek())) != std::string_view::npos) {
      scanner.take(scanner.peek());
      if (const char next = scanner.peek(); letters::is_digit(next) || next == '+' || next == '-' ||
                                            next == '.' || letters::to_upper(next) == 'Q') {
        read_value(scanner);
      }
    }
  };
  switch (function) {
    case 94:
    case 138:
      return take_values("ABC");
    case 103:
    case 128:
      return take_values("F");
    case 112:
    case 124:
      return take_values("TA");
    case 118:
      return take_values("XYZABC");
    case 120:
      if (scanner.take("LA")) {
        read_value(scanner);
      }
      return;
    case 140:
      if (scanner.take("MB")) {
        words.retract = scanner.take("MAX") ? std::numeric_limits<double>::infinity() : read_length(scanner);
      }
      return;
    default:
      return;
  }
}

void MFunctions::start(const MotionWords& words) {
  for (int i = 0; i < words.m_count; ++i) {
    const int number = words.m[static_cast<std::size_t>(i)];
    parts_.tools.run_spindle(number, words.m_column);
    if (number == 136 || number == 137) {
      parts_.feeds.set_per_revolution(number == 136);
    } else if (number == 120) {
      parts_.path_modes.use_look_ahead(words.m_column);
    }
    const auto unread = std::find_if(unread_functions.begin(), unread_functions.end(),
                                     [number](const UnreadFunction& f) { return f.number == number; });
    constexpr int tool_centre_point = 128;
    const bool followed = number == tool_centre_point && machining_.other_axes.turns();
    if (unread != unread_functions.end() && !followed) {
      report(unread->severity, "unread-m", number, words.m_column, [&] {
        return Text{message(NC_("core", "M{} ({}) is not supported"), number, unread->subject),
                    unread->effect};
      });
    }
  }
}

void MFunctions::retract(const MotionWords& words) {
  end_contour(words.m_column);
  if (!std::isfinite(*words.retract)) {
    std::array<bool, 3> named{};
    named[static_cast<std::size_t>(normal_axis(plane()))] = true;
    const AxisPlace end{AxisPlace::Kind::unknown, 0};
    path().go_to_machine_place(named, {end, end, end});
    machining_.report_machine_move("M140 MB MAX", "machine-position", words.m_column);
    return;
  }
  ContourElement element = parts_.targets.element(words, contour_.position());
  element.target[normal_axis(plane())] += *words.retract;
  element.feed.rapid = words.feed_word == FeedWord::none || words.feed_word == FeedWord::rapid;
  contour_.add(element);
}

void MFunctions::finish(const MotionWords& words, bool moved) {
  bool calls = parts_.cycles.is_modal() && moved;
  bool ends = false;
  for (int i = 0; i < words.m_count; ++i) {
    switch (words.m[static_cast<std::size_t>(i)]) {
      case 0:
      case 1:
        end_contour(words.m_column);
        path().pause(Pause::stop);
        break;
      case 2:
      case 30:
        ends = true;
        break;
      case 89:
        parts_.cycles.set_modal(true);
        calls = true;
        break;
      case 99:
        parts_.cycles.set_modal(false);
        calls = true;
        break;
      default:
        break;
    }
  }
  if (words.retract) {
    retract(words);
  }
  if (calls) {
    parts_.cycles.call(words.m_column > 0 ? words.m_column : words.first_column);
  }
  if (ends) {
    parts_.calls.end_of_program();
  }
}

}  // namespace feedscope::heidenhain
