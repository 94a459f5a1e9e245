#pragma once

#include <functional>

#include "core/compressor/compressor.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

/// A corner of two lines, as it is given to a model that blends it.
struct CornerPlace {
  std::size_t segment = 0;  ///< that ends at the corner
  Vec3 point;               ///< [mm]
  Vec3 in;                  ///< unit directions
  Vec3 out;
  double longest = 0;    ///< what a blend may take of each line: half of the shorter one at most [mm]
  double tolerance = 0;  ///< contour tolerance [mm]
  SpeedBound feed;       ///< the lower of the two blocks'
};

/// The curve that a model lays there.
struct CornerPiece {
  ElementKind kind = ElementKind::blend;
  double transition = 0;  ///< from the corner to both ends [mm]
  double length = 0;      ///< [mm]
  MotionLimits limits;
};

using BlendCorner = std::function<CornerPiece(const CornerPlace& place)>;

/// Lays the segments of `range` into path and stretch, with static limits (segment_limits.h), and a blend
/// into every corner of two lines, for which `blend` is called in order, but where `compressor` lays smooth
/// curves. `rules`: tolerance and longest blend.
void lay_blended_stretch(const Toolpath& toolpath, const StretchRange& range, const AxisVectors& axes,
                         const PathRules& rules, Compressor& compressor, TrajectoryBuilder& builder,
                         Stretch& stretch, const BlendCorner& blend);

/// What a model allows on a span of a smooth curve besides curve_limits(); `length` of the span [mm].
using LimitSpan = std::function<void(const SpanExtremes& extremes, double length, MotionLimits& limits)>;
/// Lays a curve of the compressor into path and stretch; `toolpath`: whose segments it runs over.
void add_smooth_curve(const SmoothCurve& curve, const Toolpath& toolpath, const AxisVectors& axes,
                      TrajectoryBuilder& builder, Stretch& stretch, const LimitSpan& limit_span = {});

/// Lays the path of a whole program as lay_blended_stretch() lays it stretch by stretch, dwells included, and
/// nothing else: `blend` need not say limits; it is called by several threads.
void lay_blended_path(const Toolpath& toolpath, const Vec3& axis_velocity, const PathRules& rules,
                      const CompressorSettings& compressor, TrajectoryBuilder& builder, Progress* progress,
                      const BlendCorner& blend);

}  // namespace feedscope
