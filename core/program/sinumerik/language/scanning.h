#pragma once

#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

/// Reads `c`. Throws ReadFault "syntax" if it is not next.
void require(Scanner& scanner, char c);

/// Skips the next brackets, "()" or "[]", with their content, including quoted texts. Throws ReadFault
/// "syntax" if they are not closed.
void skip_brackets(Scanner& scanner);

/// Ignores the rest of the line.
inline void skip_rest(Scanner& scanner) {
  scanner.move_to(scanner.text().size());
}

}  // namespace feedscope::sinumerik
