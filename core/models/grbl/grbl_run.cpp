#include "core/models/grbl/grbl_run.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/limits/axis_share.h"
#include "core/limits/segment_limits.h"

namespace feedscope {
namespace {

constexpr std::size_t segments_ahead = 5;  // that are prepared in advance

std::array<float, 3> as_floats(const Vec3& place) {
  return {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])};
}

CauseKind cause_of(Pause pause) {
  switch (pause) {
    case Pause::tool_change:
      return CauseKind::tool_change;
    case Pause::spindle_start:
      return CauseKind::spindle_start;
    default:
      return CauseKind::dwell;
  }
}

/// The arc as grbl reads it from the words of the block.
GrblArc arc_of(const Arc& arc, const Vec3& center, const Vec3& start, const Vec3& end) {
  const Vec3 axis = arc.x.cross(arc.y);
  Eigen::Index third = 0;
  axis.cwiseAbs().maxCoeff(&third);
  GrblArc read;
  read.axes = {static_cast<std::size_t>((third + 1) % 3), static_cast<std::size_t>((third + 2) % 3),
               static_cast<std::size_t>(third)};
  read.start = as_floats(start);
  read.end = as_floats(end);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto j = static_cast<Eigen::Index>(read.axes[i]);
    read.to_center[i] = static_cast<float>(center[j] - start[j]);
  }
  read.radius = std::hypot(read.to_center[0], read.to_center[1]);
  read.clockwise = axis[third] < 0;
  return read;
}

}  // namespace

GrblRun::GrblRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
                 const GrblSettings& settings)
    : toolpath_(*toolpath),
      settings_(settings),
      executed_(std::make_shared<ExecutedPath>()),
      builder_(std::move(toolpath), axis_limit_vector(machine, &AxisLimits::velocity), executed_),
      planner_(settings_),
      steps_(settings_, planner_) {}

Trajectory GrblRun::run(Progress* progress) {
  progress_ = progress;
  Toolpath& path = executed_->path;
  path.path_controls = toolpath_.path_controls;
  path.spindles = toolpath_.spindles;
  path.pauses = toolpath_.pauses;
  path.bounds = toolpath_.bounds;
  planner_.set_place(as_floats(toolpath_.start));
  path.start = place_of(planner_.place());
  path.segments.reserve(toolpath_.segments.size());
  builder_.reserve(toolpath_.segments.size(), toolpath_.segments.size());
  for (std::size_t i = 0; i < toolpath_.segments.size(); ++i) {
    last_motion_ = toolpath_.segments[i].kind != SegmentKind::dwell ? i : last_motion_;
  }
  ProgressSteps steps(progress, toolpath_.segments.size());
  for (std::size_t i = 0; i < toolpath_.segments.size(); ++i) {
    const Segment& segment = toolpath_.segments[i];
    block_ = static_cast<std::uint32_t>(i);
    switch (segment.kind) {
      case SegmentKind::line:
        feed_line(segment);
        break;
      case SegmentKind::arc:
        feed_arc(segment, toolpath_.arc_of(segment));
        break;
      case SegmentKind::dwell:
        run_out();
        pause(segment);
        break;
    }
    steps.at(i);
  }
  run_out();
  return builder_.finish();
}

Vec3 GrblRun::place_of(const GrblPlace& place) const {
  Vec3 mm;
  for (std::size_t i = 0; i < 3; ++i) {
    mm[static_cast<Eigen::Index>(i)] =
        settings_.has_steps() ? static_cast<double>(place.steps[i]) / static_cast<double>(settings_.steps[i])
                              : static_cast<double>(place.mm[i]);
  }
  return mm;
}

void GrblRun::feed_line(const Segment& segment) {
  queue_line(as_floats(segment.end), segment);
}

void GrblRun::feed_arc(const Segment& segment, const Arc& arc) {
  const GrblArc read =
      arc_of(arc, toolpath_.programmed_center(segment), toolpath_.start_of(block_), segment.end);
  GrblChords chords(read, settings_.arc_tolerance);
  for (std::uint32_t i = 1; i < chords.count(); ++i) {
    queue_line(chords.next(), segment);
  }
  queue_line(read.end, segment);
}

/// Waits for room, then plans the line.
void GrblRun::queue_line(const std::array<float, 3>& target, const Segment& segment) {
  constexpr double seconds_a_minute = 60;
  for (;;) {
    if (running_) {
      prepare();
    }
    if (!planner_.full()) {
      break;
    }
    if (running_) {
      --ready_;  // one is run
    }
    running_ = true;
  }
  GrblPlanner::Line line;
  line.target = target;
  line.rapid = segment.rapid || segment.feed == 0;
  line.feed = static_cast<float>(segment.feed * seconds_a_minute);
  line.id = static_cast<std::uint32_t>(executed_->path.segments.size());
  const Vec3 start = place_of(planner_.place());
  if (!planner_.add(line, steps_.running_speed())) {
    return;
  }
  if (planner_.reached_front()) {
    steps_.begin_again();
  }
  Segment run = segment;
  run.kind = SegmentKind::line;
  run.index = -1;
  run.end = place_of(planner_.place());
  run.length = (run.end - start).norm();
  executed_->add(run, block_);
}

/// Prepares segments as long as there is room for them.
void GrblRun::prepare() {
  stop_if_cancelled(progress_);
  while (ready_ < segments_ahead && !planner_.empty()) {
    if (!steps_.has_profile()) {
      name_causes();
    }
    const GrblBlock block = planner_.front();
    const GrblSegment segment = steps_.next();
    ++ready_;
    lay(block, segment);
  }
}

/// Runs all queued motion to its end.
void GrblRun::run_out() {
  draining_ = true;
  while (!planner_.empty()) {
    ready_ = 0;
    prepare();
  }
  ready_ = 0;
  draining_ = running_ = false;
}

/// grbl keeps the motors locked for a while each time they come to rest; the time after the last motion is
/// not counted.
void GrblRun::pause(const Segment& segment) {
  Segment run = segment;
  if (toolpath_.is_gap(segment)) {
    planner_.set_place(as_floats(segment.end));
  }
  run.end = place_of(planner_.place());
  executed_->add(run, block_);
  const std::uint32_t element = builder_.add_executed(begun_++);
  const bool holds = moved_ && block_ < last_motion_;
  const CauseKind kind = cause_of(toolpath_.pause_of(segment).kind);
  builder_.add_piece({0, 0, 0, 0, 0, element, {kind}},
                     toolpath_.dwell_of(segment) + (holds ? settings_.idle_delay : 0));
  moved_ = false;
}

Cause GrblRun::level_cause(const GrblBlock& block) const {
  const Segment& segment = executed_->path.segments[block.id];
  if (block.speed_axis < 0) {
    return feed_cause(segment);
  }
  return {segment.rapid || segment.feed == 0 ? CauseKind::rapid : CauseKind::axis_velocity, block.speed_axis};
}

/// Sets the causes of the speeds of the current block: its exit speed is limited by the next place that is
/// passed at its largest speed, or by the end of the queue.
void GrblRun::name_causes() {
  const GrblBlock& block = planner_[0];
  up_ = {CauseKind::axis_acceleration, block.acceleration_axis};
  level_ = level_cause(block);
  ahead_ = {draining_ ? CauseKind::exact_stop : CauseKind::lookahead_horizon};
  for (std::size_t i = 1; i < planner_.size(); ++i) {
    const GrblBlock& next = planner_[i];
    if (next.entry_squared == next.max_entry_squared) {
      ahead_ = next.entry == GrblEntry::junction    ? Cause{CauseKind::junction_deviation}
               : next.entry == GrblEntry::own_speed ? level_cause(next)
                                                    : level_cause(planner_[i - 1]);
      return;
    }
  }
}

GrblRun::Ramp GrblRun::ramp_of(const GrblSpan& span) const {
  constexpr double minute = 60;
  Ramp ramp;
  ramp.before = static_cast<double>(span.before) / minute;
  ramp.after = static_cast<double>(span.after) / minute;
  ramp.way = scale_ * static_cast<double>(span.from - span.to);
  ramp.time = static_cast<double>(span.time) * minute;
  ramp.phase = span.phase;
  ramp.ahead = ahead_;
  ramp.cause = span.phase == GrblPhase::accelerates ? up_
               : span.phase == GrblPhase::brakes    ? Cause{CauseKind::ramp_down}
                                                    : level_;
  return ramp;
}

/// With speeds from its way and time, in the ratio of the planned ones.
void GrblRun::add(const Ramp& ramp) {
  if (!(ramp.time > 0) || !(ramp.way >= 0)) {
    return;
  }
  const double sum = ramp.before + ramp.after;
  const double mean = ramp.way / ramp.time;
  const double before = sum > 0 ? 2 * mean * ramp.before / sum : mean;
  const double after = sum > 0 ? 2 * mean - before : mean;
  Piece piece{0, laid_, before, (after - before) / ramp.time, 0, element_, ramp.cause};
  if (ramp.cause.kind == CauseKind::ramp_down) {
    piece.second = static_cast<std::uint8_t>(cause_index(ramp.ahead));
  }
  builder_.add_piece(piece, ramp.time);
  laid_ += ramp.way;
}

void GrblRun::lay(const GrblBlock& block, const GrblSegment& segment) {
  constexpr double minute = 60;
  const double length = executed_->path.segments[segment.block].length;
  if (segment.block == begun_) {
    element_ = builder_.add_executed(begun_++);
    laid_ = 0;
    scale_ = length / static_cast<double>(block.left);
    ramps_.clear();
    acceleration_ = static_cast<double>(block.acceleration) / (minute * minute);
  }
  moved_ = true;
  const bool as_planned = !settings_.step_timing || !settings_.has_steps();
  const double slower = segment.time / (minute * static_cast<double>(segment.planned));
  std::span<const GrblSpan> spans = steps_.spans();
  GrblSpan whole = spans.front();
  if (!as_planned && std::ranges::any_of(spans, [](const GrblSpan& span) { return span.time < 0; })) {
    whole.to = spans.back().to;
    whole.after = spans.back().after;
    whole.time = segment.planned;
    spans = {&whole, 1};
  }
  for (const GrblSpan& span : spans) {
    Ramp ramp = ramp_of(span);
    if (as_planned) {
      collect(ramp);
      continue;
    }
    ramp.time *= slower;
    if (segment.ends_block && &span == &spans.back()) {
      ramp.way = length - laid_;
    }
    add(ramp);
  }
  if (as_planned && segment.ends_block) {
    lay_collected();
  }
}

/// Joins the parts of one ramp in several segments.
void GrblRun::collect(const Ramp& ramp) {
  if (!ramps_.empty() && ramps_.back().phase == ramp.phase && ramps_.back().cause == ramp.cause &&
      ramps_.back().ahead == ramp.ahead) {
    ramps_.back().after = ramp.after;
    ramps_.back().time += ramp.time;
  } else {
    ramps_.push_back(ramp);
  }
}

/// Times and ways follow from the speeds, fitted to the length of the block: in 32 bits the remaining length
/// of a long block is less precise than its speeds.
void GrblRun::lay_collected() {
  const double length = builder_.path().length(element_);
  double sum = 0;
  for (Ramp& ramp : ramps_) {
    const double change = std::abs(ramp.after - ramp.before);
    if (ramp.phase != GrblPhase::cruises && change > 0) {
      ramp.time = change / acceleration_;
    }
    ramp.way = (ramp.before + ramp.after) / 2 * ramp.time;
    sum += ramp.way;
  }
  const double fit = length / sum;
  for (Ramp& ramp : ramps_) {
    ramp.way = &ramp == &ramps_.back() ? length - laid_ : ramp.way * fit;
    ramp.time *= fit;
    add(ramp);
  }
}

}  // namespace feedscope
