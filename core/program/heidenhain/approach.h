#pragma once

#include <cstdint>
#include <optional>

#include "core/program/path/plane_element.h"

namespace feedscope::heidenhain {

/// How a contour is reached (APPR) or left (DEP).
enum class ApproachKind : std::uint8_t {
  tangent_line,  ///< LT
  normal_line,   ///< LN
  arc,           ///< CT
  line_and_arc,  ///< LCT: an arc that touches the contour, a line that touches the arc
};

/// The words of an approach or departure.
struct ApproachShape {
  ApproachKind kind = ApproachKind::tangent_line;
  double length = 0;  ///< LT, LN [mm]
  double radius = 0;  ///< CT, LCT; negative: on the other side than the tool [mm]
  double angle = 0;   ///< CT [rad]
  int side = 1;       ///< of the tool: 1 left of the contour, -1 right
  /// Of a compensated tool, else 0 [mm]. `radius` is that of its centre's arc: the examples CIRCULAR, C-CC
  /// and HELIX of Heidenhain's manuals (TNC 640 Klartext programming, path contours) approach with R below
  /// it.
  double tool_radius = 0;
};

/// Between the contour and the point where the approach's own curve starts or the departure's ends.
struct ApproachPath {
  Vec2 point;                  ///< the auxiliary point, or the departure's end
  int turn = 0;                ///< of the curve: 0 a line, 1 counter-clockwise, -1 clockwise
  Vec2 center = Vec2::Zero();  ///< arcs
};

/// The curve from `point` to `contour`, where the contour begins in `direction`; `from`: where the tool is.
/// `from` is where the tool's centre is, `point` and the curve are the contour's. None: LCT, and the tool is
/// inside the circle of the arc.
std::optional<ApproachPath> approach_path(const ApproachShape& shape, const Vec2& from, const Vec2& contour,
                                          const Vec2& direction);

/// The curve from `contour`, where the contour ends in `direction`, to `point`; `to`: where LCT goes.
/// None: LCT, and `to` lies inside the circle of the arc.
std::optional<ApproachPath> departure_path(const ApproachShape& shape, const Vec2& contour,
                                           const Vec2& direction, const Vec2& to);

}  // namespace feedscope::heidenhain
