#pragma once

#include <array>
#include <cstdint>

namespace feedscope {

/// Why the axes stand in a block without a path.
enum class Pause : std::uint8_t {
  dwell,
  tool_change,    ///< M6, TOOL CALL; its time is the machine's
  spindle_start,  ///< M3 or M4 with the spindle at rest; its time is the machine's
  stop,           ///< M0, M1; its time is the operator's
  indexing,       ///< rotary axes turn; how long, the machine says
  swing,          ///< the same, and X, Y and Z hold the tip where it is
  machine_move,   ///< they move, but to, at or from a place that only the machine knows
};

/// Where an axis is, as far as a program says it.
struct AxisPlace {
  enum class Kind : std::uint8_t {
    part,         ///< value: coordinate as it is shown [mm]
    home,         ///< value: distance from the machine's home position [mm]
    tool_change,  ///< value: distance from the machine's tool change position [mm]
    machine,      ///< value: coordinate of the machine [mm]
    unknown,
    assumed,  ///< at a coordinate as it is shown, since the program goes on as if the axis were there [mm]
  };
  Kind kind = Kind::part;
  double value = 0;
  bool zero_given =
      false;  ///< coordinates that are shown are those of the machine: the program sets its zero

  /// The program says where it is shown.
  bool is_shown() const { return kind == Kind::part || kind == Kind::assumed; }
  bool operator==(const AxisPlace&) const = default;
};

/// Where the three axes are after a block.
using AxisPlaces = std::array<AxisPlace, 3>;

/// A block that moves to, at or from a place that only the machine knows.
struct MachineMove {
  AxisPlaces end;
  double feed = 0;  ///< [mm/s]; 0: a rapid
};

}  // namespace feedscope
