#include "ui/page/run_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/analysis/contour/path_deviation.h"
#include "core/base/units.h"
#include "core/trajectory/part_walk.h"

namespace feedscope::ui {
namespace {

constexpr int most_halvings = 10;
constexpr double shortest_span = 2e-5;       // [s]
constexpr double acceleration_share = 0.05;  // of the largest acceleration
constexpr double fine_position = 5e-4;       // [mm]
constexpr double fine_speed_share = 5e-4;    // of the largest feed
constexpr int most_turns = 24;               // to twice the largest feed and 2 mm
constexpr std::size_t longest_window = 64;   // nodes that one span may replace

/// State of a run with its programmed place.
struct Looked {
  State state;
  double place = 0;
  double error = 0;
};

/// Speed at a share of the time of a span, of the parabola through start, middle and end.
double parabola(double start, double middle, double end, double share) {
  return start + share * (4 * middle - 3 * start - end) + share * share * 2 * (start + end - 2 * middle);
}

/// The position if it were linear in path length.
Vec3 on_chord(const Vec3& from, const Vec3& to, double begin, double end, double at) {
  return end > begin ? Vec3(from + (to - from) * ((at - begin) / (end - begin))) : from;
}

class NodeWalk {
 public:
  NodeWalk(const Trajectory& trajectory, const NodePrecision& precision)
      : trajectory_(trajectory),
        path_(*trajectory.path().programmed()),
        precision_(precision),
        deviation_(path_) {
    lengths_.reserve(path_.segments.size() + 1);
    lengths_.push_back(0);
    for (const Segment& segment : path_.segments) {
      lengths_.push_back(lengths_.back() + segment.length);
    }
  }

  std::vector<RunNode> take(Progress& progress) {
    find_top_acceleration();
    for (PartWalk walk(trajectory_); !walk.done(); walk.next()) {
      if (!(walk.part().duration > 0)) {
        continue;
      }
      part_ = walk.part();
      const PartMotion motion = walk.motion();
      const Looked from = look(motion, 0);
      close(from);
      const Looked to = look(motion, part_.duration);
      divide(motion, {0, from}, {part_.duration, to}, 0);
      last_ = to;
      progress.report(part_.time / trajectory_.duration());
    }
    if (last_) {
      add(*last_, trajectory_.duration());
    }
    return std::move(nodes_);
  }

 private:
  struct End {
    double tau = 0;
    Looked at;
  };

  void find_top_acceleration() {
    for (PartWalk walk(trajectory_); !walk.done(); walk.next()) {
      const Kinematics middle = walk.motion().kinematics(walk.part().duration / 2);
      top_acceleration_ = std::max(top_acceleration_, middle.acceleration.norm());
    }
  }

  /// Whether the control executes the element as programmed.
  bool follows_exactly() const {
    const ElementKind kind = trajectory_.path().kind(part_.element);
    return &trajectory_.path().base() == trajectory_.path().programmed().get() &&
           (kind == ElementKind::line || kind == ElementKind::arc || kind == ElementKind::dwell);
  }

  NodeKind kind() const {
    return is_pause(part_.cause.kind)            ? NodeKind::pause
           : trajectory_.is_rapid(part_.element) ? NodeKind::rapid
                                                 : NodeKind::cut;
  }

  Looked look(const PartMotion& motion, double tau) {
    Looked looked{motion.state(tau), 0, 0};
    const std::uint32_t segment = trajectory_.path().segment(part_.element);
    if (path_.segments[segment].kind == SegmentKind::dwell) {
      looked.place = lengths_[segment];
    } else if (follows_exactly()) {
      looked.place = lengths_[segment] + deviation_.foot_on(segment, looked.state.position).s;
    } else {
      const PathDeviation::Foot foot = deviation_.foot_near(segment, looked.state.position);
      looked.place = lengths_[foot.segment] + foot.s;
      looked.error = deviation_(looked.state.position, segment).nearest.norm();
    }
    return looked;
  }

  RunNode node_of(const Looked& at, double time) {
    place_ = std::max(place_, at.place);
    RunNode node;
    node.time = time;
    node.path_length = at.state.path_length;
    node.place = place_;
    node.position = at.state.position;
    node.speed = at.state.velocity.norm();
    node.error = at.error;
    node.acceleration = at.state.acceleration.norm();
    node.middle_speed = node.speed;
    node.acceleration_after = node.acceleration;
    node.feed = at.state.programmed_feed;
    node.line = at.state.line;
    node.cause = part_.cause;
    node.kind = kind();
    return node;
  }

  void add(const Looked& at, double time) { nodes_.push_back(node_of(at, time)); }

  /// Adds a node at the end of the previous part if the next one begins at another place or speed.
  void close(const Looked& next) {
    if (!last_) {
      return;
    }
    const bool jumps = (next.state.position - last_->state.position).norm() > precision_.position;
    if (jumps || std::abs(next.state.speed - last_->state.speed) > precision_.speed) {
      add(*last_, part_.time);
      nodes_.back().kind = jumps ? NodeKind::gap : nodes_.back().kind;
    }
  }

  bool is_straight() const {
    return part_.law == Law::path_length && trajectory_.path().kind(part_.element) == ElementKind::line;
  }

  bool fits(const End& from, const End& to, const End& middle, const End& inner, double share) const {
    const double speed = parabola(from.at.state.speed, middle.at.state.speed, to.at.state.speed, share);
    const Vec3 straight = on_chord(from.at.state.position, to.at.state.position, from.at.state.path_length,
                                   to.at.state.path_length, inner.at.state.path_length);
    return std::abs(speed - inner.at.state.speed) <= precision_.speed &&
           (straight - inner.at.state.position).norm() <= precision_.position;
  }

  bool bends(const End& from, const End& to, const End& middle) const {
    const double chord = (from.at.state.acceleration.norm() + to.at.state.acceleration.norm()) / 2;
    return std::abs(middle.at.state.acceleration.norm() - chord) > acceleration_share * top_acceleration_;
  }

  void divide(const PartMotion& motion, const End& from, const End& to, int halvings) {
    const auto at_share = [&](double share) {
      const double tau = from.tau + share * (to.tau - from.tau);
      return End{tau, look(motion, tau)};
    };
    const End middle = at_share(0.5);
    if (!is_straight() && halvings < most_halvings && to.tau - from.tau > shortest_span &&
        (bends(from, to, middle) || !fits(from, to, middle, middle, 0.5) ||
         !fits(from, to, middle, at_share(0.25), 0.25) || !fits(from, to, middle, at_share(0.75), 0.75))) {
      divide(motion, from, middle, halvings + 1);
      divide(motion, middle, to, halvings + 1);
      return;
    }
    add(from.at, part_.time + from.tau);
    RunNode& node = nodes_.back();
    node.middle_speed = middle.at.state.speed;
    node.acceleration_after = to.at.state.acceleration.norm();
    node.jerk = middle.at.state.jerk.norm();
  }

  const Trajectory& trajectory_;
  const Toolpath& path_;
  NodePrecision precision_;
  PathDeviation deviation_;
  std::vector<double> lengths_;  ///< programmed, to the start of each segment [mm]
  Part part_;
  std::optional<Looked> last_;
  double place_ = 0;
  double top_acceleration_ = 0;
  std::vector<RunNode> nodes_;
};

/// Speed halfway between two nodes such that the parabola covers the distance between them.
double middle_speed(const RunNode& from, const RunNode& to) {
  const double mean = (to.path_length - from.path_length) / (to.time - from.time);
  return std::max(0.0, (6 * mean - from.speed - to.speed) / 4);
}

/// Whether one span between two nodes represents those between them.
bool one_span(const std::vector<RunNode>& nodes, std::size_t from, std::size_t to,
              const NodePrecision& precision) {
  const RunNode& a = nodes[from];
  const RunNode& b = nodes[to];
  if (!(b.time > a.time)) {
    return false;
  }
  const double middle = middle_speed(a, b);
  const auto speed_fits = [&](double time, double speed) {
    const double drawn = parabola(a.speed, middle, b.speed, (time - a.time) / (b.time - a.time));
    return std::abs(drawn - speed) <= precision.speed;
  };
  for (std::size_t i = from; i < to; ++i) {
    const RunNode& node = nodes[i];
    const Vec3 straight = on_chord(a.position, b.position, a.path_length, b.path_length, node.path_length);
    if (node.kind != a.kind || !speed_fits(node.time, node.speed) ||
        !speed_fits((node.time + nodes[i + 1].time) / 2, node.middle_speed) ||
        (straight - node.position).norm() > precision.position) {
      return false;
    }
  }
  return true;
}

/// A node that replaces [from, to): cause, line and feed of the longest, the largest acceleration and jerk.
RunNode joined(const std::vector<RunNode>& nodes, std::size_t from, std::size_t to) {
  RunNode node = nodes[from];
  std::size_t longest = from;
  for (std::size_t i = from; i < to; ++i) {
    const double duration = nodes[i + 1].time - nodes[i].time;
    longest = duration > nodes[longest + 1].time - nodes[longest].time ? i : longest;
    node.acceleration = std::max(node.acceleration, nodes[i].acceleration);
    node.jerk = std::max(node.jerk, nodes[i].jerk);
    node.error = std::max(node.error, nodes[i].error);
  }
  if (to > from + 1) {
    node.middle_speed = middle_speed(node, nodes[to]);
    node.acceleration_after = node.acceleration;
  }
  node.cause = nodes[longest].cause;
  node.line = nodes[longest].line;
  node.feed = nodes[longest].feed;
  return node;
}

std::vector<RunNode> thinned(const std::vector<RunNode>& nodes, const NodePrecision& precision,
                             const std::vector<CloseView>& views) {
  std::vector<RunNode> kept;
  std::size_t from = 0;
  auto view = views.begin();
  while (from + 1 < nodes.size()) {
    while (view != views.end() && view->to < nodes[from].place) {
      ++view;
    }
    const double apart = view != views.end() ? view->from : std::numeric_limits<double>::infinity();
    std::size_t to = from + 1;
    while (to + 1 < nodes.size() && to - from < longest_window && nodes[to + 1].place < apart &&
           one_span(nodes, from, to + 1, precision)) {
      ++to;
    }
    kept.push_back(joined(nodes, from, to));
    from = to;
  }
  kept.push_back(nodes.back());
  return kept;
}

/// Number of chords that approximate an arc within `precision` [mm].
std::size_t chords_of(const Arc& arc, double length, double precision) {
  const double step = std::sqrt(8 * precision * arc.radius);  // sagitta of a short chord: c^2 / (8 r)
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / std::max(step, precision))));
}

}  // namespace

NodePrecision fine_precision(double top_feed) {
  return {fine_position, fine_speed_share * top_feed};
}

RunNodes run_nodes(const Trajectory& trajectory, double top_feed, std::size_t most,
                   const std::vector<CloseView>& views, Progress* progress) {
  RunNodes result{{}, fine_precision(top_feed)};
  if (trajectory.pieces().empty()) {
    return result;
  }
  Progress unwatched;
  result.nodes = NodeWalk(trajectory, result.precision).take(progress != nullptr ? *progress : unwatched);
  const std::vector<RunNode> all = result.nodes;
  // Speed and path in turn: either alone may need as many nodes, however coarse the other is.
  for (int turn = 0; result.nodes.size() > most && turn < most_turns; ++turn) {
    (turn % 2 == 0 ? result.precision.speed : result.precision.position) *= 2;
    result.nodes = thinned(all, result.precision, views);
  }
  return result;
}

std::vector<ProgrammedPoint> programmed_points(const Toolpath& path, double precision) {
  std::vector<ProgrammedPoint> points{{0, path.start, 0, NodeKind::gap}};
  double place = 0;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    if (segment.kind == SegmentKind::dwell && !path.is_gap(segment)) {
      continue;
    }
    const NodeKind kind = segment.kind == SegmentKind::dwell ? NodeKind::gap
                          : segment.rapid                    ? NodeKind::rapid
                                                             : NodeKind::cut;
    const std::size_t chords =
        segment.kind == SegmentKind::arc ? chords_of(path.arc_of(segment), segment.length, precision) : 1;
    for (std::size_t k = 1; k < chords; ++k) {
      const double s = segment.length * static_cast<double>(k) / static_cast<double>(chords);
      points.push_back({place + s, path.place_on(i, s).position, segment.line, NodeKind::arc});
    }
    place += segment.length;
    points.push_back({place, segment.end, segment.line, kind});
  }
  return points;
}

}  // namespace feedscope::ui
