#pragma once

#include <cstdint>
#include <optional>

#include "core/program/heidenhain/context.h"
#include "core/program/heidenhain/drilling_cycles.h"

namespace feedscope::heidenhain {

/// The largest number that a cycle's parameter may have.
constexpr double largest_cycle_value = 1e9;

/// What cycles are given: "Q200=2" words go to the Q parameters, from which a call of a cycle takes them.
class CycleParameters : private Part {
 public:
  explicit CycleParameters(Context& context) : Part(context) {}

  /// The parameters are read from the scanner on, behind a title that is skipped; those of cycle `number`
  /// that older programs lack have their default. Throws ReadFault.
  void read(int number, Scanner& scanner);
  /// GLOBAL DEF: what PREDEF means in the cycles that follow. Throws ReadFault.
  void predefine(Scanner& scanner) { read_into(predefined_, scanner); }

  /// What drilling cycle `number` is given now; none, and reported, if a parameter has no value. Throws
  /// ReadFault.
  std::optional<DrillingParameters> drilling(int number, std::uint32_t column) const;
  /// A parameter within +-largest_cycle_value; 0 for one without a value.
  double value(int q) const;

 private:
  void read_into(QParameters& into, Scanner& scanner);

  QParameters predefined_;
};

}  // namespace feedscope::heidenhain
