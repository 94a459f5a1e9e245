#pragma once

#include <functional>

#include "core/compressor/compressor.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

/// A corner of two lines, as given to a model that blends it.
struct CornerPlace {
  std::size_t segment = 0;  ///< the one that ends at the corner
  Vec3 point;               ///< [mm]
  Vec3 in;                  ///< unit directions
  Vec3 out;
  double longest = 0;    ///< largest length of a blend on each line: half of the shorter one at most [mm]
  double tolerance = 0;  ///< contour tolerance [mm]
  SpeedBound feed;       ///< the lower feed of the two blocks
};

/// Curve that a model lays in a corner.
struct CornerPiece {
  ElementKind kind = ElementKind::blend;
  double transition = 0;  ///< from the corner to both ends [mm]
  double length = 0;      ///< [mm]
  MotionLimits limits;
};

using BlendCorner = std::function<CornerPiece(const CornerPlace& place)>;

/// Lays the segments of `range` into path and stretch, with static limits (segment_limits.h). Lays a blend
/// into every corner of two lines, for which it calls `blend` in order, except where `compressor` lays smooth
/// curves. `rules`: tolerance and longest blend.
void lay_blended_stretch(const Toolpath& toolpath, const StretchRange& range, const AxisVectors& axes,
                         const PathRules& rules, Compressor& compressor, TrajectoryBuilder& builder,
                         Stretch& stretch, const BlendCorner& blend);

/// Adds a model's own limits on a span of a smooth curve to those of curve_limits(); `length` of the span
/// [mm].
using LimitSpan = std::function<void(const SpanExtremes& extremes, double length, MotionLimits& limits)>;
/// Lays a curve of the compressor into path and stretch; `toolpath`: of the segments that it covers.
void add_smooth_curve(const SmoothCurve& curve, const Toolpath& toolpath, const AxisVectors& axes,
                      TrajectoryBuilder& builder, Stretch& stretch, const LimitSpan& limit_span = {});

/// Lays the path of a whole program as lay_blended_stretch() does stretch by stretch, including dwells, and
/// nothing else. `blend` need not set limits; several threads call it.
void lay_blended_path(const Toolpath& toolpath, const Vec3& axis_velocity, const PathRules& rules,
                      const CompressorSettings& compressor, TrajectoryBuilder& builder, Progress* progress,
                      const BlendCorner& blend);

}  // namespace feedscope
