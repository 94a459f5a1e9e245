#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/program/program.h"

namespace feedscope {

/// Reason why an arc block cannot be an arc.
enum class ArcFault : std::uint8_t {
  none,
  center_at_start,   ///< radius zero
  radius_mismatch,   ///< start and end do not lie on one circle about the centre
  radius_too_small,  ///< R: the ends are farther apart than the diameter
  same_ends,         ///< R: the ends coincide, so that the centre is undetermined
};

/// An arc block resolved: one arc, or two that touch with one tangent.
struct ArcSolution {
  struct Piece {
    Vec3 target;
    ArcWords words;
  };
  ArcFault fault = ArcFault::none;
  int count = 0;  ///< valid pieces; 0 with a fault
  std::array<Piece, 2> pieces;
  double start_radius = 0;  ///< about the programmed centre [mm]
  double end_radius = 0;    ///< the same at the end; for R half the distance of the ends [mm]
};

/// Permitted difference of start and end radius: the larger of `least` and `share` of the radius, at most
/// `most`.
struct ArcTolerance {
  double least = 0.01;  ///< [mm]
  double share = 0.001;
  double most = 0.5;  ///< [mm]

  double of(double radius) const { return std::min(std::max(least, share * radius), most); }
};

/// An arc from `start` to `end` about `center`, counter-clockwise seen against the unit vector `axis`. Ends
/// that coincide in the arc's plane make a full circle; `extra_turns` are added. Components along the axis
/// make a helix.
///
/// Both ends lie exactly on the arc. Where the radii differ within the tolerance, the centre moves to the
/// nearest place with equal radii. An arc of more than half a turn whose ends are so close together that the
/// centre would move farther than the tolerance becomes two arcs instead, split half way: the first about
/// the programmed centre, the second with a radius that meets the end.
ArcSolution solve_center_arc(const Vec3& start, const Vec3& end, const Vec3& center, const Vec3& axis,
                             double extra_turns, const ArcTolerance& tolerance = {});

/// The same for a radius: positive for at most half a turn, negative for the larger arc. Ends that are
/// farther apart than the diameter, within the tolerance, make a half circle.
ArcSolution solve_radius_arc(const Vec3& start, const Vec3& end, double radius, const Vec3& axis,
                             double extra_turns);

}  // namespace feedscope
