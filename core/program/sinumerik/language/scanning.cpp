#include "core/program/sinumerik/language/scanning.h"

#include <cstdint>

#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

void require(Scanner& scanner, char c) {
  const std::uint32_t column = scanner.column();
  if (!scanner.take(c)) {
    throw ReadFault{"syntax", column, message(NC_("core", "\"{}\" is missing here"), c),
                    NC_("core", "correct the statement; the block does not move")};
  }
}

void skip_brackets(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  int depth = 0;
  bool inside_text = false;
  for (std::size_t at = scanner.at(); at < scanner.text().size(); ++at) {
    const char c = scanner.text()[at];
    inside_text = c == '"' ? !inside_text : inside_text;
    depth += !inside_text && (c == '(' || c == '[') ? 1 : 0;
    depth -= !inside_text && (c == ')' || c == ']') ? 1 : 0;
    if (depth == 0 && !inside_text) {
      scanner.move_to(at + 1);
      return;
    }
  }
  throw ReadFault{"syntax", column, NC_("core", "the bracket is not closed"),
                  NC_("core", "correct the statement; the block does not move")};
}

}  // namespace feedscope::sinumerik
