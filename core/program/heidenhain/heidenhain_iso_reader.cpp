#include "core/program/heidenhain/heidenhain_iso_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Behind "N20"; true if the block is hidden by "/".
bool skip_number(Scanner& scanner) {
  const bool hidden = scanner.take('/');
  if (letters::to_upper(scanner.peek()) == 'N' && letters::is_digit(scanner.peek_at(1))) {
    scanner.take('N');
    scanner.skip_digits();
  }
  return scanner.take('/') || hidden;
}

bool names_unit(std::string_view text) {
  return text.find("G70") != std::string_view::npos || text.find("G71") != std::string_view::npos;
}

constexpr bool is_polar(int motion) {
  return motion >= 10 && motion <= 16;
}

int take_digits(Scanner& scanner) {
  int value = 0;
  for (scanner.peek(); letters::is_digit(scanner.peek_at(0)); scanner.move_to(scanner.at() + 1)) {
    value = std::min(value * 10 + (scanner.peek_at(0) - '0'), 99999);
  }
  return value;
}

constexpr auto motion_codes = std::to_array<int>({0, 1, 2, 3, 5, 6, 7, 10, 11, 12, 13, 15, 16});

template <std::size_t Count>
bool is_one_of(int code, const std::array<int, Count>& codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

}  // namespace

bool HeidenhainIsoReader::Block::has(int code) const {
  return std::find(codes.begin(), codes.begin() + code_count, code) != codes.begin() + code_count;
}

void HeidenhainIsoReader::run_statement(std::string_view statement) {
  const std::size_t last = statement.find_last_not_of(" \t");
  if (statement[last] == '*') {
    statement = statement.substr(0, last);
  }
  Scanner scanner(statement);
  const bool hidden = skip_number(scanner);
  if (scanner.at_end() || scanner.peek() == '*' || (hidden && options().skip_deleted_blocks)) {
    return;
  }
  count_block();
  const std::uint32_t column = scanner.column();
  const char first = letters::to_upper(scanner.peek());
  const char second = scanner.peek_at(1);
  if (scanner.take('%')) {
    run_percent(scanner.rest(), column);
  } else if (first == 'D' && letters::is_digit(second)) {
    run_d_function(scanner, column);
  } else if (first == 'Q') {
    assign(scanner);
  } else {
    Block block;
    block.column = column;
    if (read_block(scanner, block)) {
      run_block(block);
    }
  }
}

std::uint32_t HeidenhainIsoReader::first_word(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_number(scanner);
  const std::uint32_t column = scanner.column();
  return scanner.at_end() || scanner.peek() == '*' || scanner.peek() == '%' ? 0 : column;
}

std::string HeidenhainIsoReader::label_on(std::string_view line) {
  Scanner scanner(line.substr(0, line.find(';')));
  skip_number(scanner);
  if (!scanner.take("G98") || !scanner.take('L')) {
    return {};
  }
  Block block;
  read_label(scanner, block);
  return *block.label == "0" ? std::string() : *block.label;
}

void HeidenhainIsoReader::run_percent(std::string_view rest, std::uint32_t column) {
  if (!names_unit(rest)) {
    call_program(rest, column);
  } else if (begun_ && call_depth() == 0) {
    end_of_program();
  } else if (call_depth() > 0 && line() > 1) {
    end_of_program();
  } else {
    begun_ = true;
    set_inch(rest.find("G70") != std::string_view::npos);
  }
}

void HeidenhainIsoReader::run_d_function(Scanner& scanner, std::uint32_t column) {
  constexpr int system_read = 18;
  constexpr int angle = 13;
  scanner.take('D');
  FunctionCall call;
  call.number = take_digits(scanner);
  call.column = column;
  scanner.take(':');
  if (call.number == system_read) {
    read_system_data(scanner, column);
    return;
  }
  const bool jumps = call.number >= 9 && call.number <= 12;
  const bool computes = call.number <= 8 || call.number == angle;
  if (computes) {
    call.result = take_parameter(scanner);
    if (!call.result || call.result->kind == QName::Kind::text) {
      throw_unread_words(scanner, "D");
    }
  }
  while ((jumps || computes) && !scanner.at_end()) {
    if (!scanner.take('P')) {
      throw_unread_words(scanner, "D");
    }
    const int operand = take_digits(scanner);
    if (jumps && operand == 3) {
      call.label = label(scanner);
    } else if (operand == 1 || operand == 2) {
      call.values[static_cast<std::size_t>(operand - 1)] = formulas().read_value(scanner);
    } else {
      throw_unread_words(scanner, "D");
    }
  }
  run_function(call);
}

bool HeidenhainIsoReader::read_block(Scanner& scanner, Block& block) {
  while (!scanner.at_end()) {
    if (!read_word(scanner, block)) {
      return false;
    }
  }
  return true;
}

bool HeidenhainIsoReader::read_word(Scanner& scanner, Block& block) {
  const std::uint32_t column = scanner.column();
  const char letter = letters::to_upper(scanner.peek());
  switch (letter) {
    case 'G':
      return read_code(scanner, column, block);
    case 'M':
      m_word(scanner, column, block.motion);
      return true;
    case 'L':
      scanner.take('L');
      if (block.has(99)) {
        formulas().read_value(scanner);
      } else {
        read_label(scanner, block);
      }
      return true;
    case 'T':
      scanner.take('T');
      if (block.has(62)) {
        block.values[0] = formulas().read_value(scanner);
        return true;
      }
      block.tool.tool = tool_name(scanner);
      if (!block.tool.tool) {
        throw_unread_words(scanner, "a tool call");
      }
      return true;
    case 'S':
      scanner.take('S');
      block.tool.speed = formulas().read_value(scanner);
      return true;
    case 'D': {
      const bool radius = scanner.take("DR") && !scanner.take('2');
      if (!radius && !scanner.take("DL")) {
        throw_unread_words(scanner, "a block");
      }
      const double excess = to_mm(formulas().read_value(scanner));
      block.tool.radius_excess = radius ? excess : block.tool.radius_excess;
      return true;
    }
    case 'P': {
      scanner.take('P');
      const int number = take_digits(scanner);
      if (number < 1 || number > 9) {
        throw_unread_words(scanner, "a block");
      }
      block.values[static_cast<std::size_t>(number)] = formulas().read_value(scanner);
      return true;
    }
    default:
      read_coordinate(scanner, letter, column, block);
      return true;
  }
}

bool HeidenhainIsoReader::read_code(Scanner& scanner, std::uint32_t column, Block& block) {
  constexpr int first_cycle = 200;
  scanner.take('G');
  if (!letters::is_digit(scanner.peek())) {
    throw ReadFault{"malformed-number", column, "G without a number", "the block is left out; write G1"};
  }
  const int code = take_digits(scanner);
  if (code >= first_cycle) {
    const std::string_view rest = scanner.rest();
    const std::size_t title = std::min(rest.find_first_of("Qq="), rest.size());
    define_cycle(code, rest.substr(0, title), scanner, column);
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

void HeidenhainIsoReader::read_label(Scanner& scanner, Block& block) {
  if (!letters::is_digit(scanner.peek())) {
    block.label = label(scanner);
    return;
  }
  // "L5,3": not a decimal comma.
  block.label = fmt::format("{}", take_digits(scanner));
  if (scanner.take(',')) {
    block.repeats = take_digits(scanner);
  }
}

void HeidenhainIsoReader::read_coordinate(Scanner& scanner, char letter, std::uint32_t column, Block& block) {
  const auto value = [&] {
    scanner.take(letter);
    return formulas().read_value(scanner);
  };
  MotionWords& words = block.motion;
  const auto place = [&] { words.first_column = words.first_column == 0 ? column : words.first_column; };
  switch (letter) {
    case 'X':
    case 'Y':
    case 'Z':
      place();
      // "G28 X Y" names axes only.
      if (block.has(28)) {
        scanner.take(letter);
        words.axes[static_cast<std::size_t>(letter - 'X')].given = true;
      } else {
        words.axes[static_cast<std::size_t>(letter - 'X')] = {to_mm(value()), true, false};
      }
      return;
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
      scanner.take('F');
      if (scanner.take("MAX")) {
        words.feed_word = FeedWord::rapid;
      } else {
        words.feed_word = scanner.take("AUTO") ? FeedWord::of_tool_call : FeedWord::value;
        words.feed = words.feed_word == FeedWord::value ? formulas().read_value(scanner) : 0;
      }
      return;
    case 'A':
    case 'B':
    case 'C':
    case 'U':
    case 'V':
    case 'W':
      set_other_axis(letter, value(), incremental_, column, words);
      return;
    default:
      throw_unread_words(scanner, "a block");
  }
}

void HeidenhainIsoReader::run_block(Block& block) {
  apply_modes(block);
  if (block.label && !block.has(98)) {
    if (block.repeats.value_or(0) > 0) {
      repeat_from_label(*block.label, *block.repeats, block.column);
    } else {
      call_label(*block.label, block.column);
    }
    return;
  }
  if (block.has(98) && block.label == "0") {
    end_subprogram();
    return;
  }
  if (run_codes(block)) {
    return;
  }
  if (block.tool.tool || block.tool.speed) {
    run_tool(block);
  }
  run_motion(block);
}

void HeidenhainIsoReader::apply_modes(Block& block) {
  for (int i = 0; i < block.code_count; ++i) {
    const int code = block.codes[static_cast<std::size_t>(i)];
    if (code == 90 || code == 91) {
      incremental_ = code == 91;
    } else if (code == 70 || code == 71) {
      set_inch(code == 70);
    } else if (code >= 40 && code <= 42) {
      block.motion.side = code == 40 ? SideWord::off : code == 41 ? SideWord::left : SideWord::right;
      block.motion.side_column = block.code_column;
    } else if (is_one_of(code, motion_codes)) {
      motion_ = code;
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.motion.axes[axis].incremental = incremental_;
    block.pole[axis].incremental = incremental_;
  }
}

void HeidenhainIsoReader::run_tool(const Block& block) {
  ToolCall call = block.tool;
  call.plane = block.has(17)   ? std::optional(Plane::xy)
               : block.has(18) ? std::optional(Plane::zx)
               : block.has(19) ? std::optional(Plane::yz)
                               : std::nullopt;
  if (call.tool && block.motion.feed_word == FeedWord::value) {
    call.feed = block.motion.feed;
    call.feed_column = block.motion.feed_column;
  }
  call_tool(call);
}

MotionWords HeidenhainIsoReader::with_modal_rapid(MotionWords words) const {
  if (motion_ == 0 || motion_ == 10) {
    words.feed_word = FeedWord::rapid;
  }
  return words;
}

void HeidenhainIsoReader::run_motion(Block& block) {
  MotionWords& words = block.motion;
  if (block.pole[0].given || block.pole[1].given || block.pole[2].given) {
    MotionWords pole;
    pole.axes = block.pole;
    set_pole(pole);
  }
  if (is_polar(motion_)) {
    if (block.radius) {
      words.polar_radius = {to_mm(*block.radius), true, incremental_};
    }
    if (block.angle) {
      words.polar_angle = {units::from_deg(*block.angle), true, incremental_};
    }
  } else if (block.radius) {
    words.radius = to_mm(*block.radius);
  }
  const bool circles = (block.has(2) || block.has(3) || block.has(5)) && !block.radius;
  if (!words.has_axes() && !words.has_polar() && !circles) {
    run_functions(words);
    return;
  }
  if (motion_ < 0) {
    report(Severity::warning, "motion-mode", 0, words.first_column, [] {
      return Text{"coordinates before any of G0 to G16", "taken as G0; write the G word"};
    });
    motion_ = 0;
  }
  words = with_modal_rapid(words);
  words.turn = motion_ == 2 || motion_ == 12 ? -1 : motion_ == 3 || motion_ == 13 ? 1 : 0;
  words.first_column = words.first_column == 0 ? block.column : words.first_column;
  if (leaving_radius_) {
    words.radius = leaving_radius_;
    leaving_radius_.reset();
    run_departure(ApproachKind::line_and_arc, is_polar(motion_), words, block.column, leaving_feed_);
    return;
  }
  switch (motion_) {
    case 2:
    case 3:
    case 5:
      run_path(block.radius ? PathKind::radius_arc : PathKind::center_arc, words);
      break;
    case 6:
      run_path(PathKind::tangent_arc, words);
      break;
    case 10:
    case 11:
      run_path(PathKind::polar_line, words);
      break;
    case 12:
    case 13:
    case 15:
      run_path(PathKind::polar_arc, words);
      break;
    case 16:
      run_path(PathKind::polar_tangent_arc, words);
      break;
    default:
      run_path(PathKind::line, words);
      break;
  }
}

}  // namespace feedscope
