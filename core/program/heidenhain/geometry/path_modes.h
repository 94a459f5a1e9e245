#pragma once

#include <cstdint>
#include <optional>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// Accuracy of the path: tolerances of cycle 32 and G62, look-ahead of M120.
class PathModes : private Part {
 public:
  explicit PathModes(Context& context) : Part(context) {}

  /// Sets the tolerances [mm], [rad]; none or zero: the machine's own. Throws ReadFault.
  void set_tolerance(std::optional<double> tolerance, std::optional<double> orientation_tolerance,
                     std::uint32_t column);
  /// Changes only the orientation tolerance of the tolerance in force [rad].
  void set_orientation_tolerance(double tolerance, std::uint32_t column);
  void use_look_ahead(std::uint32_t column);
};

}  // namespace feedscope::heidenhain
