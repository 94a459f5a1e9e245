// The part of HeidenhainCore for feeds, M functions, tools and settings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_core.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// M functions that change what the control does with the path in a way that is not followed.
struct UnreadFunction {
  int number = 0;
  Severity severity = Severity::info;
  std::string_view subject;
  std::string_view effect;
};

constexpr std::string_view path_as_programmed = "the path is shown as programmed";
constexpr std::string_view contour_as_usual = "with RL and RR the path is shown as without it";
constexpr std::string_view feed_as_programmed = "the programmed feed is shown";

constexpr auto unread_functions = std::to_array<UnreadFunction>({
    {97, Severity::warning, "small contour steps", contour_as_usual},
    {98, Severity::warning, "open contour corners", contour_as_usual},
    {103, Severity::warning, "slower plunging", feed_as_programmed},
    {109, Severity::info, "constant feed of the cutting edge", feed_as_programmed},
    {110, Severity::info, "constant feed of the cutting edge inside", feed_as_programmed},
    {112, Severity::info, "rounding between any elements", path_as_programmed},
    {114, Severity::warning, "rotary axes with tool compensation", "X, Y and Z are shown as programmed"},
    {124, Severity::info, "filter of short lines", path_as_programmed},
    {128, Severity::info, "tool centre point control", "X, Y and Z of the tool tip are shown"},
    {130, Severity::warning, "positions in the untilted system", path_as_programmed},
    {197, Severity::info, "tangential corners", path_as_programmed},
});

}  // namespace

void HeidenhainCore::m_word(Scanner& scanner, std::uint32_t column, MotionWords& words) {
  scanner.take('M');
  if (scanner.at_end()) {
    // Older controls print words that have no value.
    return;
  }
  const std::optional<double> number = scanner.number();
  if (!number || *number > 9999) {
    throw ReadFault{"malformed-number", column, "M without a number of a function",
                    "the block is left out; write M3"};
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
        formulas().read_value(scanner);
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
        formulas().read_value(scanner);
      }
      return;
    case 140:
      if (scanner.take("MB")) {
        words.retract = scanner.take("MAX") ? std::numeric_limits<double>::infinity()
                                            : to_mm(formulas().read_value(scanner));
      }
      return;
    default:
      return;
  }
}

void HeidenhainCore::report_feed_value(const MotionWords& words) {
  report(Severity::error, "feed-value", 0, words.feed_column, [&] {
    return Text{fmt::format("feed F{} is not above zero", words.feed),
                feed_.value > 0 ? "the last valid feed stays in force; write a feed above zero"
                                : "feed moves run as fast as the axes allow; write a feed above zero"};
  });
}

void HeidenhainCore::apply_feed(const MotionWords& words) {
  if (words.feed_word == FeedWord::none || words.feed_word == FeedWord::rapid) {
    return;
  }
  const bool of_tool = words.feed_word == FeedWord::of_tool_call;
  const double written = of_tool ? tool_feed_ : words.feed;
  const FeedWord word = of_tool ? tool_feed_word_ : words.feed_word;
  if (!(written > 0)) {
    report_feed_value(words);
    return;
  }
  if (word == FeedWord::per_tooth) {
    feed_ = {FeedMode::per_tooth, to_mm(written)};
    report(Severity::warning, "tooth-count", 0, words.feed_column, [] {
      return Text{"a feed per tooth, and how many teeth the tool has only the tool table knows",
                  "one tooth is counted; write F or FU for the right feed"};
    });
  } else if (word == FeedWord::per_revolution || revolution_feed_) {
    feed_ = {FeedMode::per_revolution, to_mm(written)};
  } else {
    feed_ = {FeedMode::per_minute, to_feed(written)};
  }
}

void HeidenhainCore::apply_side(const MotionWords& words) {
  switch (words.side) {
    case SideWord::none:
      return;
    case SideWord::off:
      side_ = 0;
      return;
    case SideWord::left:
      side_ = 1;
      break;
    case SideWord::right:
      side_ = -1;
      break;
  }
  if (!use_cutter(tool_, defined_radii_.find(tool_))) {
    report(Severity::error, "tool-radius", 0, words.side_column, [&] {
      return Text{
          fmt::format("{} beside a tool whose radius is not known", side_ > 0 ? "RL" : "RR"),
          fmt::format("the path shown is the programmed contour; {}, or write a TOOL DEF with R before "
                      "the tool call",
                      radius_hint(tool_))};
    });
  }
}

void HeidenhainCore::start_functions(const MotionWords& words) {
  for (int i = 0; i < words.m_count; ++i) {
    const int number = words.m[static_cast<std::size_t>(i)];
    run_spindle(number, words.m_column);
    if (number == 136 || number == 137) {
      revolution_feed_ = number == 136;
      feed_ = {number == 136 ? FeedMode::per_revolution : FeedMode::per_minute, 0};
    } else if (number == 120) {
      end_contour(words.m_column);
      PathControl control = path().path_control();
      control.look_ahead = Switch::on;
      path().set_path_control(control);
    }
    const auto unread = std::find_if(unread_functions.begin(), unread_functions.end(),
                                     [number](const UnreadFunction& f) { return f.number == number; });
    if (unread != unread_functions.end()) {
      report(unread->severity, "unread-m", number, words.m_column, [&] {
        return Text{fmt::format("M{} ({}) is not read", number, unread->subject),
                    std::string(unread->effect)};
      });
    }
  }
}

void HeidenhainCore::run_spindle(int number, std::uint32_t column) {
  switch (number) {
    case 3:
    case 4:
    case 13:
    case 14:
      if (!spindle_turns()) {
        end_contour(column);
        start_spindle();
      }
      break;
    case 5:
    case 19:
      stop_spindle();
      break;
    default:
      break;
  }
}

void HeidenhainCore::retract(const MotionWords& words) {
  end_contour(words.m_column);
  if (!std::isfinite(*words.retract)) {
    std::array<bool, 3> named{};
    named[static_cast<std::size_t>(normal_axis(contour_.plane()))] = true;
    const AxisPlace end{AxisPlace::Kind::unknown, 0};
    path().go_to_machine_place(named, {end, end, end});
    report_machine_move("M140 MB MAX", "machine-position", words.m_column);
    return;
  }
  ContourElement element = element_of(words, contour_.position());
  element.target[normal_axis(contour_.plane())] += *words.retract;
  element.feed.rapid = words.feed_word == FeedWord::none || words.feed_word == FeedWord::rapid;
  contour_.add(element);
}

void HeidenhainCore::finish_functions(const MotionWords& words, bool moved) {
  bool calls = modal_cycle_ && moved;
  bool ends = false;
  for (int i = 0; i < words.m_count; ++i) {
    switch (words.m[static_cast<std::size_t>(i)]) {
      case 0:
      case 1:
        end_contour(words.m_column);
        stop_program();
        break;
      case 2:
      case 30:
        ends = true;
        break;
      case 89:
        modal_cycle_ = true;
        calls = true;
        break;
      case 99:
        modal_cycle_ = false;
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
    call_cycle(words.m_column > 0 ? words.m_column : words.first_column);
  }
  if (ends) {
    end_of_program();
  }
}

void HeidenhainCore::call_tool(const ToolCall& call) {
  contour_.flush();
  if (call.tool) {
    tool_ = *call.tool;
    select_tool(tool_);
    path().begin_line(shown_line(), spot(0));
    change_tool(tool_);
    tool_radius_ = cutter_radius(tool_, defined_radii_.find(tool_));
    if (tool_radius_) {
      *tool_radius_ += call.radius_excess;
    }
  }
  if (call.plane) {
    contour_.set_plane(*call.plane);
    pole_plane_ = *call.plane;
  }
  if (call.speed) {
    spindle_speed_ = *call.speed;
    path().set_spindle_speed(spindle_speed_ / 60);
  }
  if (call.feed && *call.feed != 0) {
    // It holds until another F (TNC 426/430 user's manual, 5.2 Tool Data).
    tool_feed_ = *call.feed;
    MotionWords words;
    words.feed_word = call.feed_word;
    words.feed = *call.feed;
    words.feed_column = call.feed_column;
    tool_feed_word_ = call.feed_word;
    apply_feed(words);
  }
}

void HeidenhainCore::set_blank_corner(bool upper, const std::array<OptionalWord, 3>& words,
                                      std::uint32_t column) {
  Vec3 corner = upper && blank_ ? *blank_ : Vec3(0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const OptionalWord& word = words[static_cast<std::size_t>(axis)];
    corner[axis] = word.incremental ? corner[axis] + word.value : word.value;
  }
  if (!upper) {
    blank_ = corner;
  } else if (blank_ && !(corner.array() > blank_->array()).all()) {
    report(Severity::warning, "blank-form", 0, column, [] {
      return Text{"the upper corner of the blank does not lie above the lower one in every axis",
                  "the control refuses such a blank; the path does not depend on it"};
    });
  }
}

double HeidenhainCore::checked_factor(double factor, std::uint32_t column) {
  constexpr double least = 0.000001;
  constexpr double most = 99.999999;
  if (!(factor >= least && factor <= most)) {
    throw ReadFault{"scale-factor", column,
                    fmt::format("the scaling factor {} is not from 0.000001 to 99.999999", factor),
                    "the scaling is left out"};
  }
  return factor;
}

void HeidenhainCore::apply_transformations(std::uint32_t column) {
  end_contour(column);
  path().set_frame(transformations_.frame());
}

void HeidenhainCore::set_tilt(const std::optional<CoordinateFrame>& tilt, std::uint32_t column) {
  if (tilt) {
    transformations_.tilt(*tilt);
  } else {
    transformations_.reset(Transformations::Kind::tilt);
  }
  apply_transformations(column);
}

void HeidenhainCore::shift_datum(const std::array<OptionalWord, 3>& to, std::uint32_t column) {
  const bool under_tilt = transformations_.has_shift_under_tilt();
  const Vec3 before = transformations_.shift();
  for (int axis = 0; axis < 3; ++axis) {
    const OptionalWord& word = to[static_cast<std::size_t>(axis)];
    if (word.given) {
      transformations_.shift(axis, word.value, word.incremental);
    }
  }
  const Vec3 after = transformations_.shift();
  // Cancelled axis by axis before the tilt is: no harm.
  const bool shifts = ((after - before).array() != 0 && after.array() != 0).any();
  if (under_tilt && shifts) {
    report(Severity::warning, "tilted-shift", 0, column, [] {
      return Text{
          "a datum shift takes the place of one that the plane was tilted about",
          "it is taken in the untilted system; cancel the tilt before it, or shift in the tilted plane only"};
    });
  }
}

void HeidenhainCore::set_tolerance(std::optional<double> tolerance,
                                   std::optional<double> orientation_tolerance, std::uint32_t column) {
  if (tolerance && *tolerance < 0) {
    throw ReadFault{"tolerance", column, fmt::format("the tolerance T{} is below zero", *tolerance),
                    "the tolerance in force stays"};
  }
  end_contour(column);
  PathControl control = path().path_control();
  // T0 is no tolerance: the machine's own holds (TNC 640 cycles manual, cycle 32).
  tolerance = tolerance.value_or(0) > 0 ? tolerance : std::nullopt;
  control.mode = tolerance ? PathMode::continuous : PathMode::machine;
  control.contour_tolerance = tolerance;
  control.orientation_tolerance = orientation_tolerance;
  path().set_path_control(control);
}

void HeidenhainCore::dwell(double seconds, std::uint32_t column) {
  constexpr double longest = 1e9;
  if (!(seconds >= 0 && seconds <= longest)) {
    report(Severity::error, "dwell-time", 0, column, [&] {
      return Text{seconds < 0 ? fmt::format("dwell time {} is negative", seconds)
                              : fmt::format("dwell time {} is beyond 1000000000 s", seconds),
                  "the dwell is left out"};
    });
    return;
  }
  end_contour(column);
  if (seconds > 0) {
    path().dwell(seconds);
  }
}

void HeidenhainCore::set_preset(std::string_view what, bool keeps_transformations, std::uint32_t column) {
  if (!keeps_transformations) {
    // iTNC 530 and TNC 640 cycle programming, cycle 247.
    using Kind = Transformations::Kind;
    for (const Kind kind : {Kind::shift, Kind::mirror, Kind::rotation, Kind::scale}) {
      transformations_.reset(kind);
    }
    apply_transformations(column);
  }
  set_datum(what, column);
}

void HeidenhainCore::set_datum(std::string_view what, std::uint32_t column) {
  end_contour(column);
  if (path().has_moved()) {
    report(Severity::warning, "work-offset", 0, column, [&] {
      return Text{fmt::format("{} changes the datum on the way", what),
                  "datums of the machine are taken as zero, so the parts of the path lie over each other"};
    });
  }
}

}  // namespace feedscope
