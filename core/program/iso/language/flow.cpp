#include "core/program/iso/language/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/program/iso/language/statements.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::iso {

namespace {

bool only_number_before(const Block& block) {
  return std::all_of(block.words.begin(), block.words.end(),
                     [](const Word& word) { return word.letter == 'N'; });
}

Message partner(FlowWord word) {
  switch (word) {
    case FlowWord::sub:
      return Message::as_written("endsub");
    case FlowWord::endsub:
      return Message::as_written("sub");
    case FlowWord::if_:
      return Message::as_written("endif");
    case FlowWord::elseif:
    case FlowWord::else_:
    case FlowWord::endif:
      return Message::as_written("if");
    case FlowWord::while_:
      return Message::as_written("endwhile");
    case FlowWord::endwhile:
      return Message::as_written("while");
    case FlowWord::repeat:
      return Message::as_written("endrepeat");
    case FlowWord::endrepeat:
      return Message::as_written("repeat");
    case FlowWord::break_:
    case FlowWord::continue_:
      return NC_("core", "loop around it");
    case FlowWord::macro_do:
      return NC_("core", "END with its number");
    case FlowWord::macro_end:
      return NC_("core", "DO with its number");
    case FlowWord::do_:
      return Message::as_written("while");
    case FlowWord::none:
    case FlowWord::call:
    case FlowWord::return_:
      break;
  }
  return {};
}

bool is_paired(const FlowIndex::Statement& statement) {
  switch (statement.word) {
    case FlowWord::sub:
    case FlowWord::if_:
    case FlowWord::do_:
    case FlowWord::repeat:
    case FlowWord::macro_do:
      return statement.end > 0;
    case FlowWord::while_:
      return statement.begin > 0 || statement.end > 0;
    case FlowWord::endsub:
    case FlowWord::elseif:
    case FlowWord::else_:
    case FlowWord::endif:
    case FlowWord::endwhile:
    case FlowWord::endrepeat:
    case FlowWord::break_:
    case FlowWord::continue_:
    case FlowWord::macro_end:
      return statement.begin > 0;
    case FlowWord::none:
    case FlowWord::call:
    case FlowWord::return_:
      break;
  }
  return true;
}

}  // namespace

bool Flow::run(const Block& line, Scanner& scan) {
  const bool flows = run_o_word(line, scan) || (only_number_before(line) && run_macro_statement(scan));
  if (flows) {
    report_rest(scan);
  }
  return flows;
}

void Flow::report_rest(Scanner& scan) const {
  if (scan.at_end() || scan.peek() == '%') {
    return;
  }
  report(Severity::error, "unread-statement", 1, scan.column(), [&] {
    return Text{message(NC_("core", "{} follows a statement"), in_quotes(scan.rest())),
                NC_("core", "it is skipped; write it in a line of its own")};
  });
  skip_rest(scan);
}

bool Flow::run_o_word(const Block& line, Scanner& scan) {
  std::string label;
  std::uint32_t column = scan.column();
  const bool plain_label = !line.words.empty() && line.words.back().letter == 'O';
  if (plain_label) {
    column = line.words.back().column;
    Scanner at_label(scan.text(), column);
    label = take_o_label(at_label);
  } else {
    Scanner after = scan;
    if (!only_number_before(line) || !after.take('O') ||
        std::string_view("<#[").find(after.peek()) == std::string_view::npos) {
      return false;
    }
    scan = after;
    label = take_o_label(scan);
    if (label.empty()) {
      label = fmt::format("{:.0f}", expression_.read_operand(scan));
    }
  }
  Scanner after = scan;
  const FlowWord word = o_word_named(after.name());
  if (word == FlowWord::none) {
    throw ReadFault{
        "unread-statement", column,
        message(NC_("core", "{} is not an O word"), in_quotes(scan.text().substr(column - 1))),
        NC_("core", "the line is skipped; O words are sub, call, if, while, do, repeat and their ends")};
  }
  scan = after;
  run_o_word(word, label, column, scan);
  return true;
}

void Flow::run_o_word(FlowWord word, const std::string& label, std::uint32_t column, Scanner& scan) {
  if (word == FlowWord::call) {
    call(label, column, scan);
    return;
  }
  if (word == FlowWord::return_) {
    return_from_sub(scan);
    return;
  }
  const std::string_view written = scan.text().substr(column - 1, scan.at() + 1 - column);
  const Statement& statement = paired_statement(written, partner(word), column);
  switch (word) {
    case FlowWord::sub:
      report_nested_subs(statement);
      lines().jump_to(statement.end + 1);
      break;
    case FlowWord::endsub:
      return_from_sub(scan);
      break;
    case FlowWord::if_:
      begin_branch(condition(scan), statement);
      break;
    case FlowWord::elseif:
    case FlowWord::else_:
      if (std::exchange(tested_branch_, 0) != lines().line()) {
        skip_rest(scan);
        lines().jump_to(index().at(statement.begin)->end + 1);
      } else if (word == FlowWord::elseif) {
        begin_branch(condition(scan), statement);
      }
      break;
    case FlowWord::while_:
      if (statement.begin == 0) {
        begin_loop(condition(scan), statement);
      } else if (condition(scan)) {
        lines().jump_to(statement.begin);
      }
      break;
    case FlowWord::endwhile:
      lines().jump_to(statement.begin);
      break;
    case FlowWord::repeat:
      begin_repeat(scan, statement);
      break;
    case FlowWord::endrepeat:
      end_repeat(statement);
      break;
    case FlowWord::break_:
    case FlowWord::continue_:
      leave_loop(word == FlowWord::break_, *index().at(statement.begin));
      break;
    case FlowWord::endif:
      tested_branch_ = 0;
      break;
    case FlowWord::do_:
    case FlowWord::call:
    case FlowWord::return_:
    case FlowWord::macro_do:
    case FlowWord::macro_end:
    case FlowWord::none:
      break;
  }
}

void Flow::call(const std::string& label, std::uint32_t column, Scanner& scan) {
  constexpr std::size_t max_arguments = 30;
  std::vector<double> arguments;
  while (!scan.at_end()) {
    const std::uint32_t argument_column = scan.column();
    const double value = expression_.read_operand(scan);
    if (arguments.size() == max_arguments) {
      throw ReadFault{"expression", argument_column, NC_("core", "a call has more than 30 arguments"),
                      NC_("core", "the call is skipped; pass the rest in global variables")};
    }
    arguments.push_back(value);
  }
  calls_.call_sub(label, column, arguments);
}

void Flow::return_from_sub(Scanner& scan) {
  const bool returns_value = !scan.at_end();
  const double value = returns_value ? expression_.read_operand(scan) : 0;
  if (lines().call_depth() == 0) {
    throw ReadFault{"flow-pair", scan.column(), NC_("core", "return or endsub outside a subprogram"),
                    NC_("core", "it is skipped; a subprogram is written between sub and endsub")};
  }
  report_rest(scan);
  calls_.leave();
  variables_.set("_value", value);
  variables_.set("_value_returned", returns_value ? 1 : 0);
}

void Flow::report_nested_subs(const Statement& statement) const {
  for (const std::uint32_t inner : indexes_.of(lines().text()).subs_within(statement)) {
    DiagnosticLog::Place there = lines().place(0);
    there.line = inner;
    machining_.log.add(Severity::error, "flow-pair", 1, there, [&] {
      return Text{message(NC_("core", "a sub inside the sub of line {}"), statement.line),
                  NC_("core", "LinuxCNC rejects the program; write one subprogram after the other")};
    });
  }
}

void Flow::begin_branch(bool holds, const Statement& statement) {
  if (!holds) {
    tested_branch_ = statement.next;
    lines().jump_to(statement.next);
  }
}

void Flow::begin_loop(bool holds, const Statement& statement) {
  if (!holds) {
    lines().jump_to(statement.end + 1);
  }
}

void Flow::begin_repeat(Scanner& scan, const Statement& statement) {
  const double times = std::round(expression_.read_operand(scan));
  std::vector<Calls::Repeat>& repeats = calls_.repeats();
  std::erase_if(repeats, [&](const Calls::Repeat& repeat) { return repeat.line == statement.line; });
  if (times >= 1) {
    repeats.push_back({statement.line, times});
  } else {
    lines().jump_to(statement.end + 1);
  }
}

void Flow::end_repeat(const Statement& statement) {
  std::vector<Calls::Repeat>& repeats = calls_.repeats();
  const auto running = std::find_if(repeats.begin(), repeats.end(), [&](const Calls::Repeat& repeat) {
    return repeat.line == statement.begin;
  });
  if (running == repeats.end()) {
    return;
  }
  if (--running->left >= 1) {
    lines().jump_to(statement.begin + 1);
  } else {
    repeats.erase(running);
  }
}

void Flow::leave_loop(bool for_good, const Statement& loop) {
  if (for_good) {
    std::erase_if(calls_.repeats(), [&](const Calls::Repeat& repeat) { return repeat.line == loop.line; });
    lines().jump_to(loop.end + 1);
  } else {
    lines().jump_to(loop.word == FlowWord::while_ ? loop.line : loop.end);
  }
}

bool Flow::condition(Scanner& scan) {
  try {
    const double value = expression_.read(scan);
    return !is_null(value) && value != 0;
  } catch (const ReadFault& fault) {
    // Treated as false, so that a loop ends.
    machining_.report(fault);
    skip_rest(scan);
    return false;
  }
}

const FlowIndex::Statement& Flow::paired_statement(std::string_view written, const Message& missing,
                                                   std::uint32_t column) {
  const Statement* const found = index().at(lines().line());
  if (found == nullptr || !is_paired(*found)) {
    throw ReadFault{"flow-pair", column, message(NC_("core", "{} has no {}"), in_quotes(written), missing),
                    NC_("core", "it is skipped; check the labels")};
  }
  return *found;
}

bool Flow::run_macro_statement(Scanner& scan) {
  if (run_macro_branch(scan) || run_macro_loop(scan)) {
    return true;
  }
  if (scan.take_keyword("IF")) {
    run_macro_if(scan);
    return true;
  }
  if (take_macro_word(scan, "GOTO")) {
    go_to(scan);
    return true;
  }
  return run_output(scan);
}

bool Flow::run_macro_loop(Scanner& scan) {
  const std::uint32_t column = scan.column();
  const std::string_view written = scan.text().substr(std::min<std::size_t>(column - 1, scan.text().size()));
  const bool is_while = take_macro_word(scan, "WHILE");
  const bool begins = is_while || scan.take_keyword("DO");
  if (!begins && !take_macro_word(scan, "END")) {
    return false;
  }
  const Statement& statement =
      paired_statement(written, partner(begins ? FlowWord::macro_do : FlowWord::macro_end), column);
  if (statement.word == FlowWord::macro_end) {
    lines().jump_to(statement.begin);
    scan.number();
    return true;
  }
  const bool holds = !is_while || condition(scan);
  if (is_while) {
    begin_loop(holds, statement);
    scan.take_keyword("DO");
  }
  scan.number();
  // Everything after DO in the line belongs to the loop.
  if (!holds) {
    skip_rest(scan);
  } else if (scan.take_keyword("IF")) {
    run_macro_if(scan);
  } else if (take_macro_word(scan, "GOTO")) {
    go_to(scan);
  } else if (!scan.at_end() && scan.peek() != '%') {
    run_words_(scan);
  }
  return true;
}

bool Flow::run_output(Scanner& scan) {
  constexpr auto printing = std::to_array<std::string_view>({"POPEN", "PCLOS", "DPRNT", "BPRNT"});
  const std::uint32_t column = scan.column();
  for (const std::string_view name : printing) {
    if (scan.take_name(name)) {
      skip_rest(scan);
      report(Severity::info, "output-statement", 0, column, [&] {
        return Text{message(NC_("core", "{} writes to a device"), name),
                    NC_("core", "it does not change the path")};
      });
      return true;
    }
  }
  return false;
}

/// ELSEIF, ELSE, ENDIF of an IF over many lines.
bool Flow::run_macro_branch(Scanner& scan) {
  if (is_linuxcnc()) {
    return false;
  }
  const std::uint32_t column = scan.column();
  for (const FlowWord word : {FlowWord::elseif, FlowWord::else_, FlowWord::endif}) {
    const std::string_view name = word == FlowWord::elseif  ? "ELSEIF"
                                  : word == FlowWord::else_ ? "ELSE"
                                                            : "ENDIF";
    if (scan.take_keyword(name)) {
      run_o_word(word, "", column, scan);
      take_macro_word(scan, "THEN");
      return true;
    }
  }
  return false;
}

void Flow::run_macro_if(Scanner& scan) {
  const bool holds = condition(scan);
  const std::uint32_t column = scan.column();
  const bool then = take_macro_word(scan, "THEN");
  if (then && scan.at_end()) {
    begin_branch(holds, paired_statement("IF", Message::as_written("ENDIF"), column));
    return;
  }
  const bool go = take_macro_word(scan, "GOTO");
  if (!then && !go) {
    throw ReadFault{"expression", scan.column(), NC_("core", "GOTO or THEN is missing after the condition"),
                    NC_("core", "the line is skipped; complete it")};
  }
  if (holds) {
    go ? go_to(scan) : run_words_(scan);
  } else {
    skip_rest(scan);
  }
}

void Flow::go_to(Scanner& scan) {
  const std::uint32_t column = scan.column();
  const double number = expression_.read(scan);
  const bool valid = number >= 1 && number <= 999999999 && number == std::floor(number);
  const std::uint32_t target =
      valid ? index().block(static_cast<std::uint32_t>(number), lines().line() + 1) : 0;
  if (target == 0) {
    throw ReadFault{"jump-target", column, message(NC_("core", "jump target N{} does not exist"), number),
                    NC_("core", "the jump is skipped; correct the number")};
  }
  lines().jump_to(target);
}

}  // namespace feedscope::iso
