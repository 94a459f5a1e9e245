#include "core/models/linuxcnc/linuxcnc_run.h"

#include <algorithm>
#include <cmath>

#include "core/limits/axis_share.h"

namespace feedscope {
namespace {

constexpr std::size_t queue_room = 1880;
constexpr double no_way = 1e-12;     // [mm]
constexpr double least_time = 1e-9;  // what rounding leaves of a period [s]

}  // namespace

LinuxCncRun::LinuxCncRun(std::shared_ptr<const Toolpath> toolpath, const Machine& machine,
                         const LinuxCncSettings& settings)
    : toolpath_(*toolpath),
      settings_(settings),
      executed_(std::make_shared<ExecutedPath>()),
      builder_(std::move(toolpath), axis_limit_vector(machine, &AxisLimits::velocity),
               std::shared_ptr<const ExecutedPath>(executed_)),
      planner_(settings_) {}

/// False: there is none left.
bool LinuxCncRun::take_message() {
  if (next_ >= messages_.size()) {
    return false;
  }
  LinuxCncMessage& message = messages_[next_];
  switch (message.kind) {
    case LinuxCncMessage::Kind::move:
      if (planner_.size() < queue_room) {
        planner_.add(std::move(message.move));
        ++next_;
      }
      break;
    case LinuxCncMessage::Kind::mode:
      ++next_;
      break;
    case LinuxCncMessage::Kind::wait:
      next_ += planner_.empty() ? 1 : 0;
      break;
    case LinuxCncMessage::Kind::dwell:
      if (!planner_.empty()) {
        break;
      }
      dwell_left_ = dwell_left_ < 0 ? message.time : dwell_left_ - settings_.period;
      if (dwell_left_ <= settings_.period / 2) {
        dwell_left_ = -1;
        lay_pause(message.block);
        ++next_;
      }
      break;
  }
  return true;
}

Trajectory LinuxCncRun::run(Progress* progress) {
  Toolpath& path = executed_->path;
  path.start = place_ = toolpath_.start;
  path.path_controls = toolpath_.path_controls;
  path.spindles = toolpath_.spindles;
  path.pauses = toolpath_.pauses;
  path.bounds = toolpath_.bounds;
  messages_ = LinuxCncCanon(toolpath_, settings_).messages();
  ProgressSteps steps(progress, std::max<std::size_t>(messages_.size(), 1));
  while (take_message() || !planner_.empty()) {
    lay(planner_.run_period());
    steps.at(std::min(next_, messages_.size()));
  }
  close();
  lay_standing(last_of_period_);  // what follows the last motion is not counted
  return builder_.finish();
}

void LinuxCncRun::stand(double time) {
  standing_ += builder_.time() > 0 || stretch_.open ? time : 0;
}

void LinuxCncRun::lay(const std::vector<LinuxCncStep>& steps) {
  const bool moves = std::ranges::any_of(steps, [](const LinuxCncStep& s) { return s.to - s.from > no_way; });
  if (!moves) {
    stand(settings_.period);
    return;
  }
  lay_standing(standing_);
  standing_ = 0;
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
    time += step.overlaps ? 0 : step.time;
  }
  standing_ = last_of_period_ = settings_.period - time > least_time ? settings_.period - time : 0;
}

/// Nothing moves for `time` [s].
void LinuxCncRun::lay_standing(double time) {
  if (!(time > 0)) {
    return;
  }
  close();
  if (const std::size_t size = builder_.path().size(); size > 0) {
    const auto last = static_cast<std::uint32_t>(size - 1);
    builder_.add_piece({0, builder_.path().length(last), 0, 0, 0, last, {CauseKind::exact_stop}}, time);
  }
}

/// A step of one segment alone.
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
  stretch_.to = step.to;
  stretch_.segment.splitting = false;
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

Cause LinuxCncRun::cause_of(const LinuxCncStep& step, const LinuxCncSegment& segment) const {
  constexpr double rounding = 1e-9;
  if (step.after > step.before + rounding) {
    return {CauseKind::path_acceleration};
  }
  if (step.after < step.before - rounding) {
    return {CauseKind::ramp_down};
  }
  if (segment.is_blend && segment.largest < segment.requested) {
    return {CauseKind::contour_tolerance};
  }
  if (settings_.max_velocity < std::min(segment.requested, segment.largest)) {
    return {CauseKind::path_velocity};
  }
  return {segment.rapid ? CauseKind::rapid : CauseKind::programmed_feed};
}

/// What is open becomes elements: the lead of a blend arc and its arc are two.
void LinuxCncRun::close() {
  if (!stretch_.open) {
    return;
  }
  stretch_.open = false;
  const LinuxCncSegment& segment = stretch_.segment;
  const LinuxCncCourse& course = segment.course;
  const double length = stretch_.to - stretch_.from;
  if (!(length > 0)) {
    for (const LinuxCncStep& step : stretch_.steps) {
      stand(step.time);
    }
    return;
  }
  std::uint32_t element = 0;
  const bool whole_line = !course.is_arc;
  if (whole_line) {
    element = add_line(course.at(stretch_.to), segment);
  } else {
    if (stretch_.from < course.lead) {
      element = add_line(course.at(std::min(course.lead, stretch_.to)), segment);
    }
    const double from = std::max(stretch_.from, course.lead);
    if (stretch_.to > from) {
      const double share = course.angle / (course.length - course.lead);
      const double turned = (from - course.lead) * share;
      const Vec3 side = course.normal.cross(course.spoke);
      Arc arc;
      arc.x = std::cos(turned) * course.spoke + std::sin(turned) * side;
      arc.y = course.normal.cross(arc.x);
      arc.radius = course.radius + (from - course.lead) / (course.length - course.lead) * course.spiral;
      arc.center = place_ - arc.radius * arc.x;
      arc.sweep = (stretch_.to - from) * share;
      arc.rise = course.height / course.angle * course.normal;
      Segment run = toolpath_.segments[segment.block];
      run.kind = SegmentKind::arc;
      run.index = static_cast<std::int32_t>(executed_->path.arcs.size());
      run.length = arc.length();
      run.rapid = false;
      run.end = arc.at(run.length).position;
      executed_->path.arcs.push_back(arc);
      executed_->add(run, segment.block);
      place_ = run.end;
      const std::uint32_t added =
          builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1));
      element = stretch_.from < course.lead ? element : added;
    }
  }
  const double start = builder_.path().s(element);
  const double laid = builder_.path().length() - start;
  const double scale = laid / length;
  double q = 0;
  for (const LinuxCncStep& step : stretch_.steps) {
    const double way = (step.to - step.from) * scale;
    const double mean = way / step.time;
    const double sum = step.before + step.after;
    const double before = sum > 0 ? 2 * mean * step.before / sum : mean;
    const double after = sum > 0 ? 2 * mean - before : mean;
    std::uint32_t at = element;
    double local = q;
    while (at + 1 < builder_.path().size() && local >= builder_.path().length(at)) {
      local -= builder_.path().length(at);
      ++at;
    }
    builder_.add_piece({0, local, before, (after - before) / step.time, 0, at, cause_of(step, segment)},
                       step.time);
    q += way;
  }
}

/// Both at the same time: the place at the end of the period, reached in a straight line.
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
  const std::uint32_t element = add_line(to, t);
  builder_.add_piece({0, 0, length / time, 0, 0, element, {CauseKind::contour_tolerance}}, time);
}

void LinuxCncRun::lay_pause(std::uint32_t block) {
  close();
  Segment run = toolpath_.segments[block];
  if (toolpath_.is_gap(run)) {
    place_ = run.end;
  }
  run.end = place_;
  executed_->add(run, block);
  builder_.add_executed(static_cast<std::uint32_t>(executed_->block.size() - 1));
}

}  // namespace feedscope
