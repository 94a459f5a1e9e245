#include "core/toolpath/machine_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/units.h"
#include "core/toolpath/rotary_resolver.h"

namespace feedscope {

namespace {

constexpr double same_tilt = 1e-9;  // [rad]

std::optional<double> given(const Settings& settings, std::string_view key) {
  return settings.has(key) ? std::optional(settings.number(key)) : std::nullopt;
}

/// Positions of the machine in shown coordinates, and its times.
class MachineData {
 public:
  explicit MachineData(const Settings& settings)
      : tool_change_time_(given(settings, "tool_change_time_s")),
        spindle_start_time_(given(settings, "spindle_start_time_s")) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto position = [&](std::string_view name) {
        return given(settings, fmt::format("{}_{}_mm", name, "xyz"[axis]));
      };
      zero_[axis] = position("part_zero");
      home_[axis] = position("home");
      tool_change_[axis] = position("tool_change");
    }
  }

  std::optional<double> time(Pause kind) const {
    return kind == Pause::tool_change     ? tool_change_time_
           : kind == Pause::spindle_start ? spindle_start_time_
                                          : std::nullopt;
  }

  /// Empty if one of the axes is not known.
  std::optional<Vec3> shown(const AxisPlaces& places) const {
    Vec3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::optional<double> coordinate = shown(places[axis], axis);
      if (!coordinate) {
        return std::nullopt;
      }
      point[static_cast<Eigen::Index>(axis)] = *coordinate;
    }
    return point;
  }

 private:
  std::optional<double> shown(const AxisPlace& place, std::size_t axis) const {
    const std::optional<double> zero = place.zero_given ? 0.0 : zero_[axis];
    const auto from = [&](const std::optional<double>& origin) {
      return origin && zero ? std::optional(*origin - *zero + place.value) : std::nullopt;
    };
    switch (place.kind) {
      case AxisPlace::Kind::part:
        return place.value;
      case AxisPlace::Kind::home:
        return from(home_[axis]);
      case AxisPlace::Kind::tool_change:
        return from(tool_change_[axis]);
      case AxisPlace::Kind::machine:
        return from(0.0);
      case AxisPlace::Kind::unknown:
      case AxisPlace::Kind::assumed:  // the way of the axis there is not known
        break;
    }
    return std::nullopt;
  }

  std::array<std::optional<double>, 3> zero_;
  std::array<std::optional<double>, 3> home_;
  std::array<std::optional<double>, 3> tool_change_;
  std::optional<double> tool_change_time_;
  std::optional<double> spindle_start_time_;
};

/// Copies a path on the first change to it.
class Resolver {
 public:
  Resolver(std::shared_ptr<const Toolpath> path, const Settings& settings)
      : path_(std::move(path)), machine_(settings) {}

  std::shared_ptr<const Toolpath> run() {
    bool start_known = true;
    for (std::size_t i = 0; i < path_->segments.size(); ++i) {
      const Segment& segment = path_->segments[i];
      if (segment.kind != SegmentKind::dwell) {
        start_known = true;
        continue;
      }
      const ToolpathPause& pause = path_->pause_of(segment);
      if (pause.kind == Pause::machine_move) {
        const MachineMove& move = path_->machine_moves[pause.move];
        const std::optional<Vec3> end = machine_.shown(move.end);
        if (start_known && end) {
          move_to(i, *end, move.feed);
        }
        start_known = end.has_value();
      } else if (const std::optional<double> time = machine_.time(pause.kind);
                 time && (!pause.timed || *time != pause.time)) {
        ToolpathPause& timed = changed().pauses[static_cast<std::size_t>(segment.index)];
        timed.time = *time;
        timed.timed = true;
      }
      if (copy_ && pause.kind != Pause::machine_move) {
        copy_->segments[i].end = Vec3(copy_->start_of(i));
      }
    }
    return copy_ ? std::move(copy_) : std::move(path_);
  }

 private:
  Toolpath& changed() {
    if (!copy_) {
      copy_ = std::make_shared<Toolpath>(*path_);
    }
    return *copy_;
  }

  void move_to(std::size_t i, const Vec3& end, double feed) {
    Toolpath& path = changed();
    const Vec3 start = path.start_of(i);
    Segment& segment = path.segments[i];
    segment.end = end;
    path.bounds.add(end);
    const double length = (end - start).norm();
    if (length <= same_point) {
      path.pauses[static_cast<std::size_t>(segment.index)] = {0, Pause::dwell, true, 0};
      return;
    }
    segment.kind = SegmentKind::line;
    segment.index = -1;
    segment.length = length;
    segment.feed = feed;
    segment.rapid = feed == 0;
  }

  std::shared_ptr<const Toolpath> path_;
  std::shared_ptr<Toolpath> copy_;
  MachineData machine_;
};

/// The path with all feeds times the feed override.
std::shared_ptr<const Toolpath> with_feed_override(std::shared_ptr<const Toolpath> path,
                                                   const Settings& settings) {
  constexpr double whole = 100;  // percent
  const double factor = given(settings, feed_override_key).value_or(whole) / whole;
  if (factor == 1) {
    return path;
  }
  auto changed = std::make_shared<Toolpath>(*path);
  for (Segment& segment : changed->segments) {
    segment.feed *= factor;
  }
  for (RotaryMove& move : changed->rotary_moves) {
    move.feed *= factor;
    move.time /= factor;
  }
  for (MachineMove& move : changed->machine_moves) {
    move.feed *= factor;
  }
  return changed;
}

/// Largest cutting feeds of X, Y and Z of a machine [mm/s]; infinite where it gives none.
Vec3 cutting_feeds(const Settings& settings) {
  Vec3 feeds = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 3; ++axis) {
    if (const auto feed = given(settings, cutting_feed_key(axis)); feed && *feed > 0) {
      feeds[axis] = units::from_m_min(*feed);
    }
  }
  return feeds;
}

struct CuttingFeed {
  double most = std::numeric_limits<double>::infinity();  ///< along the segment [mm/s]
  std::int8_t axis = -1;                                  ///< the axis that sets it
};

/// Largest feed along a segment at which no axis exceeds its cutting feed. For an arc it covers every
/// direction in its plane, as if it were a full circle.
CuttingFeed most_cutting_feed(const Toolpath& path, std::size_t i, const Vec3& feeds) {
  const Segment& segment = path.segments[i];
  Vec3 share = Vec3::Zero();  // largest share of the feed, for each axis
  if (segment.kind == SegmentKind::line && segment.length > 0) {
    share = (segment.end - path.start_of(i)).cwiseAbs() / segment.length;
  } else if (segment.kind == SegmentKind::arc) {
    const Arc& arc = path.arc_of(segment);
    const Vec3 in_plane = (arc.x.cwiseAbs2() + arc.y.cwiseAbs2()).cwiseSqrt();
    share = (arc.radius * in_plane + arc.rise.cwiseAbs()) / arc.length_per_radian();
  }
  CuttingFeed least;
  for (std::int8_t axis = 0; axis < 3; ++axis) {
    if (share[axis] * least.most > feeds[axis]) {
      least = {feeds[axis] / share[axis], axis};
    }
  }
  return least;
}

/// The path with feeds that keep every axis within its cutting feed.
std::shared_ptr<const Toolpath> with_cutting_feeds(std::shared_ptr<const Toolpath> path,
                                                   const Settings& settings) {
  const Vec3 feeds = cutting_feeds(settings);
  if (!feeds.array().isFinite().any()) {
    return path;
  }
  auto changed = std::make_shared<Toolpath>(*path);
  for (std::size_t i = 0; i < changed->segments.size(); ++i) {
    Segment& segment = changed->segments[i];
    const CuttingFeed cutting = segment.rapid ? CuttingFeed() : most_cutting_feed(*path, i, feeds);
    if (cutting.axis >= 0 && (segment.feed == 0 || cutting.most < segment.feed)) {
      segment.feed = cutting.most;
      segment.feed_axis = cutting.axis;
    }
  }
  return changed;
}

std::shared_ptr<const Toolpath> with_block_time(std::shared_ptr<const Toolpath> path,
                                                const Settings& settings) {
  const double time = units::from_ms(given(settings, block_time_key).value_or(0));
  if (!(time > 0)) {
    return path;
  }
  auto changed = std::make_shared<Toolpath>(*path);
  changed->block_time = time;
  return changed;
}

}  // namespace

MachinePath on_machine(std::shared_ptr<const Toolpath> path, const Machine& machine, const Settings& settings,
                       const Progress* progress) {
  path = with_cutting_feeds(with_feed_override(std::move(path), settings), settings);
  path = with_block_time(std::move(path), settings);
  MachinePath run = with_rotary_moves(std::move(path), machine, settings, progress);
  if (!run->pauses.empty()) {
    run.toolpath = Resolver(std::move(run.toolpath), settings).run();
  }
  return run;
}

NotCounted not_counted(const Toolpath& path) {
  NotCounted count;
  count.other_axes = path.other_axes;
  Vec3 direction = Vec3::UnitZ();
  for (const RotaryMove& move : path.rotary_moves) {  // empty once a machine has turned them into pauses
    const bool to_zero = std::ranges::all_of(move.to, [](const auto& angle) { return angle == 0.0; });
    const Vec3 next = to_zero ? Vec3(Vec3::UnitZ()) : move.direction.value_or(direction);
    const bool beside = move.with_feed || move.with_rapid;
    count.plane_turns += !beside && (next - direction).norm() > same_tilt ? 1 : 0;
    direction = next;
  }
  if (!path.part.known) {
    count.tip_followings =
        static_cast<std::size_t>(std::ranges::count_if(path.segment_turns, &SegmentTurn::at_tip) +
                                 std::ranges::count_if(path.rotary_turns, &RotaryTurn::at_tip));
  }
  for (const Segment& segment : path.segments) {
    if (segment.kind != SegmentKind::dwell || path.pause_of(segment).timed) {
      continue;
    }
    switch (path.pause_of(segment).kind) {
      case Pause::dwell:
      case Pause::indexing:
      case Pause::swing:
        break;
      case Pause::tool_change:
        ++count.tool_changes;
        break;
      case Pause::spindle_start:
        ++count.spindle_starts;
        break;
      case Pause::stop:
        ++count.stops;
        break;
      case Pause::machine_move:
        ++count.machine_moves;
        break;
    }
  }
  return count;
}

}  // namespace feedscope
