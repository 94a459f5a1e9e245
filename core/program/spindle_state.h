#pragma once

#include <compare>
#include <cstdint>

namespace feedscope {

/// What of the spindle a program has said when a motion begins. Every motion has one.
struct SpindleState {
  enum class Turning : std::uint8_t {
    as_said,        ///< at `speed`; also in a program that starts its spindle nowhere, as subprograms do
    stands,         ///< M5, M19, or a tool change after which it is not started again
    surface_speed,  ///< constant cutting speed (G96): how fast it turns is not known
  };

  std::int32_t tool = -1;  ///< in the spindle: index into Program::tools; -1: the program has changed to none
  double speed = 0;        ///< [1/s]; 0: the program gives none, or S0
  Turning turning = Turning::as_said;

  auto operator<=>(const SpindleState&) const = default;
};

}  // namespace feedscope
