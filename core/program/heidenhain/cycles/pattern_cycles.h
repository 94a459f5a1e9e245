#pragma once

#include <cstdint>
#include <vector>

#include "core/program/heidenhain/cycles/cycle.h"
#include "core/program/heidenhain/cycles/cycle_parameters.h"

namespace feedscope::heidenhain {

/// Cycles 220 and 221, which repeat a drilling cycle at the places of a pattern.
class PatternCycles : private Part {
 public:
  /// All outlive it.
  PatternCycles(Context& context, const CycleParameters& parameters)
      : Part(context), parameters_(parameters) {}

  static bool has(int number);
  /// Call before the parameters of cycle `number` are read.
  void set_defaults(int number);
  /// Throws ReadFault.
  void run(int number, const Cycle& repeated, std::uint32_t column);

 private:
  std::vector<Vec2> places(int number, std::uint32_t column) const;
  DrillingParameters heights() const;
  DrillingFault drill_one(const Cycle& repeated, const DrillingParameters& words,
                          const DrillingPlace& place) const;

  const CycleParameters& parameters_;
};

}  // namespace feedscope::heidenhain
