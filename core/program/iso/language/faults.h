#pragma once

#include "core/program/machining.h"
#include "core/program/text/lexer.h"

namespace feedscope::iso {

/// Reports everything in a line that the lexer could not read.
void report_faults(const Machining& machining, const Block& block);

}  // namespace feedscope::iso
