#include "core/models/linuxcnc/linuxcnc_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/blend/junction.h"
#include "core/limits/axis_share.h"

namespace feedscope {
namespace {

constexpr std::size_t queue_room = 1880;
constexpr double no_way = 1e-12;     // [mm]
constexpr double least_time = 1e-9;  // rounding of a period [s]
constexpr double rounding = 1e-7;    // of a speed, relative

/// True if its way is that of constant acceleration.
bool is_even(const LinuxCncStep& step) {
  const double mean = (step.before + step.after) / 2;
  return std::abs((step.to - step.from) / step.time - mean) <= rounding * mean;
}

bool is_same_ramp(const LinuxCncStep& first, const LinuxCncStep& second) {
  const double a = (first.after - first.before) / first.time;
  const double b = (second.after - second.before) / second.time;
  return first.cause == second.cause && first.ahead == second.ahead && first.after == second.before &&
         std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

}  // namespace

LinuxCncRun::LinuxCncRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
                         const LinuxCncSettings& settings)
    : toolpath_(*toolpath),
      settings_(settings),
      executed_(std::make_shared<ExecutedPath>()),
      builder_(std::move(toolpath), axis_limit_vector(machine, &AxisLimits::velocity),
               std::shared_ptr<const ExecutedPath>(executed_)),
      planner_(settings_),
      canon_(toolpath_, settings_),
      message_(canon_.next()) {}

/// Returns false if there is none left.
bool LinuxCncRun::take_message() {
  while (message_ && message_->kind == LinuxCncMessage::Kind::pause && planner_.empty()) {
    standing_.push_back({message_->block, 0});
    message_ = canon_.next();
  }
  if (!message_) {
    return false;
  }
  bool taken = true;
  switch (message_->kind) {
    case LinuxCncMessage::Kind::move:
      taken = planner_.size() < queue_room;
      if (taken) {
        planner_.add(std::move(message_->move));
      }
      break;
    case LinuxCncMessage::Kind::mode:
      break;
    case LinuxCncMessage::Kind::wait:
      taken = planner_.empty();
      break;
    case LinuxCncMessage::Kind::dwell:
      taken = planner_.empty();
      if (taken) {
        wait_for(*message_);
      }
      break;
    case LinuxCncMessage::Kind::pause:
      taken = false;  // until all motion has ended
      break;
  }
  if (taken) {
    message_ = canon_.next();
  }
  return true;
}

/// True if the planner may get a segment while it moves.
bool LinuxCncRun::takes_moves() const {
  using Kind = LinuxCncMessage::Kind;
  return message_ &&
         (message_->kind == Kind::mode || (message_->kind == Kind::move && planner_.size() < queue_room));
}

/// Waits for all periods of the dwell; the last one is the current one.
void LinuxCncRun::wait_for(const LinuxCncMessage& dwell) {
  const double periods = std::max(std::ceil(dwell.time / settings_.period - 0.5), 0.0);
  standing_.push_back({dwell.block, periods * settings_.period});
  if (periods > 0) {
    stand(-settings_.period);  // added by this period
  }
}

Trajectory LinuxCncRun::run(Progress* progress) {
  Toolpath& path = executed_->path;
  path.start = place_ = toolpath_.start;
  path.path_controls = toolpath_.path_controls;
  path.spindles = toolpath_.spindles;
  path.pauses = toolpath_.pauses;
  path.bounds = toolpath_.bounds;
  const std::size_t blocks = toolpath_.segments.size();
  builder_.stop_with(progress);
  ProgressSteps steps(progress, std::max<std::size_t>(blocks, 1));
  while (take_message() || !planner_.empty()) {
    lay(planner_.run_period(!takes_moves()));
    steps.at(message_ ? message_->block : blocks);
  }
  close();
  if (builder_.time() > 0 && last_of_period_ > 0) {
    stand_on_last(last_of_period_);  // apart from this, the time after the last motion is not counted
    lay_standing(false);
  } else {
    lay_standing(builder_.time() == 0);
  }
  return builder_.finish();
}

void LinuxCncRun::stand(double time) {
  if (standing_.empty() || standing_.back().pause) {
    standing_.emplace_back();
  }
  standing_.back().time += time;
}

void LinuxCncRun::lay(const std::vector<LinuxCncStep>& steps) {
  const bool moves = std::ranges::any_of(steps, [](const LinuxCncStep& s) { return s.to - s.from > no_way; });
  if (!moves) {
    stand(settings_.period);
    return;
  }
  lay_standing(builder_.time() > 0 || stretch_.open);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i + 1 < steps.size() && steps[i + 1].overlaps) {
      lay_overlap(steps[i], steps[i + 1]);
      ++i;
    } else {
      extend(steps[i]);
    }
  }
  double time = 0;
  for (const LinuxCncStep& step : steps) {
    time = step.overlaps ? std::max(time, step.time) : time + step.time;
  }
  last_of_period_ = settings_.period - time > least_time ? settings_.period - time : 0;
  if (last_of_period_ > 0) {
    stand(last_of_period_);
  }
}

/// Lays the waiting since the last motion, with its time if that `counts`.
void LinuxCncRun::lay_standing(bool counts) {
  if (standing_.empty()) {
    return;
  }
  close();
  for (const Standing& standing : standing_) {
    const double time = counts ? standing.time : 0;
    if (standing.pause) {
      lay_pause(*standing.pause, time);
    } else {
      stand_on_last(time);
    }
  }
  standing_.clear();
}

/// Lays a stop of `time` [s] at the end of the laid motion.
void LinuxCncRun::stand_on_last(double time) {
  if (const std::size_t size = builder_.path().size(); size > 0) {
    const auto last = static_cast<std::uint32_t>(size - 1);
    builder_.add_piece({0, builder_.path().length(last), 0, 0, 0, last, {CauseKind::exact_stop}}, time);
  }
}

/// Adds a step of one segment alone; one that continues the previous step is joined to it.
void LinuxCncRun::extend(const LinuxCncStep& step) {
  const LinuxCncSegment& segment = *step.segment;
  const bool goes_on = stretch_.open && stretch_.segment.block == segment.block &&
                       stretch_.segment.is_blend == segment.is_blend &&
                       std::abs(stretch_.to - step.from) < no_way &&
                       stretch_.segment.course.start == segment.course.start;
  if (!goes_on) {
    close();
    stretch_.open = true;
    stretch_.segment = segment;
    stretch_.from = step.from;
    stretch_.steps.clear();
  }
  stretch_.segment.course = segment.course;  // the next block may have cut off a part of it
  stretch_.to = step.to;
  if (!stretch_.steps.empty() && is_even(step) && is_even(stretch_.steps.back()) &&
      is_same_ramp(stretch_.steps.back(), step)) {
    LinuxCncStep& last = stretch_.steps.back();
    last.to = step.to;
    last.after = step.after;
    last.time += step.time;
    return;
  }
  stretch_.steps.push_back(step);
  stretch_.steps.back().segment = nullptr;
}

std::uint32_t LinuxCncRun::add_line(const Vec3& to, const LinuxCncSegment& of) {
  Segment run = toolpath_.segments[of.block];
  run.kind = SegmentKind::line;
  run.index = -1;
  run.end = to;
  run.length = (to - place_).norm();
  run.rapid = of.rapid;
  executed_->add(run, of.block);
  place_ = to;
  return builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1));
}

/// True if the open arc is no spiral and begins at the end of the laid motion.
bool LinuxCncRun::is_circle_from(double from) const {
  constexpr double same_place = 1e-11;  // [mm]
  const LinuxCncCourse& course = stretch_.segment.course;
  return std::abs(course.spiral) < same_place && (course.at(from) - place_).norm() < same_place;
}

/// Adds an arc of the course up to `to`. A spiral, or an arc that begins slightly off the laid motion,
/// becomes several, each through its ends.
std::uint32_t LinuxCncRun::add_arc(double from, double to) {
  const LinuxCncSegment& segment = stretch_.segment;
  const LinuxCncCourse& course = segment.course;
  const double share = course.angle / (course.length - course.lead);
  Arc arc;
  arc.sweep = (to - from) * share;
  const Vec3 way = course.at(to) - place_;
  arc.rise = course.normal.dot(way) / arc.sweep * course.normal;
  const Vec3 chord = way - course.normal.dot(way) * course.normal;
  if (is_circle_from(from)) {
    const double turned = (from - course.lead) * share;
    arc.x = std::cos(turned) * course.spoke + std::sin(turned) * course.normal.cross(course.spoke);
    arc.x = (arc.x - course.normal.dot(arc.x) * course.normal).normalized();
    arc.radius = course.radius;
    arc.center = place_ - arc.radius * arc.x;
  } else {
    arc.center = place_ + chord / 2 + course.normal.cross(chord) / (2 * std::tan(arc.sweep / 2));
    arc.x = place_ - arc.center;
    arc.radius = arc.x.norm();
    arc.x /= arc.radius;
  }
  arc.y = course.normal.cross(arc.x);
  Segment run = toolpath_.segments[segment.block];  // a blend is between two rapids or two feed motions
  run.kind = SegmentKind::arc;
  run.index = static_cast<std::int32_t>(executed_->path.arcs.size());
  run.length = arc.length();
  run.end = arc.at(run.length).position;
  executed_->path.arcs.push_back(arc);
  executed_->add(run, segment.block);
  place_ = run.end;
  return builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1));
}

/// Makes the elements from `first` to the last one round a joint; they may extend those that round it
/// already.
void LinuxCncRun::round(const LinuxCncJoint& joint, std::uint32_t first) {
  const auto last = static_cast<std::uint32_t>(builder_.path().size() - 1);
  std::vector<RoundedCorner>& corners = executed_->corners;
  const bool goes_on = !corners.empty() && corners.back().last + 1 == first &&
                       corners.back().block == joint.block && corners.back().point == joint.point;
  if (goes_on) {
    corners.back().last = last;
  } else {
    corners.push_back({first, last, joint.block, joint.point, joint.turn});
  }
}

/// Lays the open part as elements and returns the first one: the lead of a blend arc and its arc are two.
std::uint32_t LinuxCncRun::lay_course() {
  constexpr double most_of_spiral = std::numbers::pi / 2;
  const LinuxCncSegment& segment = stretch_.segment;
  const LinuxCncCourse& course = segment.course;
  if (!course.is_arc || stretch_.to <= course.lead) {
    return add_line(course.at(stretch_.to), segment);
  }
  std::optional<std::uint32_t> first;
  const Vec3 begin = course.at(course.lead);
  if (stretch_.from < course.lead && (begin - place_).norm() > no_way) {  // for a length of zero it has no
                                                                          // direction
    first = add_line(begin, segment);
  }
  const double from = std::max(stretch_.from, course.lead);
  const double length = stretch_.to - from;
  const double turn = length * course.angle / (course.length - course.lead);
  const double parts = is_circle_from(from) ? 1 : std::ceil(turn / most_of_spiral);
  for (double i = 0; i < parts; ++i) {
    const std::uint32_t added = add_arc(from + i / parts * length, from + (i + 1) / parts * length);
    first = first.value_or(added);
    if (segment.is_blend) {
      round(segment.joint, added);
    }
  }
  return *first;
}

void LinuxCncRun::close() {
  if (!stretch_.open) {
    return;
  }
  stretch_.open = false;
  const double length = stretch_.to - stretch_.from;
  if (!(length > no_way)) {
    for (const LinuxCncStep& step : stretch_.steps) {
      stand(step.time);
    }
    return;
  }
  const std::uint32_t element = lay_course();
  const double laid = builder_.path().length() - builder_.path().s(element);
  const double scale = laid / length;
  for (LinuxCncStep step : stretch_.steps) {
    step.to = (step.to - stretch_.from) * scale;
    step.from = (step.from - stretch_.from) * scale;
    lay_step(step, element, step.to - step.from);
  }
}

/// Lays a step of `length` at `step.from` after the start of `element`; its speeds are those of the control,
/// adapted to that length.
void LinuxCncRun::lay_step(const LinuxCncStep& step, std::uint32_t element, double length) {
  const double mean = length / step.time;
  const double sum = step.before + step.after;
  const double before = sum > 0 ? 2 * mean * step.before / sum : mean;
  const double after = sum > 0 ? 2 * mean - before : mean;
  double local = step.from;
  while (element + 1 < builder_.path().size() && local >= builder_.path().length(element)) {
    local -= builder_.path().length(element);
    ++element;
  }
  Piece piece{0, local, before, (after - before) / step.time, 0, element, step.cause};
  piece.second = static_cast<std::uint8_t>(cause_index(step.ahead));
  builder_.add_piece(piece, step.time);
}

/// Lays two simultaneous steps: a straight line to the place at the end of the period.
void LinuxCncRun::lay_overlap(const LinuxCncStep& first, const LinuxCncStep& second) {
  const LinuxCncSegment& p = *first.segment;
  const LinuxCncSegment& t = *second.segment;
  close();
  const Vec3 to = place_ + (p.course.at(first.to) - p.course.at(first.from)) +
                  (t.course.at(second.to) - t.course.at(second.from));
  const double length = (to - place_).norm();
  const double time = std::max(first.time, second.time);
  if (!(length > no_way)) {
    stand(time);
    return;
  }
  const auto speed = [&](double share) {
    const auto velocity = [&](const LinuxCncStep& step) -> Vec3 {
      const double s = step.from + share * (step.to - step.from);
      return (step.before + share * (step.after - step.before)) * step.segment->course.tangent(s);
    };
    return (velocity(first) + velocity(second)).norm();
  };
  const Cause blends{CauseKind::contour_tolerance};
  const std::uint32_t element = add_line(to, t);
  const Vec3 in = p.course.tangent(p.course.length);
  const Vec3 out = t.course.tangent(0);
  round({p.block, t.course.at(0), turn_angle(in, out)}, element);
  lay_step({nullptr, 0, length, speed(0), speed(1), time, false, blends, blends}, element, length);
}

void LinuxCncRun::lay_pause(std::uint32_t block, double time) {
  Segment run = toolpath_.segments[block];
  if (toolpath_.is_gap(run)) {
    place_ = run.end;
  }
  run.end = place_;
  executed_->add(run, block);
  builder_.pass_pause(builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1)), time);
}

}  // namespace feedscope
