#pragma once

#include "core/program/text/scanner.h"

namespace feedscope::sinumerik {

/// Takes `c`. Throws ReadFault "syntax" if it is not next.
void require(Scanner& scanner, char c);

/// Skips what is in the next brackets, "()" or "[]", and quoted texts in it. Throws
/// ReadFault "syntax" if it is not closed.
void skip_brackets(Scanner& scanner);

/// The rest of the line is ignored.
inline void skip_rest(Scanner& scanner) {
  scanner.move_to(scanner.text().size());
}

}  // namespace feedscope::sinumerik
