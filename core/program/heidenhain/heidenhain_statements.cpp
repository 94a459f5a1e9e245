// The part of HeidenhainReader for statements that are no path blocks.
#include <fmt/format.h>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// The plane across the tool axis.
std::optional<Plane> take_tool_axis(Scanner& scanner) {
  for (const auto& [letter, plane] : {std::pair{'Z', Plane::xy}, {'Y', Plane::zx}, {'X', Plane::yz}}) {
    if (letters::to_upper(scanner.peek()) == letter &&
        (scanner.peek_at(1) == '\0' || letters::is_blank(scanner.peek_at(1)))) {
      scanner.take(letter);
      return plane;
    }
  }
  return std::nullopt;
}

}  // namespace

void HeidenhainReader::begin(Scanner& scanner, std::uint32_t) {
  std::string_view rest = scanner.rest();
  rest = rest.substr(0, rest.find_last_not_of(" \t\r") + 1);
  const std::size_t last = rest.find_last_of(" \t");
  const std::string_view unit = last == std::string_view::npos ? rest : rest.substr(last + 1);
  if (letters::same(unit, "INCH") || letters::same(unit, "MM")) {
    set_inch(letters::same(unit, "INCH"));
  }
}

void HeidenhainReader::end(Scanner&, std::uint32_t) {
  end_of_program();
}

void HeidenhainReader::blank_form(Scanner& scanner, std::uint32_t column) {
  scanner.take_keyword("FORM");
  const bool lower = scanner.take("0.1");
  if (!lower && !scanner.take("0.2")) {
    return;
  }
  take_tool_axis(scanner);
  const MotionWords words = this->words(scanner);
  set_blank_corner(!lower, words.axes, column);
}

void HeidenhainReader::tool(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("DEF")) {
    tool_definition(scanner);
  } else if (scanner.take_keyword("CALL")) {
    tool_call(scanner);
  } else {
    report_unknown(scanner.text(), column);
  }
}

void HeidenhainReader::tool_definition(Scanner& scanner) {
  const std::optional<std::string> name = tool_name(scanner);
  if (!name) {
    throw_unread_words(scanner, "TOOL DEF");
  }
  while (!scanner.at_end()) {
    if (scanner.take('L')) {
      formulas().read_value(scanner);
    } else if (scanner.take('R')) {
      define_tool(*name, to_mm(formulas().read_value(scanner)));
    } else {
      throw_unread_words(scanner, "TOOL DEF");
    }
  }
}

void HeidenhainReader::tool_call(Scanner& scanner) {
  ToolCall call;
  call.tool = tool_name(scanner);
  call.plane = take_tool_axis(scanner);
  while (!scanner.at_end()) {
    if (scanner.take('S')) {
      call.speed = formulas().read_value(scanner);
    } else if (const std::uint32_t column = scanner.column(); scanner.take('F')) {
      call.feed_column = column;
      call.feed_word = scanner.take('Z')   ? FeedWord::per_tooth
                       : scanner.take('U') ? FeedWord::per_revolution
                                           : FeedWord::value;
      call.feed = formulas().read_value(scanner);
    } else if (scanner.take("DL") || scanner.take("DR2")) {
      formulas().read_value(scanner);
    } else if (scanner.take("DR")) {
      call.radius_excess = to_mm(formulas().read_value(scanner));
    } else {
      throw_unread_words(scanner, "TOOL CALL");
    }
  }
  call_tool(call);
}

void HeidenhainReader::label_statement(Scanner& scanner, std::uint32_t) {
  if (label(scanner) == "0") {
    end_subprogram();
  }
}

void HeidenhainReader::call_statement(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("LBL")) {
    const std::string name = label(scanner);
    if (scanner.take("REP")) {
      repeat_from_label(name, formulas().read_value(scanner), column);
    } else {
      call_label(name, column);
    }
  } else if (scanner.take_keyword("PGM")) {
    call_program(scanner.rest(), column);
  } else if (scanner.take_keyword("SELECTED") && scanner.take_keyword("PGM") && !selected_program_.empty()) {
    call_program(selected_program_, column);
  } else {
    report_unknown(scanner.text(), column);
  }
}

void HeidenhainReader::select(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("PGM")) {
    selected_program_ = scanner.rest();
  } else {
    report_unread("SEL", scanner.text(), column);
  }
}

void HeidenhainReader::global_definition(Scanner& scanner, std::uint32_t column) {
  if (!scanner.take_keyword("DEF")) {
    report_unknown(scanner.text(), column);
    return;
  }
  scanner.skip_digits();
  predefine(scanner);
}

void HeidenhainReader::preset(Scanner& scanner, std::uint32_t column) {
  set_preset("PRESET", scanner.rest().find("KEEP TRANS") != std::string_view::npos, column);
}

void HeidenhainReader::function_statement(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("RESET")) {
    return;
  }
  Scanner rest = scanner;
  if (rest.take_keyword("DWELL")) {
    if (rest.take("TIME")) {
      dwell(formulas().read_value(rest), column);
      return;
    }
    if (rest.take("REV") && spindle_speed() > 0) {
      dwell(formulas().read_value(rest) * 60 / spindle_speed(), column);
      return;
    }
  } else if (rest.take_keyword("MODE")) {
    if (!rest.take_keyword("MILL")) {
      report_unread("MODE", scanner.text(), column);
    }
    return;
  }
  report_unread("FUNCTION", scanner.text(), column);
}

void HeidenhainReader::stop(Scanner& scanner, std::uint32_t column) {
  run_functions(words(scanner));
  end_contour(column);
  stop_program();
}

void HeidenhainReader::declaration(Scanner& scanner, std::uint32_t) {
  scanner.take_keyword("STRING");
  assign(scanner);
}

void HeidenhainReader::function(Scanner& scanner, std::uint32_t column) {
  constexpr int system_read = 18;
  constexpr int angle = 13;
  const std::optional<double> number = scanner.number();
  if (!number || *number > 99) {
    throw_unread_words(scanner, "FN");
  }
  FunctionCall call;
  call.number = static_cast<int>(*number);
  call.column = column;
  scanner.take(':');
  if (call.number >= 9 && call.number <= 12) {
    jump_condition(scanner, call);
  } else if (call.number == system_read) {
    read_system_data(scanner, column);
    return;
  } else if (call.number <= 8 || call.number == angle) {
    arithmetic(scanner, call);
  }
  run_function(call);
}

void HeidenhainReader::arithmetic(Scanner& scanner, FunctionCall& call) {
  call.result = take_parameter(scanner);
  if (!call.result || call.result->kind == QName::Kind::text || !scanner.take('=')) {
    throw_unread_words(scanner, "FN");
  }
  constexpr std::array<std::string_view, 3> of_one{"SQRT", "SIN", "COS"};
  if (call.number >= 5 && call.number <= 7) {
    scanner.take_keyword(of_one[static_cast<std::size_t>(call.number - 5)]);
  }
  call.values[0] = formulas().read_value(scanner);
  constexpr std::array<std::string_view, 5> of_two{"+", "-", "*", "DIV", "LEN"};
  const std::string_view sign = call.number == 13                      ? "ANG"
                                : call.number >= 1 && call.number <= 4 ? of_two[call.number - 1U]
                                : call.number == 8                     ? of_two[4]
                                                                       : "";
  if (sign.empty()) {
    return;
  }
  if (!scanner.take(sign) && !(call.number == 4 && scanner.take('/'))) {
    throw_unread_words(scanner, "FN");
  }
  call.values[1] = formulas().read_value(scanner);
}

bool HeidenhainReader::definition_condition(Scanner& scanner, FunctionCall& call) {
  Scanner ahead = scanner;
  ahead.take('+');
  const std::optional<QName> name = take_parameter(ahead);
  if (!name || !ahead.take_keyword("IS")) {
    return false;
  }
  const bool undefined = ahead.take_keyword("UNDEFINED");
  if (!undefined && !ahead.take_keyword("DEFINED")) {
    throw_unread_words(ahead, "FN");
  }
  const bool is_defined = name->kind == QName::Kind::text ? !parameters().text(name->number).empty()
                                                          : parameters().get(*name).has_value();
  call.number = 9;
  call.values = {is_defined == undefined ? 1.0 : 0.0, 0.0};
  scanner = ahead;
  return true;
}

void HeidenhainReader::jump_condition(Scanner& scanner, FunctionCall& call) {
  constexpr std::array<std::string_view, 4> relations{"EQU", "NE", "GT", "LT"};
  scanner.take("IF");
  if (!definition_condition(scanner, call)) {
    call.values[0] = formulas().read_value(scanner);
    if (!scanner.take(relations[static_cast<std::size_t>(call.number - 9)])) {
      throw_unread_words(scanner, "FN");
    }
    call.values[1] = formulas().read_value(scanner);
  }
  if (!scanner.take("GOTO")) {
    throw_unread_words(scanner, "FN");
  }
  scanner.take("LBL");
  call.label = label(scanner);
}

void HeidenhainReader::transformation(Scanner& scanner, std::uint32_t column) {
  const std::string_view name = scanner.name();
  const bool resets = Scanner(scanner).take_keyword("RESET");
  using Kind = Transformations::Kind;
  if (letters::same(name, "DATUM")) {
    if (resets) {
      transformations().reset(Kind::shift);
    } else {
      scanner.take_keyword("AXIS");
      datum_shift(scanner, column);
    }
  } else if (letters::same(name, "MIRROR")) {
    if (resets) {
      transformations().reset(Kind::mirror);
    } else {
      scanner.take_keyword("AXIS");
      mirror(scanner, column);
    }
  } else if (letters::same(name, "ROTATION")) {
    if (resets) {
      transformations().reset(Kind::rotation);
    } else {
      rotation(scanner, column);
    }
  } else if (letters::same(name, "SCALE")) {
    if (resets) {
      transformations().reset(Kind::scale);
    } else {
      scaling(scanner, column);
    }
  } else {
    throw_unread_words(scanner, "TRANS");
  }
  apply_transformations(column);
}

}  // namespace feedscope
