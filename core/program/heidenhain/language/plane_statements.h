#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/program/heidenhain/geometry/coordinates.h"

namespace feedscope::heidenhain {

/// Tilted working planes: PLANE and cycle 19. The path is shown in workpiece coordinates, however the machine
/// turns its axes.
class PlaneStatements : private Part {
 public:
  /// Both outlive it.
  PlaneStatements(Context& context, Coordinates& coordinates) : Part(context), coordinates_(coordinates) {}

  /// Reads from after "PLANE". Returns false for an unsupported form, which ends the tilt. Throws ReadFault.
  bool run(Scanner& scanner, std::uint32_t column);
  /// Runs the line of cycle 19. Throws ReadFault.
  void run_cycle(Scanner& scanner, std::uint32_t column);

 private:
  /// [rad]; zero where a name is missing.
  std::array<double, 3> named_angles(Scanner& scanner, const std::array<std::string_view, 3>& names) const;
  CoordinateFrame by_vectors(Scanner& scanner, std::uint32_t column) const;
  CoordinateFrame by_points(Scanner& scanner, std::uint32_t column) const;
  /// Frame by A, B and C; none if none of them is next.
  std::optional<CoordinateFrame> by_axes(Scanner& scanner, std::uint32_t column) const;
  /// Way of the rotary axes to the plane.
  struct Positioning {
    bool turns = true;  ///< MOVE, TURN
    int side = 0;       ///< SEQ, SYM
    double feed = 0;    ///< [rad/s]; 0: a rapid
    /// MB: retraction of the tool along its axis before the turn [mm]; infinite: MB MAX.
    std::optional<double> retract;
    bool shifts = false;  ///< MOVE, which turns about a place at a distance from the tip (DIST)
  };
  Positioning read_positioning(Scanner& scanner) const;
  void retract(const Positioning& positioning, std::uint32_t column);
  void turn_axes(const Positioning& positioning, bool resets, std::uint32_t column);

  Coordinates& coordinates_;
};

}  // namespace feedscope::heidenhain
