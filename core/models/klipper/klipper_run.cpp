#include "core/models/klipper/klipper_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/limits/axis_share.h"
#include "core/limits/segment_limits.h"

namespace feedscope {
namespace {

constexpr double no_move = 1e-9;  // [mm]

std::shared_ptr<ExecutedPath> path_for(const Toolpath& toolpath) {
  if (toolpath.arcs.empty()) {
    return nullptr;
  }
  auto executed = std::make_shared<ExecutedPath>();
  executed->path.start = toolpath.start;
  executed->path.path_controls = toolpath.path_controls;
  executed->path.spindles = toolpath.spindles;
  executed->path.pauses = toolpath.pauses;
  executed->path.bounds = toolpath.bounds;
  return executed;
}

TrajectoryBuilder builder_for(std::shared_ptr<const Toolpath> toolpath, const Vec3& velocity,
                              const std::shared_ptr<ExecutedPath>& executed) {
  return executed
             ? TrajectoryBuilder(std::move(toolpath), velocity, std::shared_ptr<const ExecutedPath>(executed))
             : TrajectoryBuilder(std::move(toolpath), velocity);
}

}  // namespace

KlipperRun::KlipperRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
                       const KlipperSettings& settings)
    : toolpath_(*toolpath),
      settings_(settings),
      limits_(settings, toolpath_.source.get()),
      executed_(path_for(toolpath_)),
      builder_(
          builder_for(std::move(toolpath), axis_limit_vector(machine, &AxisLimits::velocity), executed_)) {}

Trajectory KlipperRun::run(Progress* progress) {
  builder_.reserve(toolpath_.segments.size(), toolpath_.segments.size());
  builder_.stop_with(progress);
  ProgressSteps steps(progress, toolpath_.segments.size());
  for (std::size_t i = 0; i < toolpath_.segments.size(); ++i) {
    const Segment& segment = toolpath_.segments[i];
    switch (segment.kind) {
      case SegmentKind::line:
        queue_line(i, toolpath_.start_of(i), segment.end);
        break;
      case SegmentKind::arc:
        queue_arc(i);
        break;
      case SegmentKind::dwell: {
        // Klipper has no switching commands: none without a time of its own stops the tool.
        const ToolpathPause& pause = toolpath_.pause_of(segment);
        if (pause.kind == Pause::dwell || pause.kind == Pause::machine_move || pause.time > 0) {
          flush();
        }
        const auto block = static_cast<std::uint32_t>(i);
        if (executed_) {
          executed_->add(segment, block);
          builder_.pass_pause(builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1)));
        } else {
          builder_.add_pause(block);
        }
        break;
      }
    }
    steps.at(i);
  }
  flush();
  return builder_.finish();
}

void KlipperRun::queue_line(std::size_t block, const Vec3& start, const Vec3& end) {
  const Vec3 way = end - start;
  const double length = way.norm();
  if (length < no_move) {
    return;
  }
  const Segment& segment = toolpath_.segments[block];
  const auto number = static_cast<std::uint32_t>(block);
  if (executed_) {
    Segment run = segment;
    run.kind = SegmentKind::line;
    run.index = -1;
    run.end = end;
    run.length = length;
    executed_->add(run, number);
    elements_.push_back(builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1)));
  } else {
    elements_.push_back(builder_.add_segment(number));
  }
  const bool rapid = segment.rapid || segment.feed == 0;
  const Cause cause = rapid ? Cause{CauseKind::rapid} : feed_cause(segment);
  // Rounded as in Klipper: where the path turns back on itself, that decides whether it stops.
  const Vec3 direction = way * (1 / length);
  const KlipperSettings& limits = limits_.at(segment.line);
  moves_.add(direction, length, rapid ? limits.max_velocity : segment.feed, cause, limits);
}

/// Queues chords of about the resolution, from the start by angles about the programmed centre; the last one
/// ends at the end of the arc.
void KlipperRun::queue_arc(std::size_t block) {
  constexpr double full_turn = 2 * std::numbers::pi;
  const Segment& segment = toolpath_.segments[block];
  const Arc& arc = toolpath_.arc_of(segment);
  const Vec3 axis = arc.x.cross(arc.y);
  const Vec3 center = toolpath_.programmed_center(segment);
  Vec3 start = toolpath_.start_of(block);
  const auto across = [&](const Vec3& place) -> Vec3 {
    const Vec3 spoke = place - center;
    return spoke - axis.dot(spoke) * axis;
  };
  const Vec3 from = across(start);
  const Vec3 to = across(segment.end);
  const Vec3 side = axis.cross(from);
  double sweep = 0;
  if ((to - from).norm() > same_point) {
    sweep = std::atan2(to.dot(side), to.dot(from));
    sweep += sweep < 0 ? full_turn : 0;
  }
  sweep += full_turn * std::round((arc.sweep - sweep) / full_turn);
  const double rise = axis.dot(segment.end - start);
  const double length = std::hypot(sweep * from.norm(), rise);
  const double chords = std::max(1.0, std::floor(length / settings_.arc_resolution));
  const Vec3 bottom = start - from;
  for (double i = 1; i < chords; ++i) {
    const double turned = i * (sweep / chords);
    const Vec3 end = bottom + std::cos(turned) * from + std::sin(turned) * side + i / chords * rise * axis;
    queue_line(block, start, end);
    start = end;
  }
  queue_line(block, start, segment.end);
}

/// Runs everything queued to a stop.
void KlipperRun::flush() {
  moves_.plan();
  const std::vector<KlipperMove>& moves = moves_.moves();
  // Reason for a move to slow down: the next place whose limit is reached, else the stop.
  constexpr double used = 1 - 1e-9;
  std::vector<std::uint8_t> ahead(moves.size());
  Cause slower{CauseKind::exact_stop};
  for (std::size_t i = moves.size(); i-- > 0;) {
    ahead[i] = static_cast<std::uint8_t>(cause_index(slower));
    if (i > 0 && moves[i].start >= moves[i].limit * used &&
        moves[i].limit_cause.kind != CauseKind::path_acceleration) {
      slower = moves[i].limit_cause;
    }
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    lay(moves[i], elements_[i], all_causes()[ahead[i]]);
  }
  moves_.clear();
  elements_.clear();
}

void KlipperRun::lay(const KlipperMove& move, std::uint32_t element, Cause ahead) {
  constexpr std::int8_t z = 2;
  const double start = std::sqrt(move.start);
  const double cruise = std::sqrt(move.cruise);
  const double end = std::sqrt(move.end);
  const double a = move.acceleration;
  const double up = (move.cruise - move.start) / (2 * a);
  const double down = (move.cruise - move.end) / (2 * a);
  const double level = std::max(move.length - up - down, 0.0);
  const Cause accelerates =
      move.z_acceleration ? Cause{CauseKind::axis_acceleration, z} : Cause{CauseKind::path_acceleration};
  builder_.add_piece({0, 0, start, a, 0, element, accelerates}, (cruise - start) / a);
  if (cruise > 0) {
    const bool at_top = move.cruise >= move.top_squared;
    const Cause holds = at_top ? move.top_cause : move.below_peak ? Cause{CauseKind::cruise_ratio} : ahead;
    builder_.add_piece({0, up, cruise, 0, 0, element, holds}, level / cruise);
  }
  Piece brakes{0, move.length - down, cruise, -a, 0, element, {CauseKind::ramp_down}};
  brakes.second = static_cast<std::uint8_t>(cause_index(ahead));
  builder_.add_piece(brakes, (cruise - end) / a);
}

}  // namespace feedscope
