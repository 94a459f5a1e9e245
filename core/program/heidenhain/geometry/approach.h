#pragma once

#include <cstdint>
#include <optional>

#include "core/program/path/plane_element.h"

namespace feedscope::heidenhain {

/// Kinds of approach to a contour (APPR) and departure from it (DEP).
enum class ApproachKind : std::uint8_t {
  tangent_line,  ///< LT
  normal_line,   ///< LN
  arc,           ///< CT
  line_and_arc,  ///< LCT: a line, then an arc that touches line and contour
};

/// The words of an approach or departure.
struct ApproachShape {
  ApproachKind kind = ApproachKind::tangent_line;
  double length = 0;  ///< LT, LN [mm]
  double radius = 0;  ///< CT, LCT; negative: on the side opposite to the tool [mm]
  double angle = 0;   ///< CT [rad]
  int side = 1;       ///< of the tool: 1 left of the contour, -1 right
  /// Radius of a compensated tool, else 0 [mm]. `radius` is that of its centre's arc: the examples CIRCULAR,
  /// C-CC and HELIX of Heidenhain's manuals (TNC 640 Klartext programming, path contours) approach with R
  /// below it.
  double tool_radius = 0;
};

/// Curve between the contour and the point where the approach's own curve starts or the departure's ends.
struct ApproachPath {
  Vec2 point;                  ///< the auxiliary point, or the departure's end
  int turn = 0;                ///< of the curve: 0 a line, 1 counter-clockwise, -1 clockwise
  Vec2 center = Vec2::Zero();  ///< arcs
};

/// The curve from `point` to `contour`, where the contour begins in `direction`. `from`: place of the tool's
/// centre; `point` and the curve are on the contour. None: LCT with the tool inside the circle of the arc.
std::optional<ApproachPath> approach_path(const ApproachShape& shape, const Vec2& from, const Vec2& contour,
                                          const Vec2& direction);

/// The curve from `contour`, where the contour ends in `direction`, to `point`; `to`: end point of LCT. None:
/// LCT with `to` inside the circle of the arc.
std::optional<ApproachPath> departure_path(const ApproachShape& shape, const Vec2& contour,
                                           const Vec2& direction, const Vec2& to);

}  // namespace feedscope::heidenhain
