#include "ui/scene/sampled_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope::ui {
namespace {

constexpr double arc_step = units::pi / 60;  // [rad]
constexpr double spans_of_blend = 24;
constexpr double feed_steps = 24;

/// Appends points, leaving out those closer than `spacing` to the one before, and keeps the bounds.
class Sampler {
 public:
  Sampler(SampledPath& path, double spacing) : path_(path), spacing_(static_cast<float>(spacing)) {}

  /// False if the point was left out.
  bool add(const Vec3& position, SpanKind next) {
    path_.bounds.add(position);
    const Eigen::Vector3f offset = (position - path_.origin).cast<float>();
    if (spacing_ > 0 && !path_.positions.empty() && (offset - path_.positions.back()).norm() < spacing_) {
      return false;
    }
    path_.positions.push_back(offset);
    path_.kinds.push_back(next);
    return true;
  }

 private:
  SampledPath& path_;
  float spacing_;
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
    sampler.add(toolpath.start_of(i), kind);
    const std::size_t count = spans_of(segment, spacing);
    for (std::size_t k = 1; k < count; ++k) {
      const double s = segment.length * static_cast<double>(k) / static_cast<double>(count);
      sampler.add(toolpath.arcs[static_cast<std::size_t>(segment.arc)].at(s).position, kind);
    }
  }
  sampler.add(toolpath.segments.back().end, SpanKind::cut);
  return path;
}

namespace {

/// Counts and draws the samples of one trajectory.
class ExecutedSampling {
 public:
  ExecutedSampling(const Trajectory& trajectory, std::size_t max_points)
      : trajectory_(trajectory), max_points_(max_points) {
    for (std::size_t i = 0; i < trajectory.pieces().size(); ++i) {
      const Piece& piece = trajectory.pieces()[i];
      if (piece.law == Law::path_length && !trajectory.is_rapid(piece.element)) {
        const double tau = trajectory.piece_end(i) - piece.time;
        top_speed_ = std::max({top_speed_, piece.v, piece.v + tau * (piece.a + tau * piece.j / 2)});
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
      const double begin = trajectory_.pieces()[i].time;
      const double duration = trajectory_.piece_end(i) - begin;
      const std::size_t count = spans_of(i, spacing);
      for (std::size_t k = 0; k < count; ++k) {
        add(path, sampler, i, duration * static_cast<double>(k) / static_cast<double>(count));
      }
    }
    const double last = trajectory_.duration() - trajectory_.pieces().back().time;
    Sampler(path, 0).add(end_point(), path.kinds.back());
    const State end = trajectory_.state_in_piece(pieces - 1, last);
    path.feeds.push_back(static_cast<float>(end.speed));
    path.times.push_back(trajectory_.duration());
    return path;
  }

 private:
  Vec3 end_point() const { return trajectory_.path().elements.back().end; }

  SpanKind kind_of(std::uint32_t element) const {
    if (trajectory_.is_rapid(element)) {
      return SpanKind::rapid;
    }
    return trajectory_.path().elements[element].kind == ElementKind::blend ? SpanKind::blend : SpanKind::cut;
  }

  std::size_t spans_of(std::size_t index, double spacing) const {
    const Piece& piece = trajectory_.pieces()[index];
    const PathElement& element = trajectory_.path().elements[piece.element];
    const double duration = trajectory_.piece_end(index) - piece.time;
    const double change = duration * (std::abs(piece.a) + duration * std::abs(piece.j) / 2);
    const double advance = duration * (std::abs(piece.v) +
                                       duration * (std::abs(piece.a) / 2 + duration * std::abs(piece.j) / 6));
    double wanted = 1;
    double length = advance;
    if (piece.law == Law::parameter) {
      wanted = spans_of_blend * advance;
      length = element.length * advance;
    } else if (!trajectory_.is_rapid(piece.element) && top_speed_ > 0) {
      wanted = std::min(feed_steps, feed_steps * change / top_speed_);
    }
    if (element.kind == ElementKind::arc) {
      wanted = std::max(wanted, spans_of_arc(trajectory_.path().arcs[element.geometry], advance));
    } else if (element.kind == ElementKind::blend && piece.law == Law::path_length && element.length > 0) {
      wanted = std::max(wanted, spans_of_blend * advance / element.length);
    }
    return spans(wanted, length, spacing);
  }

  void add(SampledPath& path, Sampler& sampler, std::size_t piece, double tau) const {
    const State state = trajectory_.state_in_piece(piece, tau);
    const SpanKind kind = kind_of(state.element);
    if (kind != SpanKind::rapid) {
      path.peak_feed = std::max(path.peak_feed, state.speed);
    }
    if (sampler.add(state.position, kind)) {
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
    if (!last && i > 0 && (path.positions[i] - kept.positions.back()).squaredNorm() < limit) {
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
