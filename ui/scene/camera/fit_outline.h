#pragma once

#include <vector>

#include "ui/scene/camera/projection.h"

namespace feedscope::ui {

/// The corners of the convex hull, anticlockwise: one if all points are equal, two if they are on a line.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The smallest rectangle with all of the points, at least one.
ScreenRectangle box_around(const std::vector<Vec2>& points);

/// Position of an outline: its point p moves to place + factor * p.
struct FittedOutline {
  double factor = 1;
  Vec2 place = Vec2::Zero();  ///< [pixels]
};

/// The largest size at which a convex outline is in `room` and meets none of `covered`, to a thousandth, and
/// the nearest possible place to the centre of the room. `largest`: upper bound of the factor, and the factor
/// of an outline without extent. An outline without points is not moved.
FittedOutline fit_outline(const std::vector<Vec2>& hull, const ScreenRectangle& room,
                          const std::vector<ScreenRectangle>& covered, double largest);

}  // namespace feedscope::ui
