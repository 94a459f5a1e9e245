#pragma once

#include <compare>
#include <cstdint>

namespace feedscope {

/// Spindle words in force when a motion begins. Every motion has one.
struct SpindleState {
  enum class Turning : std::uint8_t {
    as_said,        ///< at `speed`; also in a program that never starts its spindle, such as a subprogram
    stands,         ///< M5, M19, or a tool change after which it is not started again
    surface_speed,  ///< constant cutting speed (G96): its rotational speed is not known
  };

  std::int32_t tool = -1;  ///< in the spindle: index into Program::tools; -1: no tool after a change
  double speed = 0;        ///< [1/s]; 0: none given, or S0
  Turning turning = Turning::as_said;

  auto operator<=>(const SpindleState&) const = default;
};

}  // namespace feedscope
