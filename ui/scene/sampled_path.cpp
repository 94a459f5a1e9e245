#include "ui/scene/sampled_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/trajectory/part_walk.h"

namespace feedscope::ui {
namespace {

constexpr double arc_step = units::pi / 60;  // [rad]
constexpr double spans_of_blend = 24;
constexpr double feed_steps = 24;
constexpr double spans_a_filter_time = 8;

/// Appends points and keeps the bounds. A point closer than `spacing` to the one before is left out, unless a
/// longer span begins at it: that one must have its own feed.
class Sampler {
 public:
  Sampler(SampledPath& path, double spacing) : path_(path), spacing_(spacing) {}

  /// `span`: length up to the next point [mm]. False if the point was left out.
  bool add(const Vec3& position, SpanKind kind, double span) {
    path_.bounds.add(position);
    const Eigen::Vector3f offset = (position - path_.origin).cast<float>();
    if (span < spacing_ && !path_.positions.empty() &&
        static_cast<double>((offset - path_.positions.back()).norm()) < spacing_) {
      return false;
    }
    path_.positions.push_back(offset);
    path_.kinds.push_back(kind);
    return true;
  }

 private:
  SampledPath& path_;
  double spacing_;
};

std::size_t spans(double wanted, double length, double spacing) {
  const double possible = spacing > 0 ? std::ceil(length / spacing) : wanted;
  return static_cast<std::size_t>(std::max(1.0, std::ceil(std::min(wanted, possible))));
}

double spans_of_arc(const Arc& arc, double length) {
  return length / arc.length_per_radian() / arc_step;
}

/// How far apart points must be for at most `max_points` of them; 0 if all `wanted` may be kept [mm].
double spacing_for(std::size_t wanted, std::size_t max_points, double length) {
  return wanted <= max_points ? 0.0 : length / static_cast<double>(max_points);
}

}  // namespace

SampledPath sample_programmed(const Toolpath& toolpath, std::size_t max_points) {
  SampledPath path;
  if (toolpath.segments.empty()) {
    return path;
  }
  const auto spans_of = [&](const Segment& segment, double spacing) {
    const double wanted =
        segment.kind == SegmentKind::arc
            ? spans_of_arc(toolpath.arcs[static_cast<std::size_t>(segment.arc)], segment.length)
            : 1.0;
    return spans(wanted, segment.length, spacing);
  };
  std::size_t wanted = 1;
  for (const Segment& segment : toolpath.segments) {
    wanted += spans_of(segment, 0);
  }
  const double spacing = spacing_for(wanted, max_points, toolpath.length());

  path.origin = toolpath.start;
  path.positions.reserve(std::min(wanted, max_points) + 1);
  path.kinds.reserve(std::min(wanted, max_points) + 1);
  Sampler sampler(path, spacing);
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    if (segment.kind == SegmentKind::dwell) {
      continue;
    }
    const SpanKind kind = segment.rapid ? SpanKind::rapid : SpanKind::cut;
    const std::size_t count = spans_of(segment, spacing);
    const double span = segment.length / static_cast<double>(count);
    sampler.add(toolpath.start_of(i), kind, span);
    for (std::size_t k = 1; k < count; ++k) {
      const Arc& arc = toolpath.arcs[static_cast<std::size_t>(segment.arc)];
      sampler.add(arc.at(span * static_cast<double>(k)).position, kind, span);
    }
  }
  Sampler(path, 0).add(toolpath.segments.back().end, SpanKind::cut, 0);
  return path;
}

namespace {

/// Counts and draws the samples of one trajectory.
class ExecutedSampling {
 public:
  ExecutedSampling(const Trajectory& trajectory, std::size_t max_points)
      : trajectory_(trajectory), max_points_(max_points) {
    for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
      const Part& part = walk.part();
      if (part.law != Law::parameter && !trajectory.is_rapid(part.element)) {
        const PartMotion motion = walk.motion();
        top_speed_ = std::max({top_speed_, speed_in(motion, part, 0), speed_in(motion, part, part.duration)});
      }
    }
  }

  SampledPath run() {
    SampledPath path;
    if (trajectory_.pieces().empty()) {
      return path;
    }
    std::size_t wanted = 1;
    for (PartWalk walk(trajectory_); !walk.done(); walk.next()) {
      wanted += spans_of(walk.part(), 0);
    }
    const double spacing = spacing_for(wanted, max_points_, trajectory_.path_length());
    const std::size_t reserve = std::min(wanted, max_points_) + 2;
    path.origin = trajectory_.path().element(0).start;
    path.positions.reserve(reserve);
    path.kinds.reserve(reserve);
    path.feeds.reserve(reserve);
    path.times.reserve(reserve);
    Sampler sampler(path, spacing);
    Part last;
    for (PartWalk walk(trajectory_); !walk.done(); walk.next()) {
      if (path.size() > 0 && feed_jumps(last, walk.part())) {
        add(path, sampler, PartMotion(trajectory_, last), last, last.duration, 0);
      }
      last = walk.part();
      const std::size_t count = spans_of(last, spacing);
      const double step = last.duration / static_cast<double>(count);
      const double span = advance_of(last) / static_cast<double>(count);
      const PartMotion motion = walk.motion();
      for (std::size_t k = 0; k < count; ++k) {
        add(path, sampler, motion, last, step * static_cast<double>(k), span);
      }
    }
    Sampler all(path, 0);
    add(path, all, PartMotion(trajectory_, last), last, last.duration, 0);
    return path;
  }

 private:
  static double speed_in(const PartMotion& motion, const Part& part, double tau) {
    return part.law == Law::filtered ? motion.kinematics(tau).velocity.norm()
                                     : advance({part.q, part.v, part.a, part.j}, tau).v;
  }

  /// At the latest where the part ends, q has gone this far, [mm] or blend parameter.
  static double course_of(const Part& part) {
    return advance({0, std::abs(part.v), std::abs(part.a), std::abs(part.j)}, part.duration).q;
  }

  /// The same as a length [mm].
  double advance_of(const Part& part) const {
    if (part.law == Law::filtered) {
      return trajectory_.filtered_length(part);
    }
    return course_of(part) * (part.law == Law::parameter ? trajectory_.path().length(part.element) : 1.0);
  }

  /// A model may change the feed at once; colours must not flow over the whole span then.
  bool feed_jumps(const Part& before, const Part& next) const {
    return next.law == Law::path_length && before.law == Law::path_length &&
           std::abs(next.v - advance({0, before.v, before.a, before.j}, before.duration).v) >
               top_speed_ / (10 * feed_steps);
  }

  /// Filters round every corner; those slowed for the tolerance are shown as blends.
  SpanKind kind_of(const Part& part) const {
    if (trajectory_.is_rapid(part.element)) {
      return SpanKind::rapid;
    }
    const bool blend = part.law == Law::filtered ? part.cause.kind == CauseKind::contour_tolerance
                                                 : trajectory_.path().in_corner(part.element);
    return blend ? SpanKind::blend : SpanKind::cut;
  }

  std::size_t spans_of(const Part& part, double spacing) const {
    if (part.law == Law::filtered) {
      return spans(trajectory_.filtered_spans(part, spans_a_filter_time), advance_of(part), spacing);
    }
    const BlendedPath& path = trajectory_.path();
    const double course = course_of(part);
    double wanted = 1;
    if (part.law == Law::parameter) {
      wanted = spans_of_blend * course;
    } else if (!trajectory_.is_rapid(part.element) && top_speed_ > 0) {
      const double change = part.duration * (std::abs(part.a) + part.duration * std::abs(part.j) / 2);
      wanted = std::min(feed_steps, feed_steps * change / top_speed_);
    }
    const ElementKind kind = path.kind(part.element);
    if (kind == ElementKind::arc || kind == ElementKind::connecting_arc) {
      wanted = std::max(wanted, spans_of_arc(path.curve(part.element).arc, course));
    } else if (kind == ElementKind::blend && part.law == Law::path_length && path.length(part.element) > 0) {
      wanted = std::max(wanted, spans_of_blend * course / path.length(part.element));
    }
    return spans(wanted, advance_of(part), spacing);
  }

  void add(SampledPath& path, Sampler& sampler, const PartMotion& motion, const Part& part, double tau,
           double span) const {
    const State state = motion.state(tau);
    const SpanKind kind = kind_of(part);
    if (kind != SpanKind::rapid) {
      path.peak_feed = std::max(path.peak_feed, state.speed);
    }
    if (sampler.add(state.position, kind, span)) {
      path.feeds.push_back(static_cast<float>(state.speed));
      path.times.push_back(state.time);
    }
  }

  const Trajectory& trajectory_;
  std::size_t max_points_;
  double top_speed_ = 0;  ///< [mm/s]
};

}  // namespace

SampledPath sample_executed(const Trajectory& trajectory, std::size_t max_points) {
  return ExecutedSampling(trajectory, max_points).run();
}

SampledPath thinned(const SampledPath& path, double spacing) {
  SampledPath kept;
  kept.origin = path.origin;
  kept.peak_feed = path.peak_feed;
  kept.bounds = path.bounds;
  const auto limit = static_cast<float>(spacing * spacing);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool last = i + 1 == path.size();
    if (!last && i > 0 && (path.positions[i] - kept.positions.back()).squaredNorm() < limit &&
        (path.positions[i + 1] - path.positions[i]).squaredNorm() < limit) {
      continue;
    }
    kept.positions.push_back(path.positions[i]);
    kept.kinds.push_back(path.kinds[i]);
    if (!path.feeds.empty()) {
      kept.feeds.push_back(path.feeds[i]);
      kept.times.push_back(path.times[i]);
    }
  }
  return kept;
}

double length_of(const SampledPath& path, SpanKind kind) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path.kinds[i] == kind) {
      length += static_cast<double>((path.positions[i + 1] - path.positions[i]).norm());
    }
  }
  return length;
}

}  // namespace feedscope::ui
