#pragma once

#include <array>
#include <cstdint>

namespace feedscope {

/// Reason why the axes stop in a block without a path.
enum class Pause : std::uint8_t {
  dwell,
  tool_change,    ///< M6, TOOL CALL; its time is the machine's
  spindle_start,  ///< M3 or M4 with the spindle at rest; its time is the machine's
  stop,           ///< M0, M1; its time is the operator's
  indexing,       ///< rotary axes turn; the machine determines the time
  swing,          ///< the same, while X, Y and Z keep the tip in place
  machine_move,   ///< the axes move, but to, at or from a place that only the machine knows
};

/// Place of an axis, as far as the program determines it.
struct AxisPlace {
  enum class Kind : std::uint8_t {
    part,         ///< value: shown coordinate [mm]
    home,         ///< value: distance from the machine's home position [mm]
    tool_change,  ///< value: distance from the machine's tool change position [mm]
    machine,      ///< value: coordinate of the machine [mm]
    unknown,
    assumed,  ///< at a shown coordinate, because the program continues as if the axis were there [mm]
  };
  Kind kind = Kind::part;
  double value = 0;
  bool zero_given =
      false;  ///< shown coordinates are those of the machine, because the program itself sets its zero

  /// True if the program determines the shown coordinate.
  bool is_shown() const { return kind == Kind::part || kind == Kind::assumed; }
  bool operator==(const AxisPlace&) const = default;
};

/// Places of the three axes after a block.
using AxisPlaces = std::array<AxisPlace, 3>;

/// A block that moves to, at or from a place that only the machine knows.
struct MachineMove {
  AxisPlaces end;
  double feed = 0;  ///< [mm/s]; 0: a rapid
};

}  // namespace feedscope
