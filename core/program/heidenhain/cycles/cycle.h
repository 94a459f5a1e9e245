#pragma once

#include <cstdint>
#include <string>

#include "core/program/heidenhain/context.h"
#include "core/program/heidenhain/cycles/drilling_cycles.h"

namespace feedscope::heidenhain {

/// A defined cycle, valid until the next definition.
struct Cycle {
  enum class Kind : std::uint8_t { none, drilling, old_drilling, program, unsupported };
  int number = 0;
  Kind kind = Kind::none;
  std::string program;  ///< of cycle 12
  OldDrilling old;
};

/// Place of the tool for drilling.
DrillingPlace drilling_place(const Context& context);
/// Reports why cycle `number` does not run; nothing for DrillingFault::none.
void report_fault(const Context& context, int number, DrillingFault fault, std::uint32_t column);

}  // namespace feedscope::heidenhain
