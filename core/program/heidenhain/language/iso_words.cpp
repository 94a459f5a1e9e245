#include "core/program/heidenhain/language/iso_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/program/heidenhain/geometry/motion.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

bool IsoBlock::has(int code) const {
  return std::find(codes.begin(), codes.begin() + code_count, code) != codes.begin() + code_count;
}

int take_digits(Scanner& scanner) {
  int value = 0;
  for (scanner.peek(); letters::is_digit(scanner.peek_at(0)); scanner.move_to(scanner.at() + 1)) {
    value = std::min(value * 10 + (scanner.peek_at(0) - '0'), 99999);
  }
  return value;
}

bool IsoWords::read(Scanner& scanner, bool incremental, IsoBlock& block) {
  while (!scanner.at_end()) {
    if (!read_word(scanner, incremental, block)) {
      return false;
    }
  }
  return true;
}

bool IsoWords::read_word(Scanner& scanner, bool incremental, IsoBlock& block) {
  const std::uint32_t column = scanner.column();
  const char letter = letters::to_upper(scanner.peek());
  switch (letter) {
    case 'G':
      return read_code(scanner, column, block);
    case 'M':
      m_functions_.read(scanner, column, block.motion);
      break;
    case 'L':
      scanner.take('L');
      if (block.has(99)) {
        read_value(scanner);
      } else {
        read_label(scanner, block);
      }
      break;
    case 'T':
      read_tool(scanner, block);
      break;
    case 'S':
      scanner.take('S');
      block.tool.speed = read_value(scanner);
      break;
    case 'D':
      read_tool_excess(scanner, block);
      break;
    case 'P':
      read_value_of_cycle(scanner, block);
      break;
    default:
      read_coordinate(scanner, letter, incremental, block);
      break;
  }
  return true;
}

void IsoWords::read_tool(Scanner& scanner, IsoBlock& block) const {
  scanner.take('T');
  if (block.has(62)) {
    block.values[0] = read_value(scanner);
    return;
  }
  block.tool.tool = tools_.read_name(scanner);
  if (!block.tool.tool) {
    throw_unread_words(scanner, NC_("core", "a tool call"));
  }
}

/// DR and DL of a tool call.
void IsoWords::read_tool_excess(Scanner& scanner, IsoBlock& block) const {
  const bool radius = scanner.take("DR") && !scanner.take('2');
  if (!radius && !scanner.take("DL")) {
    throw_unread_words(scanner, NC_("core", "a block"));
  }
  const double excess = read_length(scanner);
  block.tool.radius_excess = radius ? excess : block.tool.radius_excess;
}

/// P01 to P09.
void IsoWords::read_value_of_cycle(Scanner& scanner, IsoBlock& block) const {
  scanner.take('P');
  const int number = take_digits(scanner);
  if (number < 1 || number > 9) {
    throw_unread_words(scanner, NC_("core", "a block"));
  }
  block.values[static_cast<std::size_t>(number)] = read_value(scanner);
}

bool IsoWords::read_code(Scanner& scanner, std::uint32_t column, IsoBlock& block) {
  constexpr int first_cycle = 200;
  scanner.take('G');
  if (!letters::is_digit(scanner.peek())) {
    throw ReadFault{"malformed-number", column, NC_("core", "G without a number"),
                    NC_("core", "the block is skipped; write a code such as G1")};
  }
  const int code = take_digits(scanner);
  if (code >= first_cycle) {
    const std::string_view rest = scanner.rest();
    const std::size_t title = std::min(rest.find_first_of("Qq="), rest.size());
    cycles_.define(code, rest.substr(0, title), scanner, column);
    return false;
  }
  if (block.code_count == 0) {
    block.code_column = column;
  }
  if (block.code_count < static_cast<int>(block.codes.size())) {
    block.codes[static_cast<std::size_t>(block.code_count++)] = code;
  }
  return true;
}

void IsoWords::read_label(Scanner& scanner, IsoBlock& block) const {
  if (!letters::is_digit(scanner.peek())) {
    block.label = labels_.read(scanner);
    return;
  }
  // "L5,3" is not a decimal comma.
  block.label = fmt::format("{}", take_digits(scanner));
  if (scanner.take(',')) {
    block.repeats = take_digits(scanner);
  }
}

void IsoWords::read_coordinate(Scanner& scanner, char letter, bool incremental, IsoBlock& block) const {
  constexpr int mirroring = 28;
  const std::uint32_t column = scanner.column();
  const auto value = [&] {
    scanner.take(letter);
    return read_value(scanner);
  };
  MotionWords& words = block.motion;
  const auto place = [&] { words.first_column = words.first_column == 0 ? column : words.first_column; };
  switch (letter) {
    case 'X':
    case 'Y':
    case 'Z': {
      place();
      OptionalWord& axis = words.axes[static_cast<std::size_t>(letter - 'X')];
      // "G28 X Y" names axes only.
      if (block.has(mirroring)) {
        scanner.take(letter);
        axis.given = true;
      } else {
        axis = {to_mm(value()), true, false};
      }
      return;
    }
    case 'I':
    case 'J':
    case 'K':
      place();
      block.pole[static_cast<std::size_t>(letter - 'I')] = {to_mm(value()), true, false};
      return;
    case 'R':
      place();
      block.radius = value();
      return;
    case 'H':
      place();
      block.angle = value();
      return;
    case 'F':
      words.feed_column = column;
      read_feed(scanner, words);
      return;
    case 'A':
    case 'B':
    case 'C':
    case 'U':
    case 'V':
    case 'W':
      set_other_axis(letter, value(), incremental, column, words);
      return;
    default:
      throw_unread_words(scanner, NC_("core", "a block"));
  }
}

void IsoWords::read_feed(Scanner& scanner, MotionWords& words) const {
  scanner.take('F');
  if (scanner.take("MAX")) {
    words.feed_word = FeedWord::rapid;
    return;
  }
  words.feed_word = scanner.take("AUTO") ? FeedWord::of_tool_call : FeedWord::value;
  words.feed = words.feed_word == FeedWord::value ? read_value(scanner) : 0;
}

}  // namespace feedscope::heidenhain
