#pragma once

#include <cstdint>
#include <string>

#include "core/program/heidenhain/context.h"
#include "core/program/heidenhain/drilling_cycles.h"

namespace feedscope::heidenhain {

/// A cycle as defined, until the next one is.
struct Cycle {
  enum class Kind : std::uint8_t { none, drilling, old_drilling, program, unsupported };
  int number = 0;
  Kind kind = Kind::none;
  std::string program;  ///< of cycle 12
  OldDrilling old;
};

/// Where the tool is, for drilling.
DrillingPlace drilling_place(const Context& context);
/// Says why cycle `number` does not run; nothing for DrillingFault::none.
void report_fault(const Context& context, int number, DrillingFault fault, std::uint32_t column);

}  // namespace feedscope::heidenhain
