#pragma once

#include <cstdint>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// Cycle 9, G4, FUNCTION DWELL.
class Dwells : private Part {
 public:
  explicit Dwells(Context& context) : Part(context) {}

  void run(double seconds, std::uint32_t column);
};

}  // namespace feedscope::heidenhain
