#include "core/analysis/contour/lens.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/contour/path_deviation.h"
#include "core/analysis/run/tolerance_in_force.h"
#include "core/blend/junction.h"
#include "core/blend/path_rules.h"

namespace feedscope {
namespace {

constexpr double share_of_width = 2.0 / 3;   // of the lens, for the longest rounding
constexpr double share_of_height = 1.0 / 3;  // of the lens, for the largest deviation
constexpr double seen_ways = 1.5;            // path length drawn to either side, in widths
constexpr int samples = 512;                 // per run

/// Two segments that meet at an angle.
struct LensCorner {
  std::size_t segment = 0;  ///< segment that ends there
  Vec3 point = Vec3::Zero();
  Vec3 in = Vec3::UnitX();
  Vec3 out = Vec3::UnitX();
  double turn = 0;  ///< [rad]
};

std::optional<LensCorner> corner_behind(const Toolpath& path, std::size_t segment) {
  if (segment + 1 >= path.segments.size() || path.segments[segment].kind == SegmentKind::dwell ||
      path.segments[segment + 1].kind == SegmentKind::dwell) {
    return std::nullopt;
  }
  LensCorner corner{segment, path.segments[segment].end, path.tangent_at_end(segment),
                    path.tangent_at_start(segment + 1)};
  corner.turn = turn_angle(corner.in, corner.out);
  return corner.turn > straight_angle ? std::optional(corner) : std::nullopt;
}

/// The middle of the corner after `segment`.
ProgrammedPlace end_of(std::size_t segment) {
  return {static_cast<std::uint32_t>(segment), 1};
}

/// A part of an executed path, by its path lengths [mm].
struct Executed {
  double begin = 0;
  double end = 0;
};

/// Where an executed path rounds the corner after `segment`; an empty range if it does not, or if the path
/// alone does not show it.
Executed rounding_of(const BlendedPath& path, std::size_t segment) {
  const double middle = path_length_of(path, end_of(segment));
  const std::size_t at = path.element_at(middle);
  const auto rounds = [&](std::size_t i) {
    return i < path.size() && path.segment(i) == segment && path.rounds_corner(i);
  };
  Executed rounding{middle, middle};
  for (std::size_t i = at; rounds(i); --i) {
    rounding.begin = path.s(i);
  }
  for (std::size_t i = at; rounds(i); ++i) {
    rounding.end = path.s(i + 1);
  }
  return rounding;
}

Vec3 any_across(const Vec3& along) {
  const Vec3 flat = Vec3::UnitZ().cross(along);
  constexpr double steep = 1e-3;
  return flat.norm() > steep ? flat.normalized() : Vec3(along.cross(Vec3::UnitX()).normalized());
}

/// Component of `direction` across `along`, unit; any direction across if there is none.
Vec3 across_of(const Vec3& along, const Vec3& direction) {
  const Vec3 part = direction - along * along.dot(direction);
  constexpr double none = 1e-9;
  return part.norm() > none * direction.norm() ? part.normalized() : any_across(along);
}

/// Centre of the lens, and its width.
class Focus {
 public:
  Focus(std::span<const Run* const> runs, std::size_t shown, double time)
      : runs_(runs),
        shown_(*runs[shown]->trajectory),
        path_(*shown_.path().programmed()),
        place_(programmed_place(shown_, time)),
        time_(time) {
    const PathDeviation deviation(path_);
    foot_ = deviation.foot_near(moving_segment(place_.segment), shown_.state(time).position);
    find_corner();
  }

  Lens lens() const {
    Lens lens;
    lens.width = width_;
    if (corner_) {
      lens.centre = corner_->point;
      lens.along = corner_->in;
      lens.across = across_of(corner_->in, corner_->out);
      lens.line = path_.segments[corner_->segment].line;
      return lens;
    }
    const CurvePoint at = path_.place_on(foot_.segment, foot_.s);
    lens.centre = at.position;
    lens.along = at.d1.normalized();
    lens.across = across_of(lens.along, at.d2);
    lens.line = path_.segments[foot_.segment].line;
    return lens;
  }

  /// Time at which a run is at the place of the shown run's cursor [s].
  double time_in(const Trajectory& run) const { return &run == &shown_ ? time_ : time_of(run, place_); }

  /// Path length of a run at the centre of the lens [mm].
  double middle_in(const Trajectory& run) const {
    return path_length_of(run.path(), corner_ ? end_of(corner_->segment) : place_);
  }

  const Toolpath& path() const { return path_; }
  std::size_t segment() const { return corner_ ? corner_->segment : foot_.segment; }
  /// From the start of segment() [mm].
  double place_on_segment() const { return corner_ ? path_.segments[corner_->segment].length : foot_.s; }

 private:
  /// `segment` if it moves the axes, else the last one before it that does; at the beginning, the next one.
  std::size_t moving_segment(std::size_t segment) const {
    const auto stands = [&](std::size_t i) { return path_.segments[i].kind == SegmentKind::dwell; };
    std::size_t before = segment;
    while (before > 0 && stands(before)) {
      --before;
    }
    while (stands(before) && before + 1 < path_.segments.size()) {
      ++before;
    }
    return before;
  }

  void find_corner() {
    const std::size_t here = foot_.segment;
    std::optional<LensCorner> nearest;
    for (const std::size_t segment : {here, here - 1}) {
      const auto corner = segment < path_.segments.size() ? corner_behind(path_, segment) : std::nullopt;
      const auto away = [&](const LensCorner& of) { return (of.point - place()).norm(); };
      if (corner && (!nearest || away(*corner) < away(*nearest))) {
        nearest = corner;
      }
    }
    width_ = nearest ? width_at(*nearest) : path_.segments[here].length;
    if (nearest && (nearest->point - place()).norm() <= width_ / 2) {
      corner_ = nearest;
    }
  }

  Vec3 place() const { return path_.place_on(foot_.segment, foot_.s).position; }

  /// False for a control that reads the program in its own way.
  bool has_same_segments(const Trajectory& run) const {
    return run.path().programmed()->segments.size() == path_.segments.size();
  }

  /// Path length nearest to a point of a run with other segments, near the place expected with the same ones
  /// [mm].
  double nearest_length(const Trajectory& run, const Vec3& point) const {
    constexpr int looks = 512;
    constexpr double times = 4;  // of the drawn length and the segment: range on either side
    const double reach = times * (width_ + path_.segments[foot_.segment].length);
    const double guess = path_length_of(run.path(), place_);
    const auto distance = [&](double s) { return (run.state_at_path(s).position - point).norm(); };
    double best = guess;
    double nearest = distance(guess);
    for (double step = 2 * reach / looks; step > least_deviation; step /= looks / 8.0) {
      const double from = best - step * looks / 2;
      for (int i = 0; i <= looks; ++i) {
        const double s = std::clamp(from + step * i, 0.0, run.path_length());
        if (const double away = distance(s); away < nearest) {
          nearest = away;
          best = s;
        }
      }
    }
    return best;
  }

  /// Three halves of the longest rounding of the runs; without any, of half the shorter segment.
  double width_at(const LensCorner& corner) const {
    double longest = 0;
    for (const Run* run : runs_) {
      if (has_same_segments(*run->trajectory)) {
        longest = std::max(longest, rounded_length(*run->trajectory, corner));
      }
    }
    const double shorter =
        std::min(path_.segments[corner.segment].length, path_.segments[corner.segment + 1].length);
    return longest > 0 ? longest / share_of_width : shorter;
  }

  /// Length of the path that deviates from the programmed one in a corner [mm].
  static double rounded_length(const Trajectory& run, const LensCorner& corner) {
    const BlendedPath& path = run.path();
    const auto [from, to] = rounding_of(path, corner.segment);
    if (to > from) {
      return to - from;
    }
    return deviating_length(run, corner, to);
  }

  /// As rounded_length() for a path without marked roundings: on either side of `middle` as far as the error
  /// exceeds a twentieth of its maximum, up to half of the segments.
  static double deviating_length(const Trajectory& run, const LensCorner& corner, double middle) {
    constexpr int steps = 64;
    constexpr double little = 0.05;
    const Toolpath& path = *run.path().programmed();
    if (corner.segment + 1 >= path.segments.size()) {
      return 0;
    }
    const double reach =
        std::min(path.segments[corner.segment].length, path.segments[corner.segment + 1].length) / 2;
    const PathDeviation deviation(path);
    std::vector<double> errors;
    for (int i = -steps; i <= steps; ++i) {
      const State state = run.state_at_path(middle + reach * i / steps);
      errors.push_back(
          std::sqrt(deviation.foot_near(run.path().segment(state.element), state.position).squared));
    }
    const double largest = std::ranges::max(errors);
    if (largest < least_deviation) {
      return 0;
    }
    const auto counts = [&](double error) { return error > little * largest; };
    const auto first = std::ranges::find_if(errors, counts) - errors.begin();
    const auto last = std::find_if(errors.rbegin(), errors.rend(), counts).base() - errors.begin();
    return reach / steps * static_cast<double>(last - first);
  }

  std::span<const Run* const> runs_;
  const Trajectory& shown_;
  const Toolpath& path_;
  ProgrammedPlace place_;
  double time_;
  PathDeviation::Foot foot_;
  std::optional<LensCorner> corner_;
  double width_ = 0;
};

/// Part of the programmed path that the lens shows.
class ProgrammedLines {
 public:
  ProgrammedLines(const Lens& lens, const Focus& focus) : lens_(lens), path_(focus.path()) {
    const double reach = seen_ways * lens.width;
    std::size_t first = focus.segment();
    double before = focus.place_on_segment();
    while (before < reach && first > 0) {
      before += path_.segments[--first].length;
    }
    std::size_t last = focus.segment();
    double behind = path_.segments[last].length - focus.place_on_segment();
    while (behind < reach && last + 1 < path_.segments.size()) {
      behind += path_.segments[++last].length;
    }
    for (std::size_t i = first; i <= last; ++i) {
      add(i);
    }
  }

  std::vector<std::vector<LensPoint>> take() { return std::move(lines_); }

 private:
  void add(std::size_t i) {
    const Segment& segment = path_.segments[i];
    if (lines_.empty() || path_.is_gap(segment)) {
      lines_.push_back({lens_.seen(path_.is_gap(segment) ? segment.end : path_.start_of(i))});
    }
    if (segment.kind == SegmentKind::arc) {
      add_arc(i, segment.length);
    } else if (segment.kind == SegmentKind::line) {
      lines_.back().push_back(lens_.seen(segment.end));
    }
  }

  /// In steps small compared with the width of the lens and the turn of the arc.
  void add_arc(std::size_t i, double length) {
    constexpr double steps_a_width = 512;
    constexpr int most = 4096;
    const int steps = std::clamp(static_cast<int>(steps_a_width * length / lens_.width), 16, most);
    for (int step = 1; step <= steps; ++step) {
      lines_.back().push_back(lens_.seen(path_.place_on(i, length * step / steps).position));
    }
  }

  const Lens& lens_;
  const Toolpath& path_;
  std::vector<std::vector<LensPoint>> lines_;
};

LensRun run_through(const Lens& lens, const Focus& focus, const Trajectory& run) {
  LensRun seen;
  const PathDeviation deviation(*run.path().programmed());
  const auto error_at = [&](const State& state) {
    return std::sqrt(deviation.foot_near(run.path().segment(state.element), state.position).squared);
  };
  const double middle = focus.middle_in(run);
  const double reach = seen_ways * lens.width;
  for (int i = 0; i <= samples; ++i) {
    const double s = middle + reach * (2.0 * i / samples - 1);
    if (s < 0 || s > run.path_length()) {
      continue;
    }
    const State state = run.state_at_path(s);
    seen.path.push_back(lens.seen(state.position));
    // A path that turns back runs next to the corner, far outside of the picture.
    if (seen.path.back().norm() <= lens.width / 2) {
      seen.largest_error = std::max(seen.largest_error, error_at(state));
    }
  }
  const State at = run.state(focus.time_in(run));
  seen.cursor = lens.seen(at.position);
  seen.error = error_at(at);
  seen.feed = at.speed;
  return seen;
}

double tolerance_at(const Run& run, std::size_t segment) {
  const Toolpath& path = *run.trajectory->path().programmed();
  return follows_tolerance(run.setup) ? PathRules(path, run.setup.settings).tolerance(segment) : 0;
}

}  // namespace

Lens lens_at(std::span<const Run* const> runs, std::size_t shown, double time) {
  const Focus focus(runs, shown, time);
  Lens lens = focus.lens();
  double largest = 0;
  for (const Run* run : runs) {
    lens.runs.push_back(run_through(lens, focus, *run->trajectory));
    largest = std::max(largest, lens.runs.back().largest_error);
  }
  lens.deviates = largest >= least_deviation;
  lens.height = lens.deviates ? largest / share_of_height : lens.width;
  lens.programmed = ProgrammedLines(lens, focus).take();
  lens.tolerance = tolerance_at(*runs[shown], focus.segment());
  return lens;
}

std::optional<double> lens_time(const Run& run, std::uint32_t line) {
  const Trajectory& trajectory = *run.trajectory;
  if (trajectory.path().empty()) {
    return std::nullopt;
  }
  const Toolpath& path = *trajectory.path().programmed();
  std::optional<std::size_t> first;
  std::optional<LensCorner> sharpest;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    if (path.segments[i].line != line || path.segments[i].kind == SegmentKind::dwell) {
      continue;
    }
    first = first.value_or(i);
    const auto corner = corner_behind(path, i);
    if (corner && (!sharpest || corner->turn > sharpest->turn)) {
      sharpest = corner;
    }
  }
  if (!first) {
    return std::nullopt;
  }
  const double middle =
      path_length_of(trajectory.path(), sharpest ? end_of(sharpest->segment)
                                                 : ProgrammedPlace{static_cast<std::uint32_t>(*first), 0.5});
  return trajectory.state_at_path(middle).time;
}

}  // namespace feedscope
