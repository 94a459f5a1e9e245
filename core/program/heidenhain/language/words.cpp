#include "core/program/heidenhain/language/words.h"

#include <string>

#include "core/base/units.h"
#include "core/program/heidenhain/geometry/motion.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

[[noreturn]] void throw_unread_word(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  throw ReadFault{"unread-word", column,
                  message(NC_("core", "{} is not a word of this block"), in_quotes(scanner.rest())),
                  NC_("core", "the block is skipped; correct it")};
}

}  // namespace

MotionWords Words::read(Scanner& scanner) {
  MotionWords words;
  while (!scanner.at_end()) {
    const std::uint32_t column = scanner.column();
    if (!read_word(scanner, letters::to_upper(scanner.peek()), column, words)) {
      throw_unread_word(scanner);
    }
  }
  return words;
}

bool Words::read_word(Scanner& scanner, char letter, std::uint32_t column, MotionWords& words) {
  switch (letter) {
    case 'F':
      read_feed(scanner, column, words);
      return true;
    case 'R':
      read_radius(scanner, column, words);
      return true;
    case 'M':
      m_functions_.read(scanner, column, words);
      return true;
    case 'D':
      if (!scanner.take("DR")) {
        return false;
      }
      words.turn = scanner.take('-') ? -1 : 1;
      scanner.take('+');
      words.first_column = words.first_column == 0 ? column : words.first_column;
      return true;
    case 'L':
      if (scanner.take("LEN")) {
        words.length = read_length(scanner);
        return true;
      }
      // LIN_Z-5: the axis that moves along with an arc.
      return scanner.take("LIN_") &&
             read_axis(scanner, letters::to_upper(scanner.peek()), false, column, words);
    case 'N':
    case 'T':
      return read_normal(scanner, letter, column, words);
    case 'I':
      return read_axis(scanner, letters::to_upper(scanner.peek_at(1)), true, column, words);
    default:
      return read_axis(scanner, letter, false, column, words);
  }
}

bool Words::read_axis(Scanner& scanner, char letter, bool incremental, std::uint32_t column,
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
      set(words.axes[static_cast<std::size_t>(letter - 'X')], read_length(scanner));
      return true;
    case 'P': {
      const char which = letters::to_upper(scanner.peek_at(prefix + 1));
      if (which == 'A') {
        take(2);
        set(words.polar_angle, units::from_deg(read_value(scanner)));
      } else if (which == 'R') {
        take(2);
        set(words.polar_radius, read_length(scanner));
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
        words.center_angle = units::from_deg(read_value(scanner));
        return true;
      }
      take(1);
      set_other_axis(letter, read_value(scanner), incremental, column, words);
      return true;
    default:
      return false;
  }
}

/// Components of LN: N of the surface, T of the tool.
bool Words::read_normal(Scanner& scanner, char kind, std::uint32_t column, MotionWords& words) {
  const char axis = letters::to_upper(scanner.peek_at(1));
  if (axis != 'X' && axis != 'Y' && axis != 'Z') {
    return false;
  }
  scanner.move_to(scanner.at() + 2);
  const double value = read_value(scanner);
  if (kind == 'T') {
    words.tool_vector = words.tool_vector.value_or(Vec3::Zero());
    (*words.tool_vector)[axis - 'X'] = value;
    words.vector_column = words.vector_column == 0 ? column : words.vector_column;
  }
  if (machining_.other_axes.turns()) {
    if (kind == 'N') {
      report(Severity::info, "unread-vector", 1, column, [] {
        return Text{NC_("core", "surface normals (LN) are not used"),
                    NC_("core", "X, Y and Z are shown as programmed, without a compensation along them")};
      });
    }
    return true;
  }
  report(Severity::info, "unread-vector", 0, column, [] {
    return Text{NC_("core", "surface normals and tool directions (LN) are not supported"),
                NC_("core", "X, Y and Z are shown as programmed")};
  });
  return true;
}

void Words::read_feed(Scanner& scanner, std::uint32_t column, MotionWords& words) {
  scanner.take('F');
  words.feed_column = column;
  if (scanner.take("MAX")) {
    words.feed_word = FeedWord::rapid;
  } else if (scanner.take("AUTO")) {
    words.feed_word = FeedWord::of_tool_call;
  } else if (scanner.take('T')) {
    const double seconds = read_value(scanner);
    report(Severity::error, "unread-word", 1, column, [&] {
      return Text{message(NC_("core", "FT{} (time of the block) is not supported"), seconds),
                  NC_("core", "the last feed stays in force")};
    });
  } else if (const char next = letters::to_upper(scanner.peek());
             next == '\0' || next == 'M' || next == 'R') {
    // Older controls print words without a value.
    words.feed_word = FeedWord::none;
  } else {
    words.feed_word = scanner.take('Z')   ? FeedWord::per_tooth
                      : scanner.take('U') ? FeedWord::per_revolution
                                          : FeedWord::value;
    words.feed = read_value(scanner);
  }
}

void Words::read_radius(Scanner& scanner, std::uint32_t column, MotionWords& words) {
  scanner.take('R');
  const char next = letters::to_upper(scanner.peek_at(0));
  const char after = scanner.peek_at(1);
  const bool number_goes_on = letters::is_digit(after) || after == '.' || after == ',';
  if (next == '\0' || letters::is_blank(next)) {
    // Older controls print words without a value.
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
      return Text{message(NC_("core", "R{} (extension by the tool radius) is not supported"), next),
                  NC_("core", "the position is shown as programmed")};
    });
  } else if (next == '0' && !number_goes_on) {
    scanner.move_to(scanner.at() + 1);
    words.side = SideWord::off;
  } else {
    words.radius = read_length(scanner);
  }
}

}  // namespace feedscope::heidenhain
