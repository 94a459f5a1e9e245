#pragma once

#include "core/program/machining.h"
#include "core/program/text/lexer.h"

namespace feedscope::iso {

/// Reports what the lexer could not read of a line.
void report_faults(const Machining& machining, const Block& block);

}  // namespace feedscope::iso
