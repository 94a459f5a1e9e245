#include "core/models/msaddek/msaddek_stretch.h"

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"
#include "core/trajectory/blended_stretch.h"
#include "core/trajectory/curve_motion.h"

namespace feedscope {
namespace {

/// A piece of line shorter than this [mm] is omitted.
constexpr double min_line = 1e-12;

}  // namespace

MsaddekRunner::MsaddekRunner(const Toolpath& programmed, const CompactedPath& compacted,
                             const PathRules& rules, const AxisVectors& axes, const MsaddekSettings& settings,
                             TrajectoryBuilder& builder)
    : programmed_(programmed),
      compacted_(compacted),
      rules_(rules),
      axes_(axes),
      settings_(settings),
      builder_(builder),
      compressor_(compacted.path, rules, settings.compressor) {}

void MsaddekRunner::run(const StretchRange& range, ProgressSteps& steps) {
  const auto chord_of = [&](std::size_t segment) {
    const auto chord = std::lower_bound(compacted_.first.begin(), compacted_.first.end(), segment);
    return static_cast<std::size_t>(chord - compacted_.first.begin());
  };
  const std::size_t last = chord_of(range.last);
  for (std::size_t chord = chord_of(range.first); chord < last;) {
    StretchRange chords = next_stretch(compacted_.path, rules_, chord);
    chords.last = std::min(chords.last, last);
    lay_path(chords);
    if (settings_.law == MsaddekLaw::static_feed) {
      move_static(steps);
    } else {
      move_dynamic(steps);
    }
    chord = chords.last;
  }
}

void MsaddekRunner::lay_path(const StretchRange& chords) {
  const Toolpath& path = compacted_.path;
  stretch_.clear();
  const std::vector<SmoothCurve> curves =
      compressor_.compress(chords.first, chords.last, builder_.progress());
  auto curve = curves.begin();
  double cut_before = 0;
  for (std::size_t i = chords.first; i < chords.last; ++i) {
    for (; curve != curves.end() && curve->run.first == i; ++curve) {
      add_line(i, cut_before, path.segments[i].length - curve->run.begin, static_limits(i, chords), chords);
      add_curve(*curve);
      i = curve->run.last;
      cut_before = curve->run.end;
    }
    const MotionLimits limits = static_limits(i, chords);
    if (path.segments[i].kind == SegmentKind::arc) {
      add_arc(i, limits);
      continue;
    }
    ConnectingArc connection;
    if (i + 1 < chords.last && junction_kind(path, i + 1) == JunctionKind::corner) {
      // No arc is longer than half of the shorter block, and none begins earlier than the rules allow.
      const double shorter =
          std::min({path.segments[i].length, path.segments[i + 1].length, 2 * rules_.longest_blend(i)});
      connection = connecting_arc(path.segments[i].end, path.tangent_at_end(i), path.tangent_at_start(i + 1),
                                  shorter, rules_.corner_tolerance(i));
    }
    add_line(i, cut_before, connection.transition, limits, chords);
    if (connection.transition > 0) {
      add_connection(i, chords, connection);
    }
    cut_before = connection.transition;
  }
}

MotionLimits MsaddekRunner::static_limits(std::size_t segment, const StretchRange& chords,
                                          const TurnPart* part) const {
  const Toolpath& path = compacted_.path;
  MotionLimits limits =
      with_joints(segment_limits(path, segment, axes_, part), path, segment, chords.first, chords.last);
  limits.speed.lower(path.segments[segment].length / settings_.period, {CauseKind::interpolation_period});
  if (path.segments[segment].kind == SegmentKind::arc) {
    const Arc& arc = path.arc_of(path.segments[segment]);
    lower_by_curvature(limits.speed, arc.curvature());
  }
  return limits;
}

void MsaddekRunner::lower_by_curvature(SpeedBound& speed, double k) const {
  speed.lower(std::cbrt(settings_.curvature_jerk / (k * k)), {CauseKind::curvilinear_jerk});
}

void MsaddekRunner::add_line(std::size_t segment, double cut_before, double cut_after,
                             const MotionLimits& limits, const StretchRange& chords) {
  const Toolpath& path = compacted_.path;
  const Vec3& start = path.start_of(segment);
  const Vec3 direction = path.tangent_at_start(segment);
  const double end = path.segments[segment].length - cut_after;
  const std::uint32_t last = compacted_.first[segment + 1];
  double from = cut_before;
  for (std::uint32_t block = compacted_.first[segment]; block < last; ++block) {
    // Each programmed block keeps its part of a chord.
    const Segment& programmed = programmed_.segments[block];
    const double to = block + 1 == last ? end : std::min(end, (programmed.end - start).dot(direction));
    if (to - from <= min_line) {
      continue;
    }
    for_turn_parts(path, segment, from, to, [&](const TurnPart* part, double begin, double part_end) {
      const MotionLimits of_part = part != nullptr ? static_limits(segment, chords, part) : limits;
      const double length = part != nullptr ? part_end - begin : to - from;
      stretch_.add({length, of_part}, builder_.add_segment(block, length),
                   static_cast<std::uint32_t>(segment));
    });
    from = to;
  }
}

void MsaddekRunner::add_arc(std::size_t segment, const MotionLimits& limits) {
  const std::uint32_t block = compacted_.first[segment];
  stretch_.add({programmed_.segments[block].length, limits}, builder_.add_segment(block),
               static_cast<std::uint32_t>(segment));
}

void MsaddekRunner::add_curve(const SmoothCurve& curve) {
  add_smooth_curve(curve, compacted_.path, axes_, builder_, stretch_,
                   [&](const SpanExtremes& extremes, double length, MotionLimits& limits) {
                     limits.speed.lower(length / settings_.period, {CauseKind::interpolation_period});
                     lower_by_curvature(limits.speed, extremes.curvature);
                   });
}

void MsaddekRunner::add_connection(std::size_t segment, const StretchRange& chords,
                                   const ConnectingArc& connection) {
  const Toolpath& path = compacted_.path;
  const SpeedBound feed = corner_ceiling(path, segment, axes_.velocity);

  const Arc& arc = connection.arc;
  const double length = arc.length();
  const std::uint32_t index = builder_.add_corner(
      ElementKind::connecting_arc, compacted_.first[segment + 1] - 1, connection.transition, length);
  MotionLimits limits = arc_limits(arc, feed, axes_);
  limits.speed.lower(length / settings_.period, {CauseKind::interpolation_period});
  lower_by_curvature(limits.speed, arc.curvature());
  limits =
      with_turns_in_corner(limits, path, segment, chords.first, chords.last, connection.transition, length);
  const SpeedBound turning = turning_speed_in_corner(builder_.path(), index);
  limits.speed.lower(turning.value, turning.cause);
  stretch_.add({length, limits}, index, static_cast<std::uint32_t>(segment));
}

void MsaddekRunner::move_static(ProgressSteps& steps) {
  for (std::size_t e = 0; e < stretch_.plan.size(); ++e) {
    steps.at(builder_.path().segment(stretch_.element(e)));
    const SpeedBound speed = stretch_.plan[e].speed();
    builder_.add_piece({0, 0, speed.value, 0, 0, stretch_.element(e), speed.cause},
                       stretch_.plan[e].length / speed.value);
  }
}

void MsaddekRunner::move_dynamic(ProgressSteps& steps) {
  follow_acceleration_mode(stretch_, builder_.path(), rules_, settings_.period);
  move_over_curves(builder_, stretch_, axes_, [&] {
    set_junction_ceilings(stretch_, builder_.path(), axes_.jerk, settings_.period, settings_.lookahead);
    part_turning(stretch_, builder_.path());
    add_planned_motion(builder_, stretch_, plan_nodes(stretch_.plan, stretch_.ceiling, stretch_.held()),
                       steps);
  });
}

}  // namespace feedscope
