#include "ui/scene/sampled_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

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
      : trajectory_(trajectory),
        max_points_(max_points),
        in_corner_(trajectory.path().elements.size(), false) {
    for (const BlendRecord& blend : trajectory.blends()) {
      in_corner_[blend.element] = true;
    }
    for (std::size_t i = 0; i < trajectory.pieces().size(); ++i) {
      const Piece& piece = trajectory.pieces()[i];
      if (piece.law != Law::parameter && !trajectory.is_rapid(piece.element)) {
        top_speed_ = std::max({top_speed_, start_speed(i), end_speed(i)});
      }
    }
  }

  SampledPath run() {
    SampledPath path;
    const std::size_t pieces = trajectory_.pieces().size();
    if (pieces == 0) {
      return path;
    }
    std::size_t wanted = 1;
    for (std::size_t i = 0; i < pieces; ++i) {
      wanted += spans_of(i, 0);
    }
    const double spacing = spacing_for(wanted, max_points_, trajectory_.path_length());
    const std::size_t reserve = std::min(wanted, max_points_) + 2;
    path.origin = trajectory_.path().elements.front().start;
    path.positions.reserve(reserve);
    path.kinds.reserve(reserve);
    path.feeds.reserve(reserve);
    path.times.reserve(reserve);
    Sampler sampler(path, spacing);
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::size_t count = spans_of(i, spacing);
      const double step = duration_of(i) / static_cast<double>(count);
      const double span = advance_of(i) / static_cast<double>(count);
      for (std::size_t k = 0; k < count; ++k) {
        add(path, sampler, i, step * static_cast<double>(k), span);
      }
      if (feed_jumps_after(i)) {
        add(path, sampler, i, duration_of(i), 0);
      }
    }
    Sampler all(path, 0);
    add(path, all, pieces - 1, duration_of(pieces - 1), 0);
    return path;
  }

 private:
  double duration_of(std::size_t piece) const {
    return trajectory_.piece_end(piece) - trajectory_.pieces()[piece].time;
  }

  double start_speed(std::size_t index) const {
    const Piece& piece = trajectory_.pieces()[index];
    return piece.law == Law::filtered ? trajectory_.kinematics_in_piece(index, 0).velocity.norm() : piece.v;
  }

  double end_speed(std::size_t index) const {
    const Piece& piece = trajectory_.pieces()[index];
    const double duration = duration_of(index);
    if (piece.law == Law::filtered) {
      return trajectory_.kinematics_in_piece(index, duration).velocity.norm();
    }
    return piece.v + duration * (piece.a + duration * piece.j / 2);
  }

  /// At the latest where the piece ends, q has gone this far, [mm] or blend parameter.
  double course_of(std::size_t index) const {
    const Piece& piece = trajectory_.pieces()[index];
    const double duration = duration_of(index);
    return duration *
           (std::abs(piece.v) + duration * (std::abs(piece.a) / 2 + duration * std::abs(piece.j) / 6));
  }

  /// The same as a length [mm].
  double advance_of(std::size_t index) const {
    const Piece& piece = trajectory_.pieces()[index];
    if (piece.law == Law::filtered) {
      return trajectory_.piece_length(index);
    }
    const double length = trajectory_.path().elements[piece.element].length;
    return course_of(index) * (piece.law == Law::parameter ? length : 1.0);
  }

  /// A model may change the feed at once; colours must not flow over the whole span then.
  bool feed_jumps_after(std::size_t index) const {
    if (index + 1 == trajectory_.pieces().size()) {
      return false;
    }
    const Piece& next = trajectory_.pieces()[index + 1];
    const bool both_by_length =
        next.law == Law::path_length && trajectory_.pieces()[index].law == Law::path_length;
    return both_by_length && std::abs(next.v - end_speed(index)) > top_speed_ / (10 * feed_steps);
  }

  /// Filters round every corner; those slowed for the tolerance are shown as blends.
  SpanKind kind_of(std::size_t index) const {
    const Piece& piece = trajectory_.pieces()[index];
    if (trajectory_.is_rapid(piece.element)) {
      return SpanKind::rapid;
    }
    const bool blend = piece.law == Law::filtered ? piece.cause.kind == CauseKind::contour_tolerance
                                                  : bool{in_corner_[piece.element]};
    return blend ? SpanKind::blend : SpanKind::cut;
  }

  std::size_t spans_of(std::size_t index, double spacing) const {
    const Piece& piece = trajectory_.pieces()[index];
    const PathElement& element = trajectory_.path().elements[piece.element];
    if (piece.law == Law::filtered) {
      return spans(trajectory_.filtered_spans(index, spans_a_filter_time), advance_of(index), spacing);
    }
    const double duration = duration_of(index);
    const double course = course_of(index);
    double wanted = 1;
    if (piece.law == Law::parameter) {
      wanted = spans_of_blend * course;
    } else if (!trajectory_.is_rapid(piece.element) && top_speed_ > 0) {
      const double change = duration * (std::abs(piece.a) + duration * std::abs(piece.j) / 2);
      wanted = std::min(feed_steps, feed_steps * change / top_speed_);
    }
    if (element.kind == ElementKind::arc) {
      wanted = std::max(wanted, spans_of_arc(trajectory_.path().arcs[element.geometry], course));
    } else if (element.kind == ElementKind::blend && piece.law == Law::path_length && element.length > 0) {
      wanted = std::max(wanted, spans_of_blend * course / element.length);
    }
    return spans(wanted, advance_of(index), spacing);
  }

  void add(SampledPath& path, Sampler& sampler, std::size_t piece, double tau, double span) const {
    const State state = trajectory_.state_in_piece(piece, tau);
    const SpanKind kind = kind_of(piece);
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
  std::vector<bool> in_corner_;  ///< elements that the control put into corners
  double top_speed_ = 0;         ///< [mm/s]
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
