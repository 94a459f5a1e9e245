#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/parametric_curve.h"

namespace feedscope {

/// A line or arc that replaces a part of a curve; it starts where the one before ends.
struct CurvePiece {
  Vec3 end;  ///< [mm]
  bool is_arc = false;
  Vec3 center = Vec3::Zero();  ///< arcs [mm]
  Vec3 axis = Vec3::UnitZ();   ///< arcs: unit; counter-clockwise seen against it, at most a quarter turn
  double length = 0;           ///< [mm]
};

struct CurvePieces {
  std::vector<CurvePiece> pieces;
  double length = 0;                  ///< of all [mm]
  Vec3 end_direction = Vec3::Zero();  ///< unit, of the curve at its end; zero for a length of zero
};

/// Lines and arcs that stay within `curve_tolerance` of `curve` from parameter `from` to `to`, and are
/// tangent to each other wherever the curve is smooth. The last one ends at the curve's end.
///
/// Each part of the curve, from p1 with unit tangent t1 to p2 with t2, becomes a biarc: two arcs that touch
/// each other and both tangents, each in its own plane (Bolton, "Biarc curves", Computer-Aided Design
/// 7 (1975) 89-92; in space Sharrock, "Biarcs in three dimensions", The Mathematics of Surfaces II (1987)).
/// Of the family of such pairs it is the one with equal tangent lengths d, as in LinuxCNC:
///
///     q1 = p1 + d t1,  q2 = p2 - d t2,  |q2 - q1| = 2 d,  so that with v = p2 - p1 and t = t1 + t2
///     d = v.v / (v.t + sqrt((v.t)^2 + 2 (1 - t1.t2) v.v))
///     the arcs meet in (q1 + q2) / 2, where their tangent is (q2 - q1) / (2 d)
///
/// A part is halved until its biarc is close enough; the error of the halves is an eighth. Where both arcs
/// are almost straight, one line replaces them. A part smaller than the tolerance, such as the tip of a cusp,
/// becomes a line; a cusp at a cut of the curve is approached from both sides. Halving ends at some 65 000
/// parts.
CurvePieces arcs_of_curve(const ParametricCurve& curve, double from, double to);

}  // namespace feedscope
