#include "core/program/sinumerik/language/flow.h"

#include <array>

#include "core/program/language/statement_table.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

bool Flow::run(std::string_view name, Scanner& scanner) {
  static constexpr auto statements = std::to_array<StatementEntry<Flow>>({{"IF", &Flow::run_if},
                                                                          {"ELSE", &Flow::run_else},
                                                                          {"ENDIF", &Flow::run_endif},
                                                                          {"FOR", &Flow::run_for},
                                                                          {"ENDFOR", &Flow::run_endfor},
                                                                          {"WHILE", &Flow::run_while},
                                                                          {"LOOP", &Flow::run_loop},
                                                                          {"ENDWHILE", &Flow::run_endwhile},
                                                                          {"ENDLOOP", &Flow::run_endloop},
                                                                          {"REPEAT", &Flow::run_repeat},
                                                                          {"UNTIL", &Flow::run_until}});
  return run_statement(*this, statements, name, scanner);
}

/// Structure of the current line, which begins or ends with `word`.
ProgramIndex::Structure Flow::structure(Scanner& scanner, std::string_view word) {
  const ProgramIndex::Structure found = indexes_.of(lines().text()).structure(lines().line());
  if (found.end == 0) {
    throw ReadFault{
        "control-structure", scanner.column(), message(NC_("core", "{} has no matching start or end"), word),
        NC_("core", "the line is skipped; check IF, ELSE, ENDIF and the starts and ends of loops")};
  }
  return found;
}

void Flow::run_if(Scanner& scanner) {
  const bool holds = values_.read(scanner) != 0;
  if (!scanner.at_end()) {
    if (!jumps_.jump_if(scanner, holds)) {
      throw ReadFault{
          "syntax", scanner.column(),
          message(NC_("core", "{} after a condition is not a jump"), in_quotes(scanner.rest())),
          NC_("core", "write GOTOF, GOTOB or GOTO with a label, or nothing, after the condition")};
    }
    return;
  }
  const ProgramIndex::Structure all = structure(scanner, "IF");
  if (!holds) {
    lines().jump_to((all.middle > 0 ? all.middle : all.end) + 1);
  }
}

void Flow::run_else(Scanner& scanner) {
  lines().jump_to(structure(scanner, "ELSE").end + 1);
}

void Flow::run_endif(Scanner& scanner) {
  structure(scanner, "ENDIF");
}

void Flow::run_for(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "FOR");
  const LoopCounter counter = assignments_.read_counter(scanner);
  require(scanner, '=');
  assignments_.set(counter, values_.read(scanner));
  if (!scanner.take_name("TO")) {
    throw ReadFault{"syntax", scanner.column(), NC_("core", "FOR without TO"),
                    NC_("core", "write FOR I=1 TO 10")};
  }
  if (assignments_.get(counter) > values_.read(scanner)) {
    lines().jump_to(all.end + 1);
  }
}

void Flow::run_endfor(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "ENDFOR");
  Scanner begin = first_statement(without_comment(lines().text().line(all.begin)));
  begin.name();
  try {
    const LoopCounter counter = assignments_.read_counter(begin);
    require(begin, '=');
    values_.read(begin);
    begin.take_name("TO");
    const double next = assignments_.get(counter) + 1;
    assignments_.set(counter, next);
    if (next <= values_.read(begin)) {
      lines().jump_to(all.begin + 1);
    }
  } catch (ReadFault& fault) {
    // The column of the fault refers to the line of FOR.
    fault.column = scanner.column();
    throw;
  }
}

void Flow::run_while(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "WHILE");
  if (values_.read(scanner) == 0) {
    lines().jump_to(all.end + 1);
  }
}

void Flow::run_loop(Scanner& scanner) {
  structure(scanner, "LOOP");
}

void Flow::run_endwhile(Scanner& scanner) {
  lines().jump_to(structure(scanner, "ENDWHILE").begin);
}

void Flow::run_endloop(Scanner& scanner) {
  lines().jump_to(structure(scanner, "ENDLOOP").begin);
}

void Flow::run_repeat(Scanner& scanner) {
  structure(scanner, "REPEAT");
}

void Flow::run_until(Scanner& scanner) {
  const ProgramIndex::Structure all = structure(scanner, "UNTIL");
  if (values_.read(scanner) == 0) {
    lines().jump_to(all.begin + 1);
  }
}

}  // namespace feedscope::sinumerik
