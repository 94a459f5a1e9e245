#pragma once

#include "core/toolpath/curve.h"

namespace feedscope {

/// A circular arc in a corner of two lines, tangent to both.
///
///            corner
///       T  .-'| `-.  T       turn b between the directions, T from the corner to both ends,
///     .-'  eps|    `-.       radius R = T / tan(b/2), eps = T tan(b/4) to the middle of the arc
///    ---- arc ---------
struct ConnectingArc {
  double turn = 0;        ///< b [rad]
  double transition = 0;  ///< T [mm]
  double epsilon = 0;     ///< distance of the corner from the arc [mm]
  Arc arc;
};

/// R = min(TIT / tan(b/2), L / (2 tan(b/2)) - TIT) (Msaddek 2011, eq 1), where TIT is `tolerance` and L the
/// `shorter` one of the two blocks [mm].
///
/// The second term subtracts a length along the block from a radius. It is used as printed, but on blocks of
/// a few TIT it would leave no arc at all, so T is at least an eighth of the shorter block. T never exceeds
/// half of it. `in`, `out`: unit directions, turning by more than straight_angle and less than a reversal.
ConnectingArc connecting_arc(const Vec3& corner, const Vec3& in, const Vec3& out, double shorter,
                             double tolerance);

}  // namespace feedscope
