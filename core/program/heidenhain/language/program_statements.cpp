#include "core/program/heidenhain/language/program_statements.h"

#include <array>
#include <optional>
#include <utility>

#include "core/program/language/statement_table.h"

namespace feedscope::heidenhain {

namespace {

/// Reads the plane across the tool axis.
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

bool ProgramStatements::run(std::string_view name, Scanner& scanner, std::uint32_t column) {
  using P = ProgramStatements;
  static constexpr auto statements =
      std::to_array<StatementEntry<P, std::uint32_t>>({{"BEGIN", &P::begin},
                                                       {"END", &P::end},
                                                       {"BLK", &P::blank_form},
                                                       {"TOOL", &P::tool},
                                                       {"LBL", &P::label},
                                                       {"CALL", &P::call},
                                                       {"STOP", &P::stop},
                                                       {"FUNCTION", &P::function},
                                                       {"PRESET", &P::preset},
                                                       {"SEL", &P::select}});
  return run_statement(*this, statements, name, scanner, column);
}

void ProgramStatements::begin(Scanner& scanner, std::uint32_t /*column*/) {
  std::string_view rest = scanner.rest();
  rest = rest.substr(0, rest.find_last_not_of(" \t\r") + 1);
  const std::size_t last = rest.find_last_of(" \t");
  const std::string_view unit = last == std::string_view::npos ? rest : rest.substr(last + 1);
  if (letters::same(unit, "INCH") || letters::same(unit, "MM")) {
    parts_.context.set_inch(letters::same(unit, "INCH"));
  }
}

void ProgramStatements::end(Scanner& /*scanner*/, std::uint32_t /*column*/) {
  parts_.calls.end_of_program();
}

void ProgramStatements::blank_form(Scanner& scanner, std::uint32_t column) {
  scanner.take_keyword("FORM");
  const bool lower = scanner.take("0.1");
  if (!lower && !scanner.take("0.2")) {
    return;
  }
  take_tool_axis(scanner);
  const MotionWords words = words_.read(scanner);
  parts_.blank.set_corner(!lower, words.axes, column);
}

void ProgramStatements::tool(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("DEF")) {
    tool_definition(scanner);
  } else if (scanner.take_keyword("CALL")) {
    tool_call(scanner);
  } else {
    unsupported_.report_unknown(scanner.text(), column);
  }
}

void ProgramStatements::tool_definition(Scanner& scanner) {
  const std::optional<std::string> name = parts_.tools.read_name(scanner);
  if (!name) {
    throw_unread_words(scanner, Message::as_written("TOOL DEF"));
  }
  while (!scanner.at_end()) {
    if (scanner.take('L')) {
      read_value(scanner);
    } else if (scanner.take('R')) {
      parts_.tools.define(*name, read_length(scanner));
    } else {
      throw_unread_words(scanner, Message::as_written("TOOL DEF"));
    }
  }
}

void ProgramStatements::tool_call(Scanner& scanner) {
  ToolCall call;
  call.tool = parts_.tools.read_name(scanner);
  call.plane = take_tool_axis(scanner);
  while (!scanner.at_end()) {
    if (scanner.take('S')) {
      call.speed = read_value(scanner);
    } else if (const std::uint32_t column = scanner.column(); scanner.take('F')) {
      call.feed_column = column;
      call.feed_word = scanner.take('Z')   ? FeedWord::per_tooth
                       : scanner.take('U') ? FeedWord::per_revolution
                                           : FeedWord::value;
      call.feed = read_value(scanner);
    } else if (scanner.take("DL") || scanner.take("DR2")) {
      read_value(scanner);
    } else if (scanner.take("DR")) {
      call.radius_excess = read_length(scanner);
    } else {
      throw_unread_words(scanner, Message::as_written("TOOL CALL"));
    }
  }
  parts_.tools.call(call);
}

void ProgramStatements::label(Scanner& scanner, std::uint32_t /*column*/) {
  if (parts_.labels.read(scanner) == "0") {
    parts_.calls.end_subprogram();
  }
}

void ProgramStatements::call(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("LBL")) {
    const std::string name = parts_.labels.read(scanner);
    if (scanner.take("REP")) {
      parts_.calls.repeat_from_label(name, read_value(scanner), column);
    } else {
      parts_.calls.call_label(name, column);
    }
  } else if (scanner.take_keyword("PGM")) {
    parts_.calls.call_program(scanner.rest(), column);
  } else if (scanner.take_keyword("SELECTED") && scanner.take_keyword("PGM") && !selected_program_.empty()) {
    parts_.calls.call_program(selected_program_, column);
  } else {
    unsupported_.report_unknown(scanner.text(), column);
  }
}

void ProgramStatements::select(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("PGM")) {
    selected_program_ = scanner.rest();
  } else {
    unsupported_.report_known("SEL", column);
  }
}

void ProgramStatements::preset(Scanner& scanner, std::uint32_t column) {
  parts_.coordinates.set_preset(Message::as_written("PRESET"),
                                scanner.rest().find("KEEP TRANS") != std::string_view::npos, column);
}

void ProgramStatements::function(Scanner& scanner, std::uint32_t column) {
  Scanner rest = scanner;
  if (rest.take_keyword("RESET")) {
    modal_.tool_centre_point = modal_.tool_centre_point && !rest.take_keyword("TCPM");
    return;
  }
  if (machining_.other_axes.turns() && rest.take_keyword("TCPM")) {
    tool_centre_point(rest, column);
    return;
  }
  if (rest.take_keyword("DWELL")) {
    if (rest.take("TIME")) {
      parts_.dwells.run(read_value(rest), column);
      return;
    }
    if (rest.take("REV") && modal_.spindle_speed > 0) {
      parts_.dwells.run(read_value(rest) * 60 / modal_.spindle_speed, column);
      return;
    }
  } else if (rest.take_keyword("MODE")) {
    if (!rest.take_keyword("MILL")) {
      unsupported_.report_known("MODE", column);
    }
    return;
  }
  unsupported_.report_known("FUNCTION", column);
}

/// F TCP or F CONT, AXIS POS or SPAT, PATHCTRL AXIS or VECTOR, REFPNT ...: X, Y and Z are those of the tip.
void ProgramStatements::tool_centre_point(Scanner& scanner, std::uint32_t column) {
  modal_.tool_centre_point = true;
  const std::string_view words = scanner.rest();
  const auto has = [&](std::string_view word) { return words.find(word) != std::string_view::npos; };
  modal_.great_circle = has("PATHCTRL VECTOR");
  if (has("F CONT") || has("AXIS SPAT") || has("REFPNT TIP-CENTER") || has("REFPNT CENTER-CENTER")) {
    report(Severity::info, "unread-statement", 90, column, [] {
      return Text{NC_("core", "FUNCTION TCPM is followed as with F TCP, AXIS POS and REFPNT TIP-TIP"),
                  NC_("core", "F holds at the tip, and angles are those of the axes")};
    });
  }
}

void ProgramStatements::stop(Scanner& scanner, std::uint32_t column) {
  parts_.motions.run_functions(words_.read(scanner));
  end_contour(column);
  path().pause(Pause::stop);
}

}  // namespace feedscope::heidenhain
