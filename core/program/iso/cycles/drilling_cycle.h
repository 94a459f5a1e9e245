#pragma once

#include <cstdint>

#include "core/base/geometry.h"
#include "core/program/cycles/drill_plan.h"

namespace feedscope::iso {

/// Motion of a drilling cycle between its retract plane and the bottom of the hole.
enum class DrillingMotion : std::uint8_t {
  rapid_out,   ///< one feed down, rapid out: G81, G82, G86
  feed_out,    ///< one feed down, feed out: reaming, G85, G89
  tap,         ///< down and out at feed, in strokes of `peck`: G74, G84
  peck,        ///< feeds down bit by bit, rapid out of the hole and back in between: G83
  chip_break,  ///< the same, with a short lift in between: G73
  fine_bore,   ///< one feed down, aside off the wall, rapid out, back: G76
  back_bore,   ///< aside, rapid down, back, feed up, aside, rapid out, back: G87
};

/// A hole in programmed coordinates; levels are along the tool's axis, which points out of the hole.
struct DrillingCycle {
  DrillingMotion motion = DrillingMotion::rapid_out;
  int axis = 2;           ///< of the tool
  double initial = 0;     ///< level before the first hole [mm]
  double retract = 0;     ///< level from which the tool feeds [mm]
  double bottom = 0;      ///< level the tool feeds to [mm]
  double peck = 0;        ///< depth of one feed or stroke, > 0; 0: all at once [mm]
  double peck_less = 0;   ///< decrease of each feed from the one before, >= 0 [mm]
  double peck_least = 0;  ///< lower limit of a feed, > 0 with `peck_less` [mm]
  double clearance = 0;   ///< lift of a chip break; distance from the last depth at which a peck begins [mm]
  double dwell = 0;       ///< at the bottom [s]
  Vec3 aside = Vec3::Zero();  ///< off the wall [mm]
  bool to_initial = true;     ///< ends at the initial level, else at the retract level
  /// `feed_out` feeds to the end level of the cycle, else to the retract level and continues with a rapid.
  bool feeds_to_the_end = false;
};

/// Upper bound of the downward feeds of the cycle; useful as long as it is small.
double peck_count(const DrillingCycle& cycle);

/// Rapid up to the level where the cycle begins, if the tool is below it.
void rise(PathWriter& path, const DrillingCycle& cycle);

/// Rapid above `hole` at the present level, or the retract level if that is higher; then the cycle.
void drill(PathWriter& path, const DrillingCycle& cycle, const Vec3& hole);

}  // namespace feedscope::iso
