#include "core/trajectory/blended_stretch.h"

#include <algorithm>

#include "core/blend/junction.h"

namespace feedscope {
namespace {

/// A line shorter than this [mm] between two blends is omitted.
constexpr double min_line = 1e-12;

/// Blends that would leave less than this of the line between them [mm] meet: a hundredth of a nanometre is
/// rounding of the coordinates, and even a very short line is a place where the law of a model may change.
constexpr double meeting = 1e-8;

/// Corner at the end of `segment`. `left`: length of the segment after the corner before it [mm].
CornerPlace corner_behind(const Toolpath& toolpath, const PathRules& rules, std::size_t segment, double left,
                          const Vec3& velocity) {
  const Segment& before = toolpath.segments[segment];
  const Segment& after = toolpath.segments[segment + 1];
  CornerPlace place;
  place.segment = segment;
  place.point = before.end;
  place.in = toolpath.tangent_at_end(segment);
  place.out = toolpath.tangent_at_start(segment + 1);
  place.longest = std::min(std::min(before.length, after.length) / 2, rules.longest_blend(segment));
  if (std::abs(left - place.longest) < meeting) {
    place.longest = left;
  }
  place.tolerance = rules.corner_tolerance(segment);
  place.feed = corner_ceiling(toolpath, segment, velocity);
  return place;
}

/// Calls `laid_segment(index, block, length, part)` for each part of a segment, `laid_corner(index, block,
/// piece)` for each corner, and `lay_curve(curve)` to lay each of `curves`, smooth ones in their order.
template <typename LaidSegment, typename LaidCorner, typename LayCurve>
void lay_elements(const Toolpath& toolpath, const StretchRange& range, const Vec3& axis_velocity,
                  const PathRules& rules, const std::vector<SmoothCurve>& curves, TrajectoryBuilder& builder,
                  const BlendCorner& blend, const LaidSegment& laid_segment, const LaidCorner& laid_corner,
                  const LayCurve& lay_curve) {
  const auto lay_segment = [&](std::uint32_t block, double begin, double length) {
    if (toolpath.segments[block].kind == SegmentKind::arc || toolpath.turn_parts_of(block).empty()) {
      laid_segment(builder.add_segment(block, length), block, length, nullptr);
      return;
    }
    for_turn_parts(toolpath, block, begin, begin + length, [&](const TurnPart* part, double from, double to) {
      laid_segment(builder.add_segment(block, to - from), block, to - from, part);
    });
  };
  auto curve = curves.begin();
  double cut_before = 0;
  for (std::size_t i = range.first; i < range.last; ++i) {
    for (; curve != curves.end() && curve->run.first == i; ++curve) {
      const auto block = static_cast<std::uint32_t>(i);
      if (const double length = curve->run.begin - cut_before; length > min_line) {
        lay_segment(block, cut_before, length);
      }
      lay_curve(*curve);
      i = curve->run.last;
      cut_before = curve->run.end;
    }
    const Segment& segment = toolpath.segments[i];
    const auto block = static_cast<std::uint32_t>(i);
    const bool corner = i + 1 < range.last && junction_kind(toolpath, i + 1) == JunctionKind::corner;
    CornerPlace place;
    CornerPiece piece;
    if (corner) {
      place = corner_behind(toolpath, rules, i, segment.length - cut_before, axis_velocity);
      piece = blend(place);
    }
    const double length = segment.length - cut_before - piece.transition;
    if (length > min_line) {
      lay_segment(block, cut_before, length);
    }
    if (corner) {
      laid_corner(builder.add_corner(piece.kind, block, piece.transition, piece.length), block, piece);
    }
    cut_before = piece.transition;
  }
}

/// Upper bound of the elements of range and curves: a line and a blend for each block, and the spans in place
/// of the blocks that a curve covers.
std::size_t most_elements(const StretchRange& range, const std::vector<SmoothCurve>& curves) {
  std::size_t count = 2 * (range.last - range.first);
  for (const SmoothCurve& curve : curves) {
    count += curve.blocks.size() + 2;
    count -= 2 * (curve.run.last - curve.run.first);
  }
  return count;
}

void add_curve_alone(const SmoothCurve& curve, TrajectoryBuilder& builder) {
  builder.begin_curve(curve.knots.front());
  for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
    builder.add_curve(curve.blocks[k], curve.knots[k + 1]);
  }
}

}  // namespace

void add_smooth_curve(const SmoothCurve& curve, const Toolpath& toolpath, const AxisVectors& axes,
                      TrajectoryBuilder& builder, Stretch& stretch, const LimitSpan& limit_span) {
  builder.begin_curve(curve.knots.front());
  for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
    const CourseSpan span(curve.knots[k], curve.knots[k + 1]);
    const SpanExtremes extremes(span);
    const std::uint32_t block = curve.blocks[k];
    const std::size_t end = k + 1 < curve.blocks.size() ? curve.blocks[k + 1] : curve.run.last;
    SpeedBound feed = feed_ceiling(toolpath, block, axes.velocity);
    for (std::size_t other = block + std::size_t{1}; other <= end; ++other) {
      for (const SpeedBound& next :
           {feed_ceiling(toolpath, other, axes.velocity), turn_ceiling(toolpath, other - 1)}) {
        feed.lower(next.value, next.cause);
      }
    }
    MotionLimits limits = curve_limits(extremes, feed, axes);
    if (limit_span) {
      limit_span(extremes, span.length(), limits);
    }
    limits = with_turns(limits, toolpath, block, end);
    for (std::size_t on = block; on <= end; ++on) {
      limits = with_joints(limits, toolpath, on, curve.run.first, curve.run.last + std::size_t{1});
    }
    stretch.add_span({span.length(), limits}, builder.add_curve(block, curve.knots[k + 1]), block);
  }
}

void lay_blended_stretch(const Toolpath& toolpath, const StretchRange& range, const AxisVectors& axes,
                         const PathRules& rules, Compressor& compressor, TrajectoryBuilder& builder,
                         Stretch& stretch, const BlendCorner& blend) {
  const std::vector<SmoothCurve> curves = compressor.compress(range.first, range.last, builder.progress());
  stretch.clear();
  stretch.reserve(most_elements(range, curves));
  lay_elements(
      toolpath, range, axes.velocity, rules, curves, builder, blend,
      [&](std::uint32_t index, std::uint32_t block, double length, const TurnPart* part) {
        const MotionLimits limits = with_joints(segment_limits(toolpath, block, axes, part), toolpath, block,
                                                range.first, range.last);
        stretch.add({length, limits}, index, block);
      },
      [&](std::uint32_t index, std::uint32_t block, const CornerPiece& piece) {
        MotionLimits limits = with_turns_in_corner(piece.limits, toolpath, block, range.first, range.last,
                                                   piece.transition, piece.length);
        const SpeedBound turning = turning_speed_in_corner(builder.path(), index);
        limits.speed.lower(turning.value, turning.cause);
        stretch.add({piece.length, limits}, index, block, true);
      },
      [&](const SmoothCurve& curve) { add_smooth_curve(curve, toolpath, axes, builder, stretch); });
}

void lay_blended_path(const Toolpath& toolpath, const Vec3& axis_velocity, const PathRules& rules,
                      const CompressorSettings& compressor, TrajectoryBuilder& builder, Progress* progress,
                      const BlendCorner& blend) {
  run_stretches(toolpath, builder, progress, rules, [&](TrajectoryBuilder& part) -> StretchRun {
    const auto curves = std::make_shared<Compressor>(toolpath, rules, compressor);
    return [&, curves](const StretchRange& range, ProgressSteps& /*steps*/) {
      const auto ignore = [](auto&&...) {};
      lay_elements(toolpath, range, axis_velocity, rules,
                   curves->compress(range.first, range.last, part.progress()), part, blend, ignore, ignore,
                   [&](const SmoothCurve& curve) { add_curve_alone(curve, part); });
    };
  });
}

}  // namespace feedscope
