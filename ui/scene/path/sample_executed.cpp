
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "core/analysis/contour/path_deviation.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/trajectory/part_walk.h"
#include "core/trajectory/state_walk.h"
#include "ui/scene/path/sample_tool_axes.h"
#include "ui/scene/path/sampler.h"

namespace feedscope::ui {
namespace {

constexpr double turn_of_corner_span = units::pi / 90;  // of a corner: its curvature has peaks [rad]
constexpr double most_spans_of_corner = 24;
// As fractions of the path's size; a picture of it is some thousand pixels wide.
constexpr double seen_of_chord = 1e-6;  // largest distance between a span and a blend
constexpr double seen_of_jump = 5e-5;   // shortest part whose colours start and end at once
constexpr double spans_of_curve = 8;    // a span of a smooth curve turns little
constexpr double feed_steps = 24;
constexpr double spans_a_filter_time = 8;
constexpr double share_of_actual = 0.4;  // of the computing time with drives
constexpr double share_on_machine = 0.3;

/// `has`: whether the path has values at this index.
template <typename Has>
void reserve(SampledPath& path, std::size_t points, Has has) {
  path.positions.reserve(points);
  path.kinds.reserve(points);
  path.times.reserve(points);
  path.causes.reserve(points);
  for (std::size_t quantity = 0; quantity < own_sampled_count; ++quantity) {
    if (has(quantity)) {
      path.values[quantity].reserve(points);
    }
  }
}

const Toolpath& programmed_of(const Trajectory& trajectory) {
  static const Toolpath nothing;
  return trajectory.path().programmed() ? *trajectory.path().programmed() : nothing;
}

bool compacted(const Trajectory& trajectory) {
  return &trajectory.path().base() != trajectory.path().programmed().get();
}

double extent_of(const Bounds& bounds) {
  return bounds.empty() ? 0 : (bounds.max - bounds.min).norm();
}

constexpr std::size_t pieces_a_chunk = 1024;

/// Consecutive parts sampled by one thread; independent of the number of threads.
struct Chunk {
  std::size_t piece = 0;   ///< first
  std::size_t end = 0;     ///< after the last
  std::size_t wanted = 0;  ///< points, if none is omitted
  std::optional<Part> before;
};

/// Samples one trajectory, or a chunk of it.
class ExecutedSampling {
 public:
  ExecutedSampling(const Trajectory& trajectory, std::span<const double> also_at, const RunSources& sources)
      : trajectory_(trajectory),
        origin_(local_origin(programmed_of(trajectory))),
        extent_(extent_of(programmed_of(trajectory).bounds)),
        also_at_(also_at),
        sources_(sources) {
    for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
      const Part& part = walk.part();
      cause_times_[static_cast<std::size_t>(part.cause.kind)] += part.duration;
      if (part.law == Law::filtered && !trajectory.is_rapid(part.element)) {
        const PartMotion motion = walk.motion();
        top_speed_ = std::max({top_speed_, motion.kinematics(0).velocity.norm(),
                               motion.kinematics(part.duration).velocity.norm()});
      } else if (part.law == Law::path_length && !trajectory.is_rapid(part.element)) {
        const LawPoint end = advance({part.q, part.v, part.a, part.j}, part.duration);
        top_speed_ = std::max({top_speed_, part.v, end.v});
      }
      if (part.law == Law::path_length) {
        top_jerk_ = std::max(top_jerk_, std::abs(part.j));
      }
    }
  }

  /// SampledPath::cause_times
  const std::array<double, cause_kind_count>& cause_times() const { return cause_times_; }

  std::vector<Chunk> chunks() const {
    std::vector<Chunk> chunks;
    std::optional<Part> last;
    for (PartWalk walk(trajectory_); !walk.done(); walk.next()) {
      const Part& part = walk.part();
      if (chunks.empty() || part.piece >= chunks.back().piece + pieces_a_chunk) {
        if (!chunks.empty()) {
          chunks.back().end = part.piece;
        }
        chunks.push_back({part.piece, trajectory_.pieces().size(), 0, last});
      }
      chunks.back().wanted += spans_of(part, 0);
      last = part;
    }
    return chunks;
  }

  /// Call once.
  SampledPath run(const Chunk& chunk, double spacing) {
    SampledPath path;
    path.origin = origin_;
    reserve(path, spacing > 0 ? 0 : chunk.wanted + 2,
            [this](std::size_t sample) { return sources_.has(source_of_sample(sample)); });
    Sampler sampler(path, spacing);
    instants_.emplace(sources_, trajectory_.pieces()[chunk.piece].time);
    std::optional<Part> last = chunk.before;
    PartWalk walk(trajectory_, chunk.piece);
    if (last) {
      if (!(walk.part().duration > 0)) {
        walk.next();
      }
      const auto passed = std::ranges::lower_bound(also_at_, walk.part().time) - also_at_.begin();
      also_at_ = also_at_.subspan(static_cast<std::size_t>(passed));
    }
    for (; !walk.done() && walk.part().piece < chunk.end; walk.next()) {
      // The end of a part shorter than the spacing would not be kept.
      if (last && has_gap(last->element, walk.part().element)) {
        add_before_gap(path, *last);
      } else if (last && advance_of(*last) >= std::max(spacing, seen_of_jump * extent_) &&
                 jumps(*last, walk.part())) {
        add_end(path, sampler, *last, walk);
      }
      last = walk.part();
      const std::size_t count = spans_of(*last, spacing);
      const double step = last->duration / static_cast<double>(count);
      const double span = advance_of(*last) / static_cast<double>(count);
      const PartMotion motion = walk.motion();
      for (std::size_t k = 0; k < count; ++k) {
        const double tau = step * static_cast<double>(k);
        add(path, sampler, motion, *last, tau, span);
        add_asked(path, sampler, motion, *last, {tau, k + 1 < count ? tau + step : last->duration}, span);
      }
    }
    if (walk.done()) {
      Sampler all(path, 0);
      add(path, all, PartMotion(trajectory_, *last), *last, last->duration, 0);
      path.times.back() = trajectory_.duration();
    }
    return path;
  }

 private:
  struct Between {
    double from, to;  ///< from the start of a part [s]
  };

  /// Adds the requested points between two others of one part, `span` mm apart.
  void add_asked(SampledPath& path, Sampler& sampler, const PartMotion& motion, const Part& part,
                 const Between& taus, double span) {
    const double least = 1e-3 * (taus.to - taus.from);
    for (; !also_at_.empty() && also_at_.front() < part.time + taus.to - least;
         also_at_ = also_at_.subspan(1)) {
      const double tau = also_at_.front() - part.time;
      if (tau > taus.from + least) {
        add(path, sampler, motion, part, tau, span);
      }
    }
  }

  /// Course of q up to the end of the part [mm], or blend parameter.
  static double course_of(const Part& part) {
    return advance({0, std::abs(part.v), std::abs(part.a), std::abs(part.j)}, part.duration).q;
  }

  /// The course as a length [mm].
  double advance_of(const Part& part) const {
    if (part.law == Law::filtered) {
      return trajectory_.filtered_length(part);
    }
    return course_of(part) * (part.law == Law::parameter ? trajectory_.path().length(part.element) : 1.0);
  }

  /// Whether a value jumps (the cause, the jerk, and with some models the feed), so that colours must not
  /// blend over a whole span.
  bool jumps(const Part& before, const Part& next) const {
    if (before.cause.kind != next.cause.kind || before.law != next.law) {
      return true;
    }
    return next.law == Law::path_length &&
           (std::abs(next.j - before.j) > top_jerk_ / feed_steps ||
            std::abs(next.v - advance({0, before.v, before.a, before.j}, before.duration).v) >
                top_speed_ / (10 * feed_steps));
  }

  /// Filters round every corner; corners slowed for the tolerance are shown as blends.
  SpanKind kind_of(const Part& part) const {
    if (trajectory_.is_rapid(part.element)) {
      return SpanKind::rapid;
    }
    const bool blend = part.law == Law::filtered ? part.cause.kind == CauseKind::contour_tolerance
                                                 : trajectory_.path().rounds_corner(part.element);
    if (trajectory_.path().kind(part.element) == ElementKind::curve) {
      return SpanKind::curve;
    }
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
      wanted = spans_of_corner(part.element) * course;
    } else if (!trajectory_.is_rapid(part.element) && top_speed_ > 0) {
      const double change = part.duration * (std::abs(part.a) + part.duration * std::abs(part.j) / 2);
      wanted = std::min(feed_steps, feed_steps * change / top_speed_);
    }
    const ElementKind kind = path.kind(part.element);
    if (kind == ElementKind::arc || kind == ElementKind::connecting_arc) {
      wanted = std::max(wanted, spans_of_arc(path.curve(part.element).arc, course));
    } else if (kind == ElementKind::blend && part.law == Law::path_length && path.length(part.element) > 0) {
      wanted = std::max(wanted, spans_of_corner(part.element) * course / path.length(part.element));
    }
    if (kind == ElementKind::curve) {
      wanted = std::max(wanted, spans_of_curve * course / path.length(part.element));
    }
    if (kind == ElementKind::line && compacted(trajectory_)) {
      wanted = std::max(wanted, course / path.length(part.element) * blocks_of(part.element));
    }
    return spans(wanted, advance_of(part), spacing);
  }

  /// Number of spans in a whole blend; even, so that a span ends at its middle, which is farthest from the
  /// path.
  double spans_of_corner(std::uint32_t element) const {
    const BlendedPath& path = trajectory_.path();
    const double turn = path.turn(path.index(element));
    // Uses the chords of an arc, which bends less than the middle of a blend: half of the visible error.
    const double by_chord = std::sqrt(path.length(element) * turn / (4 * seen_of_chord * extent_));
    const double half = std::ceil(std::min(by_chord, turn / turn_of_corner_span) / 2);
    return 2 * std::clamp(half, 1.0, most_spans_of_corner / 2);
  }

  /// Number of programmed blocks in one line of a compacted path.
  double blocks_of(std::uint32_t element) const {
    const BlendedPath& path = trajectory_.path();
    for (std::size_t next = element + 1; next < path.size(); ++next) {
      if (path.segment(next) > path.segment(element)) {
        return path.segment(next) - path.segment(element);
      }
    }
    return 1;
  }

  /// Whether the path continues elsewhere between two successive elements.
  bool has_gap(std::uint32_t before, std::uint32_t next) const {
    const Toolpath& programmed = programmed_of(trajectory_);
    for (std::uint32_t element = before + 1; element < next; ++element) {
      if (programmed.is_gap(programmed.segments[trajectory_.path().segment(element)])) {
        return true;
      }
    }
    return false;
  }

  /// Adds the end of the path before a gap, however short the parts are.
  void add_before_gap(SampledPath& path, const Part& last) {
    Sampler all(path, 0);
    add(path, all, PartMotion(trajectory_, last), last, last.duration, 0);
    path.kinds.back() = SpanKind::gap;
    gap_ = true;
  }

  /// Adds the end of `last`, at the place of `walk`. Filtered motion is smooth there, and costly to set up.
  void add_end(SampledPath& path, Sampler& sampler, const Part& last, PartWalk& walk) {
    if (last.law == Law::filtered && walk.part().law == Law::filtered) {
      Part end = walk.part();
      end.cause = last.cause;
      add(path, sampler, walk.motion(), end, 0, 0);
    } else {
      add(path, sampler, PartMotion(trajectory_, last), last, last.duration, 0);
    }
  }

  void add(SampledPath& path, Sampler& sampler, const PartMotion& motion, const Part& part, double tau,
           double span) {
    const State at = motion.state_without_length(tau);
    const double speed = at.velocity.norm();
    const SpanKind kind = kind_of(part);
    if (kind != SpanKind::rapid) {
      path.peak_feed = std::max(path.peak_feed, speed);
    }
    const bool kept =
        gap_ ? Sampler(path, 0).add(at.position, kind, span) : sampler.add(at.position, kind, span);
    gap_ = false;
    if (kept) {
      const double time = part.time + tau;
      path.times.push_back(path.times.empty() ? time : std::max(path.times.back(), time));
      path.causes.push_back(part.cause.kind);
      add_values(path, at);
    }
  }

  void add_values(SampledPath& path, const State& state) {
    const Instant instant = instants_->at(state);
    std::size_t next = 0;
    for (const QuantityInfo& quantity : all_quantities()) {
      if (quantity.colours) {
        if (sources_.has(quantity.source)) {
          path.values[next].push_back(Stored(static_cast<float>(quantity.of(instant))));
        }
        ++next;
      }
    }
  }

  const Trajectory& trajectory_;
  Vec3 origin_;                      ///< [mm]
  double extent_ = 0;                ///< of the programmed path [mm]
  std::span<const double> also_at_;  ///< remaining ones [s]
  const RunSources& sources_;
  std::optional<InstantSampler> instants_;
  std::array<double, cause_kind_count> cause_times_{};  ///< [s]
  double top_speed_ = 0;                                ///< [mm/s]
  double top_jerk_ = 0;                                 ///< along the path [mm/s3]
  bool gap_ = false;                                    ///< whether the next point is after a gap
};

/// Appends the contents of `part` and frees its memory.
template <typename Values>
void move_behind(Values& values, Values& part) {
  values.insert(values.end(), part.begin(), part.end());
  part = {};
}

SampledPath joined(std::vector<SampledPath> parts) {
  SampledPath path = std::move(parts.front());
  std::size_t size = 0;
  for (const SampledPath& part : parts) {
    size += part.size();
  }
  reserve(path, path.size() + size, [&path](std::size_t sample) { return !path.values[sample].empty(); });
  for (std::size_t i = 1; i < parts.size(); ++i) {
    SampledPath& part = parts[i];
    move_behind(path.positions, part.positions);
    move_behind(path.kinds, part.kinds);
    move_behind(path.times, part.times);
    move_behind(path.causes, part.causes);
    for (std::size_t quantity = 0; quantity < own_sampled_count; ++quantity) {
      move_behind(path.values[quantity], part.values[quantity]);
    }
    path.peak_feed = std::max(path.peak_feed, part.peak_feed);
    path.bounds.add(part.bounds.min);
    path.bounds.add(part.bounds.max);
  }
  return path;
}

/// Whether the control executes the element as programmed.
bool follows_exactly(const Trajectory& trajectory, std::uint32_t element) {
  const ElementKind kind = trajectory.path().kind(element);
  return !compacted(trajectory) &&
         (kind == ElementKind::line || kind == ElementKind::arc || kind == ElementKind::dwell);
}

/// SampledDeviations of a run at some times.
SampledDeviations deviations_of(const Trajectory& trajectory, std::span<const double> times) {
  constexpr std::size_t points_a_task = 4096;
  const Stored zero(0.0F);
  SampledDeviations found{std::vector<Stored>(times.size(), zero),
                          std::vector<StoredVector>(times.size(), {zero, zero, zero})};
  const PathDeviation whole(programmed_of(trajectory));
  in_order((times.size() + points_a_task - 1) / points_a_task, [&](std::size_t task) {
    PathDeviation deviation = whole;
    const std::size_t first = task * points_a_task;
    StateWalk walk(trajectory, times[first]);
    for (std::size_t i = first; i < std::min(times.size(), first + points_a_task); ++i) {
      const State at = walk.at_without_length(times[i]);
      if (!follows_exactly(trajectory, at.element)) {
        const auto there = deviation(at.position, trajectory.path().segment(at.element));
        const Eigen::Vector3f shift = there.along_bisector.cast<float>();
        found.errors[i] = Stored(static_cast<float>(there.nearest.norm()));
        found.shifts[i] = {Stored(shift.x()), Stored(shift.y()), Stored(shift.z())};
      }
    }
    return [] {};
  });
  return found;
}

}  // namespace

double contour_error_at(const Trajectory& trajectory, const PathDeviation& deviation, double time) {
  const State at = trajectory.state(time);
  const std::uint32_t segment = trajectory.path().segment(at.element);
  return follows_exactly(trajectory, at.element)
             ? 0
             : std::sqrt(deviation.nearest(at.position, segment, segment).squared);
}

SampledPath sample_motion(const Trajectory& trajectory, std::size_t max_points,
                          std::span<const double> also_at, Progress& progress, double share,
                          const RunSources& sources) {
  const ExecutedSampling sampling(trajectory, also_at, sources);
  const std::vector<Chunk> chunks = sampling.chunks();
  std::size_t wanted = 1;
  for (const Chunk& chunk : chunks) {
    wanted += chunk.wanted;
  }
  const double spacing = spacing_for(wanted, max_points, trajectory.path_length());
  std::vector<SampledPath> parts(chunks.size());
  std::atomic<std::size_t> done{0};
  in_parallel(chunks.size(), [&](std::size_t i) {
    parts[i] = ExecutedSampling(sampling).run(chunks[i], spacing);
    progress.report(share * static_cast<double>(++done) / static_cast<double>(chunks.size()));
  });
  SampledPath path = joined(std::move(parts));
  path.cause_times = sampling.cause_times();
  return path;
}

SampledPath sample_executed(const std::shared_ptr<const Trajectory>& trajectory, std::size_t max_points,
                            std::span<const double> also_at, Progress* progress, const RunSources& sources) {
  if (trajectory->pieces().empty()) {
    return {};
  }
  Progress unwatched;
  Progress& watched = progress != nullptr ? *progress : unwatched;
  const bool on_machine = sources.rotary && sources.rotary->knows_linear();
  const double rest_share = (sources.actual ? share_of_actual : 0) + (on_machine ? share_on_machine : 0);
  SampledPath path = sample_motion(*trajectory, max_points, also_at, watched, 1 - rest_share, sources);
  path.deviations = std::make_shared<const AskedDeviations>(
      [trajectory](std::span<const double> times) { return deviations_of(*trajectory, times); });
  path.levels = levels_of(path);
  path.boxes = boxes_of(path.positions);
  if (sources.rotary) {
    path.rotary = sources.rotary;
    path.tool_axes = sample_tool_axes(*sources.rotary, path.origin);
  }
  if (on_machine) {
    Progress rest(watched, share_on_machine);
    SampledPath machine = sample_on_machine(sources, &rest);
    machine.deviations = std::make_shared<const AskedDeviations>([trajectory](std::span<const double> times) {
      return SampledDeviations{deviations_of(*trajectory, times).errors, {}};
    });
    path.on_machine = std::make_shared<const SampledPath>(std::move(machine));
  }
  if (sources.actual) {
    Progress rest(watched, share_of_actual);
    path.actual = std::make_shared<const SampledPath>(sample_actual(*sources.actual, max_points, &rest));
  }
  return path;
}

}  // namespace feedscope::ui
