#pragma once

#include <cstdint>
#include <optional>

#include "core/program/heidenhain/context.h"
#include "core/program/heidenhain/cycles/drilling_cycles.h"

namespace feedscope::heidenhain {

/// Largest value of a cycle's parameter.
constexpr double largest_cycle_value = 1e9;

/// Parameters of cycles: "Q200=2" words set Q parameters, which a call of a cycle reads.
class CycleParameters : private Part {
 public:
  explicit CycleParameters(Context& context) : Part(context) {}

  /// Reads the parameters from the scanner after skipping a title. Parameters of cycle `number` that older
  /// programs lack get their default. Throws ReadFault.
  void read(int number, Scanner& scanner);
  /// GLOBAL DEF: sets the meaning of PREDEF in the following cycles. Throws ReadFault.
  void predefine(Scanner& scanner) { read_into(predefined_, scanner); }

  /// Current parameters of drilling cycle `number`; none, with a report, if a parameter has no value. Throws
  /// ReadFault.
  std::optional<DrillingParameters> drilling(int number, std::uint32_t column) const;
  /// A parameter within +-largest_cycle_value; 0 for one without a value.
  double value(int q) const;

 private:
  void read_into(QParameters& into, Scanner& scanner);

  QParameters predefined_;
};

}  // namespace feedscope::heidenhain
