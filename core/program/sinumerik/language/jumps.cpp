#include "core/program/sinumerik/language/jumps.h"

#include <algorithm>
#include <array>

#include "core/program/sinumerik/language/scanning.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

const Jumps::Jump* Jumps::find(std::string_view name) {
  static constexpr auto jumps = std::to_array<Jump>({{.name = "GOTO", .forward = true, .backward = true},
                                                     {.name = "GOTOF", .forward = true},
                                                     {.name = "GOTOB", .backward = true},
                                                     {"GOTOC", true, true, false},
                                                     {.name = "GOTOS"}});
  const auto found = std::find_if(jumps.begin(), jumps.end(),
                                  [&](const Jump& jump) { return letters::same(jump.name, name); });
  return found == jumps.end() ? nullptr : &*found;
}

bool Jumps::run(std::string_view name, Scanner& scanner) {
  if (const Jump* const jump = find(name)) {
    go(*jump, scanner);
    return true;
  }
  if (letters::same(name, "CASE")) {
    run_case(scanner);
    return true;
  }
  return false;
}

void Jumps::go(const Jump& jump, Scanner& scanner) {
  const ProgramIndex& index = indexes_.of(lines().text());
  const std::uint32_t line = lines().line();
  if (!jump.forward && !jump.backward) {
    lines().jump_to(index.section_of(line).first);
    return;
  }
  const std::uint32_t column = scanner.column();
  const std::string to = label(scanner);
  std::uint32_t target = jump.forward ? index.forward(to, line) : 0;
  if (target == 0 && jump.backward) {
    target = index.backward(to, line);
  }
  if (target > 0) {
    splines_.finish();
    lines().jump_to(target);
  } else if (jump.must) {
    throw ReadFault{
        "unknown-label", column,
        jump.forward && jump.backward
            ? message(NC_("core", "label {} does not exist in the program"), feedscope::in_quotes(to))
        : jump.forward
            ? message(NC_("core", "label {} does not exist after this line"), feedscope::in_quotes(to))
            : message(NC_("core", "label {} does not exist before this line"), feedscope::in_quotes(to)),
        NC_("core", "the jump is skipped; check the label and the direction of the jump")};
  }
}

std::string Jumps::label(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  if (values_.text_follows(scanner) || scanner.peek() == '(') {
    return values_.read_text(scanner);
  }
  const std::string_view name = scanner.name();
  if (name.empty()) {
    throw ReadFault{"syntax", column, NC_("core", "a jump without a label"),
                    NC_("core", "write the label after GOTOF or GOTOB")};
  }
  return std::string(name);
}

bool Jumps::jump_if(Scanner& scanner, bool holds) {
  Scanner behind = scanner;
  const Jump* const jump = find(behind.name());
  if (jump == nullptr) {
    return false;
  }
  if (holds) {
    go(*jump, behind);
    skip_rest(behind);
  } else if (jump->forward || jump->backward) {
    label(behind);
  }
  scanner = behind;
  return true;
}

void Jumps::run_case(Scanner& scanner) {
  const double value = values_.read(scanner);
  if (!scanner.take_name("OF")) {
    throw ReadFault{"syntax", scanner.column(), NC_("core", "CASE without OF"),
                    NC_("core", "write CASE (R1) OF 1 GOTOF LABEL")};
  }
  while (!scanner.at_end()) {
    const bool meant = scanner.take_name("DEFAULT") || values_.read(scanner) == value;
    const std::uint32_t column = scanner.column();
    if (!jump_if(scanner, meant)) {
      throw ReadFault{"syntax", column, NC_("core", "CASE without GOTOF or GOTOB"),
                      NC_("core", "write CASE (R1) OF 1 GOTOF LABEL")};
    }
  }
}

}  // namespace feedscope::sinumerik
