#include "core/program/cycles/drill_plan.h"

namespace feedscope {
namespace {

void feed_to(const Vec3& target, const std::optional<DrillFeed>& feed, PathWriter& path) {
  if (!feed) {
    path.line(target);
    return;
  }
  const double programmed = path.feed();
  const FeedMode mode = path.feed_mode();
  const double speed = path.spindle_speed();
  path.set_feed_mode(feed->mode);
  path.set_feed(feed->value);
  path.set_spindle_speed(feed->spindle_speed > 0 ? feed->spindle_speed : speed);
  path.line(target);
  path.set_spindle_speed(speed);
  path.set_feed_mode(mode);
  path.set_feed(programmed);
}

}  // namespace

void DrillPlan::rapid(double level) {
  level_ = level;
  steps_.push_back({DrillStep::Kind::rapid, level_, aside_, std::nullopt, 0});
}

void DrillPlan::feed(double level, const std::optional<DrillFeed>& feed) {
  level_ = level;
  steps_.push_back({DrillStep::Kind::feed, level_, aside_, feed, 0});
}

void DrillPlan::shift(const Vec3& by) {
  aside_ += by;
  aside_[axis_] = 0;
  rapid(level_ + by[axis_]);
}

void DrillPlan::dwell(double seconds) {
  if (seconds > 0) {
    steps_.push_back({DrillStep::Kind::dwell, level_, aside_, std::nullopt, seconds});
  }
}

void run(const DrillPlan& plan, PathWriter& path, Vec3 hole, const std::function<void(bool rapid)>& before) {
  for (const DrillStep& step : plan.steps()) {
    if (step.kind == DrillStep::Kind::dwell) {
      path.dwell(step.time);
      continue;
    }
    Vec3 target = hole + step.aside;
    target[plan.axis()] = step.level;
    const bool is_rapid = step.kind == DrillStep::Kind::rapid;
    const bool stands = path.knows(plan.axis()) && (target - path.position()).norm() <= same_point;
    if (is_rapid && stands) {
      continue;
    }
    path.program_axis(plan.axis());
    if (before) {
      before(is_rapid);
    }
    if (is_rapid) {
      path.rapid(target);
    } else {
      feed_to(target, step.feed, path);
    }
  }
}

}  // namespace feedscope
