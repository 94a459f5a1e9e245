#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/program/heidenhain/coordinates.h"

namespace feedscope::heidenhain {

/// Tilted working planes: PLANE and cycle 19. The path is shown in the coordinates of the workpiece, however
/// the machine turns its axes to get there.
class PlaneStatements : private Part {
 public:
  /// Both outlive it.
  PlaneStatements(Context& context, Coordinates& coordinates) : Part(context), coordinates_(coordinates) {}

  /// From behind "PLANE" on. False for a form that is not supported: no plane is tilted any more. Throws
  /// ReadFault.
  bool run(Scanner& scanner, std::uint32_t column);
  /// The line of cycle 19. Throws ReadFault.
  void run_cycle(Scanner& scanner, std::uint32_t column);

 private:
  /// [rad]; zero where a name is missing.
  std::array<double, 3> named_angles(Scanner& scanner, const std::array<std::string_view, 3>& names) const;
  CoordinateFrame by_vectors(Scanner& scanner, std::uint32_t column) const;
  CoordinateFrame by_points(Scanner& scanner, std::uint32_t column) const;
  /// By A, B and C; none if none of them is next.
  std::optional<CoordinateFrame> by_axes(Scanner& scanner, std::uint32_t column) const;
  /// How the rotary axes get there.
  struct Positioning {
    bool turns = true;  ///< MOVE, TURN
    int side = 0;       ///< SEQ, SYM
    double feed = 0;    ///< [rad/s]; 0: a rapid
    /// MB: how far the tool moves back along its axis before [mm]; infinite: MB MAX.
    std::optional<double> retract;
    bool shifts = false;  ///< MOVE, which turns about a place at a distance from the tip (DIST)
  };
  Positioning read_positioning(Scanner& scanner) const;
  void retract(const Positioning& positioning, std::uint32_t column);
  void turn_axes(const Positioning& positioning, bool resets, std::uint32_t column);

  Coordinates& coordinates_;
};

}  // namespace feedscope::heidenhain
