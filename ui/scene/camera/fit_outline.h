#pragma once

#include <vector>

#include "ui/scene/camera/projection.h"

namespace feedscope::ui {

/// The corners of the convex hull, anticlockwise: one where all points are the same, two where they are on a
/// line.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// The least rectangle with all of the points, of which there is one at least.
ScreenRectangle box_around(const std::vector<Vec2>& points);

/// Where an outline is put: its point p goes to place + factor * p.
struct FittedOutline {
  double factor = 1;
  Vec2 place = Vec2::Zero();  ///< [pixels]
};

/// The largest size of a convex outline at which it is in `room` and meets none of `covered`, to a
/// thousandth, and the place nearest to the middle of the room where that is so. `largest`: factor of an
/// outline without extent, and of none exceeded. One without points stays.
FittedOutline fit_outline(const std::vector<Vec2>& hull, const ScreenRectangle& room,
                          const std::vector<ScreenRectangle>& covered, double largest);

}  // namespace feedscope::ui
