// The part of HeidenhainReader for the words of path blocks.
#include <fmt/format.h>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

[[noreturn]] void throw_unread_word(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  throw ReadFault{"unread-word", column, fmt::format("{} is no word of this block", quoted(scanner.rest())),
                  "the block is left out; check it"};
}

}  // namespace

MotionWords HeidenhainReader::words(Scanner& scanner) {
  MotionWords words;
  while (true) {
    const char c = letters::to_upper(scanner.peek());
    const std::uint32_t column = scanner.column();
    switch (c) {
      case '\0':
        return words;
      case 'F':
        feed_word(scanner, column, words);
        continue;
      case 'R':
        radius_word(scanner, column, words);
        continue;
      case 'M':
        m_word(scanner, column, words);
        continue;
      case 'D':
        if (scanner.take("DR")) {
          words.turn = scanner.take('-') ? -1 : 1;
          scanner.take('+');
          words.first_column = words.first_column == 0 ? column : words.first_column;
          continue;
        }
        break;
      case 'L':
        if (scanner.take("LEN")) {
          words.length = to_mm(formulas().read_value(scanner));
          continue;
        }
        // LIN_Z-5: the axis that an arc takes along.
        if (scanner.take("LIN_") &&
            axis_word(scanner, letters::to_upper(scanner.peek()), false, column, words)) {
          continue;
        }
        break;
      case 'N':
      case 'T':
        if (normal_word(scanner, column)) {
          continue;
        }
        break;
      default: {
        const bool incremental = c == 'I';
        const char letter = incremental ? letters::to_upper(scanner.peek_at(1)) : c;
        if (axis_word(scanner, letter, incremental, column, words)) {
          continue;
        }
        break;
      }
    }
    throw_unread_word(scanner);
  }
}

bool HeidenhainReader::axis_word(Scanner& scanner, char letter, bool incremental, std::uint32_t column,
                                 MotionWords& words) {
  const std::size_t prefix = incremental ? 1 : 0;
  const auto take = [&](std::size_t length) { scanner.move_to(scanner.at() + prefix + length); };
  const auto set = [&](OptionalWord& word, double value) {
    word = {value, true, incremental};
    words.first_column = words.first_column == 0 ? column : words.first_column;
  };
  switch (letter) {
    case 'X':
    case 'Y':
    case 'Z':
      take(1);
      set(words.axes[static_cast<std::size_t>(letter - 'X')], to_mm(formulas().read_value(scanner)));
      return true;
    case 'P': {
      const char which = letters::to_upper(scanner.peek_at(prefix + 1));
      if (which == 'A') {
        take(2);
        set(words.polar_angle, units::from_deg(formulas().read_value(scanner)));
      } else if (which == 'R') {
        take(2);
        set(words.polar_radius, to_mm(formulas().read_value(scanner)));
      }
      return which == 'A' || which == 'R';
    }
    case 'A':
    case 'B':
    case 'C':
    case 'U':
    case 'V':
    case 'W':
      if (scanner.take("CCA")) {
        words.center_angle = units::from_deg(formulas().read_value(scanner));
        return true;
      }
      take(1);
      set_other_axis(letter, formulas().read_value(scanner), incremental, column, words);
      return true;
    default:
      return false;
  }
}

bool HeidenhainReader::normal_word(Scanner& scanner, std::uint32_t column) {
  const char axis = letters::to_upper(scanner.peek_at(1));
  if (axis != 'X' && axis != 'Y' && axis != 'Z') {
    return false;
  }
  scanner.move_to(scanner.at() + 2);
  formulas().read_value(scanner);
  report(Severity::info, "unread-vector", 0, column, [] {
    return Text{"surface normals and tool directions (LN) are not read",
                "X, Y and Z are shown as programmed"};
  });
  return true;
}

void HeidenhainReader::feed_word(Scanner& scanner, std::uint32_t column, MotionWords& words) {
  scanner.take('F');
  words.feed_column = column;
  if (scanner.take("MAX")) {
    words.feed_word = FeedWord::rapid;
  } else if (scanner.take("AUTO")) {
    words.feed_word = FeedWord::of_tool_call;
  } else if (scanner.take('T')) {
    const double seconds = formulas().read_value(scanner);
    report(Severity::error, "unread-word", 1, column, [&] {
      return Text{fmt::format("FT{} (the time of the block) is not read", seconds),
                  "the last feed stays in force"};
    });
  } else if (const char next = letters::to_upper(scanner.peek());
             next == '\0' || next == 'M' || next == 'R') {
    // Older controls print words that have no value.
    words.feed_word = FeedWord::none;
  } else {
    words.feed_word = scanner.take('Z')   ? FeedWord::per_tooth
                      : scanner.take('U') ? FeedWord::per_revolution
                                          : FeedWord::value;
    words.feed = formulas().read_value(scanner);
  }
}

void HeidenhainReader::radius_word(Scanner& scanner, std::uint32_t column, MotionWords& words) {
  scanner.take('R');
  const char next = letters::to_upper(scanner.peek_at(0));
  const char after = scanner.peek_at(1);
  const bool number_goes_on = letters::is_digit(after) || after == '.' || after == ',';
  if (next == '\0' || letters::is_blank(next)) {
    // Older controls print words that have no value.
    return;
  }
  const bool sign_alone = (next == '+' || next == '-') && (after == '\0' || letters::is_blank(after));
  if (next == 'L' || next == 'R') {
    scanner.move_to(scanner.at() + 1);
    words.side = next == 'L' ? SideWord::left : SideWord::right;
    words.side_column = column;
  } else if (sign_alone) {
    scanner.move_to(scanner.at() + 1);
    report(Severity::error, "unread-word", 2, column, [&] {
      return Text{fmt::format("R{} (longer or shorter by the tool's radius) is not read", next),
                  "the position is shown as programmed"};
    });
  } else if (next == '0' && !number_goes_on) {
    scanner.move_to(scanner.at() + 1);
    words.side = SideWord::off;
  } else {
    words.radius = to_mm(formulas().read_value(scanner));
  }
}

}  // namespace feedscope
