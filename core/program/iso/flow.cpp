// The part of IsoReader that jumps: O words of LinuxCNC, macro statements of Fanuc.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr std::string_view left_out = "it is left out; check the labels";

bool only_number_before(const Block& block) {
  return std::all_of(block.words.begin(), block.words.end(),
                     [](const Word& word) { return word.letter == 'N'; });
}

[[noreturn]] void throw_unpaired(std::string_view statement, std::string_view missing, std::uint32_t column) {
  throw ReadFault{"flow-pair", column, fmt::format("{} has no {}", quoted(statement), missing),
                  std::string(left_out)};
}

std::string_view partner(FlowWord word) {
  switch (word) {
    case FlowWord::sub:
      return "endsub";
    case FlowWord::endsub:
      return "sub";
    case FlowWord::if_:
      return "endif";
    case FlowWord::elseif:
    case FlowWord::else_:
    case FlowWord::endif:
      return "if";
    case FlowWord::while_:
      return "endwhile";
    case FlowWord::endwhile:
      return "while";
    case FlowWord::repeat:
      return "endrepeat";
    case FlowWord::endrepeat:
      return "repeat";
    case FlowWord::break_:
    case FlowWord::continue_:
      return "loop around it";
    case FlowWord::macro_do:
      return "END with its number";
    case FlowWord::macro_end:
      return "DO with its number";
    case FlowWord::do_:
      return "while";
    case FlowWord::none:
    case FlowWord::call:
    case FlowWord::return_:
      break;
  }
  return "";
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

const FlowIndex& IsoReader::flow_index(const SourceText& text) {
  const auto found = flow_.find(&text);
  return found != flow_.end()
             ? found->second
             : flow_.emplace(&text, FlowIndex(text, options().skip_deleted_blocks)).first->second;
}

bool IsoReader::run_flow(const Block& block, Scanner& scan) {
  const bool flows = run_o_word(block, scan) || (only_number_before(block) && run_macro_statement(scan));
  if (flows) {
    report_rest(scan);
  }
  return flows;
}

void IsoReader::report_rest(Scanner& scan) {
  if (scan.at_end() || scan.peek() == '%') {
    return;
  }
  report(Severity::error, "unread-statement", 1, scan.column(), [&] {
    return Text{fmt::format("{} follows a statement", quoted(scan.rest())),
                "it is skipped; write it in a line of its own"};
  });
  leave_line(scan);
}

bool IsoReader::run_o_word(const Block& block, Scanner& scan) {
  std::string label;
  std::uint32_t column = scan.column();
  const bool plain_label = !block.words.empty() && block.words.back().letter == 'O';
  if (plain_label) {
    column = block.words.back().column;
    Scanner at_label(scan.text(), column);
    label = take_o_label(at_label);
  } else {
    Scanner after = scan;
    if (!only_number_before(block) || !after.take('O') ||
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
    throw ReadFault{"unread-statement", column,
                    fmt::format("{} is no O word", quoted(scan.text().substr(column - 1))),
                    "the line is left out; O words are sub, call, if, while, do, repeat and their ends"};
  }
  scan = after;
  run_o_word(word, label, column, scan);
  return true;
}

void IsoReader::run_o_word(FlowWord word, const std::string& label, std::uint32_t column, Scanner& scan) {
  if (word == FlowWord::call) {
    call_o_word(label, column, scan);
    return;
  }
  if (word == FlowWord::return_) {
    return_from_o_word(scan);
    return;
  }
  const FlowIndex::Statement* const found = flow_index(text()).at(line());
  if (found == nullptr || !is_paired(*found)) {
    throw_unpaired(scan.text().substr(column - 1, scan.at() + 1 - column), partner(word), column);
  }
  const FlowIndex::Statement& statement = *found;
  switch (word) {
    case FlowWord::sub:
      report_nested_subs(statement);
      jump_to(statement.end + 1);
      break;
    case FlowWord::endsub:
      return_from_o_word(scan);
      break;
    case FlowWord::if_:
      begin_branch(condition(scan), statement);
      break;
    case FlowWord::elseif:
    case FlowWord::else_:
      if (std::exchange(tested_branch_, 0) != line()) {
        leave_line(scan);
        jump_to(flow_index(text()).at(statement.begin)->end + 1);
      } else if (word == FlowWord::elseif) {
        begin_branch(condition(scan), statement);
      }
      break;
    case FlowWord::while_:
      if (statement.begin == 0) {
        begin_loop(condition(scan), statement);
      } else if (condition(scan)) {
        jump_to(statement.begin);
      }
      break;
    case FlowWord::endwhile:
      jump_to(statement.begin);
      break;
    case FlowWord::repeat:
      begin_repeat(scan, statement);
      break;
    case FlowWord::endrepeat:
      end_repeat(statement);
      break;
    case FlowWord::break_:
    case FlowWord::continue_:
      leave_loop(word == FlowWord::break_, *flow_index(text()).at(statement.begin));
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

void IsoReader::report_nested_subs(const FlowIndex::Statement& statement) {
  for (const std::uint32_t inner : flow_index(text()).subs_within(statement)) {
    DiagnosticLog::Place there = place(0);
    there.line = inner;
    log().add(Severity::error, "flow-pair", 1, there, [&] {
      return Text{fmt::format("a sub within the sub of line {}", statement.line),
                  "LinuxCNC rejects the program; write one subprogram after the other"};
    });
  }
}

void IsoReader::begin_branch(bool holds, const FlowIndex::Statement& statement) {
  if (!holds) {
    tested_branch_ = statement.next;
    jump_to(statement.next);
  }
}

void IsoReader::begin_loop(bool holds, const FlowIndex::Statement& statement) {
  if (!holds) {
    jump_to(statement.end + 1);
  }
}

void IsoReader::begin_repeat(Scanner& scan, const FlowIndex::Statement& statement) {
  const double times = std::round(expression_.read_operand(scan));
  std::vector<Repeat>& repeats = frames_.back().repeats;
  std::erase_if(repeats, [&](const Repeat& repeat) { return repeat.line == statement.line; });
  if (times >= 1) {
    repeats.push_back({statement.line, times});
  } else {
    jump_to(statement.end + 1);
  }
}

void IsoReader::end_repeat(const FlowIndex::Statement& statement) {
  std::vector<Repeat>& repeats = frames_.back().repeats;
  const auto running = std::find_if(repeats.begin(), repeats.end(),
                                    [&](const Repeat& repeat) { return repeat.line == statement.begin; });
  if (running == repeats.end()) {
    return;
  }
  if (--running->left >= 1) {
    jump_to(statement.begin + 1);
  } else {
    repeats.erase(running);
  }
}

void IsoReader::leave_loop(bool for_good, const FlowIndex::Statement& loop) {
  if (for_good) {
    std::erase_if(frames_.back().repeats, [&](const Repeat& repeat) { return repeat.line == loop.line; });
    jump_to(loop.end + 1);
  } else {
    jump_to(loop.word == FlowWord::while_ ? loop.line : loop.end);
  }
}

void IsoReader::leave_line(Scanner& scan) {
  scan.move_to(scan.text().size());
}

bool IsoReader::condition(Scanner& scan) {
  try {
    const double value = expression_.read(scan);
    return !is_null(value) && value != 0;
  } catch (const ReadFault& fault) {
    // Taken as not fulfilled, so that a loop ends.
    report_fault(fault);
    leave_line(scan);
    return false;
  }
}

bool IsoReader::run_macro_statement(Scanner& scan) {
  const std::uint32_t column = scan.column();
  if (run_branch_statement(scan)) {
    return true;
  }
  const bool is_while = take_macro_word(scan, "WHILE");
  if (is_while || scan.take_keyword("DO") || take_macro_word(scan, "END")) {
    const FlowIndex::Statement* const statement = flow_index(text()).at(line());
    if (statement == nullptr || !is_paired(*statement)) {
      const bool ends = statement != nullptr && statement->word == FlowWord::macro_end;
      throw_unpaired(scan.text().substr(column - 1), partner(ends ? FlowWord::macro_end : FlowWord::macro_do),
                     column);
    }
    if (statement->word == FlowWord::macro_end) {
      jump_to(statement->begin);
      scan.number();
      return true;
    }
    const bool holds = !is_while || condition(scan);
    if (is_while) {
      begin_loop(holds, *statement);
      scan.take_keyword("DO");
    }
    scan.number();
    // What the line holds behind DO belongs to the loop.
    if (!holds) {
      leave_line(scan);
    } else if (scan.take_keyword("IF")) {
      run_if(scan);
    } else if (take_macro_word(scan, "GOTO")) {
      go_to(scan);
    } else if (!scan.at_end() && scan.peek() != '%') {
      run_items(scan);
    }
    return true;
  }
  if (scan.take_keyword("IF")) {
    run_if(scan);
    return true;
  }
  if (take_macro_word(scan, "GOTO")) {
    go_to(scan);
    return true;
  }
  constexpr auto printing = std::to_array<std::string_view>({"POPEN", "PCLOS", "DPRNT", "BPRNT"});
  for (const std::string_view name : printing) {
    if (scan.take_name(name)) {
      leave_line(scan);
      report(Severity::info, "output-statement", 0, column, [&] {
        return Text{fmt::format("{} writes to a device", name), "it does not change the path"};
      });
      return true;
    }
  }
  return false;
}

/// ELSEIF, ELSE, ENDIF of an IF over many lines.
bool IsoReader::run_branch_statement(Scanner& scan) {
  if (follows_linuxcnc(dialect_)) {
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

void IsoReader::run_if(Scanner& scan) {
  const bool holds = condition(scan);
  const std::uint32_t column = scan.column();
  const bool then = take_macro_word(scan, "THEN");
  if (then && scan.at_end()) {
    const FlowIndex::Statement* const statement = flow_index(text()).at(line());
    if (statement == nullptr || !is_paired(*statement)) {
      throw_unpaired("IF", "ENDIF", column);
    }
    begin_branch(holds, *statement);
    return;
  }
  const bool go = take_macro_word(scan, "GOTO");
  if (!then && !go) {
    throw ReadFault{"expression", scan.column(), "GOTO or THEN is missing after the condition",
                    "the line is left out; complete it"};
  }
  if (holds) {
    go ? go_to(scan) : run_items(scan);
  } else {
    leave_line(scan);
  }
}

void IsoReader::go_to(Scanner& scan) {
  const std::uint32_t column = scan.column();
  const double number = expression_.read(scan);
  const bool valid = number >= 1 && number <= 999999999 && number == std::floor(number);
  const std::uint32_t target =
      valid ? flow_index(text()).block(static_cast<std::uint32_t>(number), line() + 1) : 0;
  if (target == 0) {
    throw ReadFault{"jump-target", column, fmt::format("there is no block N{} to go to", number),
                    "the jump is left out; correct the number"};
  }
  jump_to(target);
}

}  // namespace feedscope
