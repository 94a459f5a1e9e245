// The part of SinumerikReader that decides which line comes next.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/program/sinumerik/names.h"
#include "core/program/sinumerik/sinumerik_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

using namespace sinumerik;

namespace {

constexpr double most_runs = 1e6;

void skip_rest(Scanner& scanner) {
  scanner.move_to(scanner.text().size());
}

}  // namespace

SinumerikReader::Run SinumerikReader::find_statement(std::string_view name) {
  using R = SinumerikReader;
  constexpr auto statements = std::to_array<std::pair<std::string_view, Run>>({
      {"IF", &R::run_if},
      {"ELSE", &R::run_else},
      {"ENDIF", &R::run_endif},
      {"FOR", &R::run_for},
      {"ENDFOR", &R::run_endfor},
      {"WHILE", &R::run_while},
      {"LOOP", &R::run_loop},
      {"ENDWHILE", &R::run_end_of_loop},
      {"ENDLOOP", &R::run_end_of_loop},
      {"REPEAT", &R::run_repeat},
      {"REPEATB", &R::run_repeatb},
      {"UNTIL", &R::run_until},
      {"CASE", &R::run_case},
      {"GOTO", &R::run_goto},
      {"GOTOF", &R::run_gotof},
      {"GOTOB", &R::run_gotob},
      {"GOTOC", &R::run_gotoc},
      {"GOTOS", &R::run_gotos},
      {"DEF", &R::run_def},
      {"PROC", &R::run_proc},
      {"EXTERN", &R::run_extern},
      {"DEFINE", &R::run_define},
      {"RET", &R::run_ret},
      {"CALL", &R::run_call},
      {"PCALL", &R::run_call},
      {"EXTCALL", &R::run_extcall},
      {"ISOCALL", &R::run_isocall},
      {"MCALL", &R::run_mcall},
      {"PO", &R::run_polynomial},
      {"POS", &R::run_pos},
      {"POSA", &R::run_pos},
      {"FA", &R::run_axis_feed},
      {"WHEN", &R::run_synchronized},
      {"WHENEVER", &R::run_synchronized},
      {"EVERY", &R::run_synchronized},
      {"FROM", &R::run_synchronized},
      {"DO", &R::run_synchronized},
      {"ID", &R::run_synchronized},
      {"IDS", &R::run_synchronized},
  });
  const auto found = std::find_if(statements.begin(), statements.end(),
                                  [&](const auto& entry) { return letters::same(entry.first, name); });
  return found == statements.end() ? nullptr : found->second;
}

const ProgramIndex& SinumerikReader::index_of(const SourceText& text) {
  std::unique_ptr<ProgramIndex>& index = indices_[&text];
  if (index == nullptr) {
    index = std::make_unique<ProgramIndex>(text);
  }
  return *index;
}

ProgramIndex::Structure SinumerikReader::structure(Scanner& scanner, std::string_view word) {
  const ProgramIndex::Structure found = index().structure(line());
  if (found.end == 0) {
    throw ReadFault{"control-structure", scanner.column(), fmt::format("{} has no counterpart", word),
                    "the line is left out; check IF, ELSE, ENDIF and the beginnings and ends of loops"};
  }
  return found;
}

void SinumerikReader::run_if(Scanner& scanner) {
  const bool condition = values_.read(scanner) != 0;
  if (!scanner.at_end()) {
    if (!jump_if(scanner, condition)) {
      throw ReadFault{"syntax", scanner.column(),
                      fmt::format("{} stands behind a condition", quoted(scanner.rest())),
                      "write GOTOF, GOTOB or GOTO with a label, or nothing, behind the condition"};
    }
    return;
  }
  const ProgramIndex::Structure all = structure(scanner, "IF");
  if (!condition) {
    jump_to((all.middle > 0 ? all.middle : all.end) + 1);
  }
}

bool SinumerikReader::jump_if(Scanner& scanner, bool condition) {
  Scanner behind = scanner;
  const std::string_view word = behind.name();
  const Run run = find_statement(word);
  if (run == nullptr || !letters::same(word.substr(0, 4), "GOTO")) {
    return false;
  }
  if (condition) {
    (this->*run)(behind);
    skip_rest(behind);
  } else if (!letters::same(word, "GOTOS")) {
    label(behind);
  }
  scanner = behind;
  return true;
}

void SinumerikReader::run_else(Scanner& scanner) {
  jump_to(structure(scanner, "ELSE").end + 1);
}

void SinumerikReader::run_endif(Scanner& scanner) {
  structure(scanner, "ENDIF");
}

void SinumerikReader::run_for(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "FOR");
  const LoopCounter counter = values_.read_counter(scanner);
  require(scanner, '=');
  values_.set(counter, values_.read(scanner));
  if (!scanner.take_name("TO")) {
    throw ReadFault{"syntax", scanner.column(), "FOR without TO", "write FOR I=1 TO 10"};
  }
  if (values_.get(counter) > values_.read(scanner)) {
    jump_to(all.end + 1);
  }
}

void SinumerikReader::run_endfor(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "ENDFOR");
  Scanner begin = first_statement(without_comment(text().line(all.begin)));
  begin.name();
  try {
    const LoopCounter counter = values_.read_counter(begin);
    require(begin, '=');
    values_.read(begin);
    begin.take_name("TO");
    const double next = values_.get(counter) + 1;
    values_.set(counter, next);
    if (next <= values_.read(begin)) {
      jump_to(all.begin + 1);
    }
  } catch (ReadFault& fault) {
    // What is wrong stands in the line of FOR.
    fault.column = scanner.column();
    throw;
  }
}

void SinumerikReader::run_while(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "WHILE");
  if (values_.read(scanner) == 0) {
    jump_to(all.end + 1);
  }
}

void SinumerikReader::run_loop(Scanner& scanner) {
  structure(scanner, "LOOP");
}

void SinumerikReader::run_end_of_loop(Scanner& scanner) {
  jump_to(structure(scanner, "the end of a loop").begin);
}

void SinumerikReader::run_until(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "UNTIL");
  if (values_.read(scanner) == 0) {
    jump_to(all.begin + 1);
  }
}

std::string SinumerikReader::label(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (values_.text_follows(scanner) || scanner.peek() == '(') {
    return values_.read_text(scanner);
  }
  const std::string_view name = scanner.name();
  if (name.empty()) {
    throw ReadFault{"syntax", column, "a jump without a label", "write the label behind GOTOF or GOTOB"};
  }
  return std::string(name);
}

void SinumerikReader::jump(Scanner& scanner, bool forward, bool backward, bool must) {
  const std::uint32_t column = scanner.column();
  const std::string to = label(scanner);
  std::uint32_t target = forward ? index().forward(to, line()) : 0;
  if (target == 0 && backward) {
    target = index().backward(to, line());
  }
  if (target > 0) {
    finish_spline();
    jump_to(target);
  } else if (must) {
    throw ReadFault{"unknown-label", column,
                    fmt::format("there is no label {} {}", feedscope::quoted(to),
                                forward && backward ? "in the program"
                                : forward           ? "further on"
                                                    : "before this line"),
                    "the jump is left out; check the label and the direction of the jump"};
  }
}

void SinumerikReader::run_goto(Scanner& scanner) {
  jump(scanner, true, true, true);
}

void SinumerikReader::run_gotof(Scanner& scanner) {
  jump(scanner, true, false, true);
}

void SinumerikReader::run_gotob(Scanner& scanner) {
  jump(scanner, false, true, true);
}

void SinumerikReader::run_gotoc(Scanner& scanner) {
  jump(scanner, true, true, false);
}

void SinumerikReader::run_gotos(Scanner&) {
  jump_to(index().section_of(line()).first);
}

void SinumerikReader::run_case(Scanner& scanner) {
  const double value = values_.read(scanner);
  if (!scanner.take_name("OF")) {
    throw ReadFault{"syntax", scanner.column(), "CASE without OF", "write CASE (R1) OF 1 GOTOF LABEL"};
  }
  while (!scanner.at_end()) {
    const bool meant = scanner.take_name("DEFAULT") || values_.read(scanner) == value;
    const std::uint32_t column = scanner.column();
    if (!jump_if(scanner, meant)) {
      throw ReadFault{"syntax", column, "CASE without GOTOF or GOTOB", "write CASE (R1) OF 1 GOTOF LABEL"};
    }
  }
}

std::uint32_t SinumerikReader::repeat_count(Scanner& scanner) {
  if (!scanner.take('P')) {
    return 1;
  }
  scanner.take('=');
  return static_cast<std::uint32_t>(std::clamp(std::floor(values_.read(scanner) + 0.5), 0.0, most_runs));
}

std::uint32_t SinumerikReader::label_line(const std::string& label, std::uint32_t column) {
  const std::uint32_t before = index().backward(label, line());
  const std::uint32_t found = before > 0 ? before : index().forward(label, line());
  if (found == 0 || found == line()) {
    throw ReadFault{"unknown-label", column,
                    fmt::format("there is no label {} in the program", feedscope::quoted(label)),
                    "nothing is repeated; check the label"};
  }
  return found;
}

/// REPEAT with labels; alone it begins a loop that UNTIL ends.
void SinumerikReader::run_repeat(Scanner& scanner) {
  if (scanner.at_end()) {
    structure(scanner, "REPEAT");
    return;
  }
  const std::uint32_t column = scanner.column();
  const std::uint32_t begin = label_line(label(scanner), column);
  std::uint32_t end = begin < line() ? line() - 1 : 0;
  if (begin > line()) {
    end = index().forward("ENDLABEL", begin);
  }
  Scanner behind = scanner;
  const bool counted = behind.take('P') && (behind.peek() == '=' || letters::is_digit(behind.peek()));
  if (!counted && !scanner.at_end()) {
    end = label_line(label(scanner), column);
  } else if (const std::uint32_t marked = index().forward("ENDLABEL", begin); marked > 0 && marked < line()) {
    end = marked;
  }
  if (end < begin) {
    throw ReadFault{"unknown-label", column, "the part to be repeated has no end behind its beginning",
                    "nothing is repeated; write a second label or ENDLABEL"};
  }
  add_repeat(begin, end, scanner);
}

void SinumerikReader::run_repeatb(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  const std::uint32_t begin = label_line(label(scanner), column);
  add_repeat(begin, begin, scanner);
}

void SinumerikReader::add_repeat(std::uint32_t begin, std::uint32_t end, Scanner& scanner) {
  const std::uint32_t count = repeat_count(scanner);
  if (count == 0) {
    return;
  }
  finish_spline();
  repeats_.push_back(
      {.begin = begin, .end = end, .resume = line() + 1, .left = count, .depth = call_depth()});
  jump_to(begin);
}

bool SinumerikReader::repeat_is_over(std::uint32_t next) {
  if (repeats_.empty() || repeats_.back().depth != call_depth() || next != repeats_.back().end + 1) {
    return false;
  }
  Repeat& repeat = repeats_.back();
  if (--repeat.left > 0) {
    jump_to(repeat.begin);
  } else {
    jump_to(repeat.resume);
    repeats_.pop_back();
  }
  return true;
}

void SinumerikReader::run_synchronized(Scanner& scanner) {
  report(Severity::info, "synchronized-action", 0, scanner.column(), [] {
    return Text{"an action beside the program is not read", "the path stays as it is"};
  });
  skip_rest(scanner);
}

}  // namespace feedscope
