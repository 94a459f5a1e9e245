#pragma once

#include <cstdint>
#include <optional>

#include "core/program/heidenhain/context.h"

namespace feedscope::heidenhain {

/// How exactly the path is followed: tolerances of cycle 32 and G62, look-ahead of M120.
class PathModes : private Part {
 public:
  explicit PathModes(Context& context) : Part(context) {}

  /// [mm], [rad]; none or a tolerance of zero: the machine's own. Throws ReadFault.
  void set_tolerance(std::optional<double> tolerance, std::optional<double> orientation_tolerance,
                     std::uint32_t column);
  /// Of the tolerance in force, that of the orientation only [rad].
  void set_orientation_tolerance(double tolerance, std::uint32_t column);
  void use_look_ahead(std::uint32_t column);
};

}  // namespace feedscope::heidenhain
