#include "core/models/linuxcnc/linuxcnc_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace feedscope {
namespace {

constexpr double kink_ratio = 0.1;
constexpr double no_length = 1e-12;
constexpr double no_speed = 1e-8;

}  // namespace

void LinuxCncPlanner::add(LinuxCncSegment t) {
  t.length = t.nominal_length = t.course.length;
  if (t.length < no_length) {
    return;
  }
  t.lower_largest(t.length / settings_.period, {CauseKind::interpolation_period});
  if (settings_.master) {
    t.limit_arc();
  }
  if (!queue_.empty()) {
    join(t);
  }
  queue_.push_back(std::move(t));
  optimise();
}

void LinuxCncPlanner::join(LinuxCncSegment& t) {
  LinuxCncSegment& p = queue_.back();
  if (p.rapid != t.rapid || t.waits_for_spindle) {
    p.end = LinuxCncEnd::stop;
  }
  // Joints next to turning rotary axes stay as G61 and G64 set them: the control decides nothing there.
  const bool open = p.progress <= p.length / 2 && p.end != LinuxCncEnd::stop && !p.turns && !t.turns;
  Blended blended = Blended::no;
  if (open && !join_tangentially(p, t) && p.end == LinuxCncEnd::parabolic && !p.finalised) {
    blended = join_by_blend(t);
  }
  if (blended == Blended::in_place_of_it) {
    return;
  }
  LinuxCncSegment& before = queue_[queue_.size() - (blended == Blended::behind_it ? 2 : 1)];
  t.blends_before = open && before.end == LinuxCncEnd::parabolic;
  before.finalise(settings_.period);
}

/// True if the joint is decided: tangential, or a stop at a reversal.
bool LinuxCncPlanner::join_tangentially(LinuxCncSegment& p, LinuxCncSegment& t) const {
  constexpr double two_degrees = std::numbers::pi / 90;
  const Vec3 e = p.course.tangent(p.course.length);
  const Vec3 b = t.course.tangent(0);
  if ((e + b).squaredNorm() < two_degrees * two_degrees) {
    p.end = LinuxCncEnd::stop;
    return true;
  }
  const auto largest = [&](const LinuxCncSegment& s) {
    return std::min(s.requested * settings_.max_override, s.largest);
  };
  const double v = std::min(largest(p), largest(t));
  const double a = v / settings_.period + t.acceleration;
  const Vec3 d = (b - e) * a;
  double q = 0;
  for (int i = 0; i < 3; ++i) {
    q = std::max(q, std::abs(d[i]) / settings_.acceleration[i]);
  }
  q *= p.course.is_arc || t.course.is_arc ? 2 : 1;
  if (q < kink_ratio) {
    p.end = LinuxCncEnd::tangent;
    p.kink_speed = v;
    p.kink_share_next = std::max(p.kink_share_next, q);
    t.kink_share_before = std::max(t.kink_share_before, q);
    return true;
  }
  p.kink_speed = v * kink_ratio / q;
  p.kink_share_next = kink_ratio;
  t.kink_share_before = kink_ratio;
  return false;
}

/// Chooses the fastest of a parabolic blend, a tangential joint at the kink's speed and a blend arc.
LinuxCncPlanner::Blended LinuxCncPlanner::join_by_blend(LinuxCncSegment& t) {
  LinuxCncSegment& p = queue_.back();
  std::optional<LinuxCncBlend> blend = find_linuxcnc_blend(p, t, settings_);
  const double parabolic = find_linuxcnc_overlap(p, t, settings_, false).net / 2;
  const double tangent = p.kink_speed;
  if (blend) {
    blend->arc.tangential_ratio = 0.5;
    blend->arc.lower_largest(blend->arc.length / settings_.period, {CauseKind::interpolation_period});
    if (settings_.master) {
      blend->arc.limit_arc();
    }
  }
  const double arc = blend ? blend->arc.largest : 0;
  const auto forget_kink = [&] {
    p.kink_speed = -1;
    p.kink_share_next = 0;
    t.kink_share_before = 0;
  };
  if (parabolic >= tangent && parabolic >= arc) {
    forget_kink();
    return Blended::no;
  }
  if (tangent >= arc) {
    // Where it has computed an arc, the control chooses once more without it. By then the earlier segment is
    // tangential, and none of its acceleration is reserved.
    p.end = LinuxCncEnd::tangent;
    if (blend && find_linuxcnc_overlap(p, t, settings_, false).net / 2 >= tangent) {
      forget_kink();
      p.end = LinuxCncEnd::parabolic;
    }
    return Blended::no;
  }
  forget_kink();
  LinuxCncSegment& made = blend->arc;
  made.finalised = true;
  t.course.cut_start(blend->cut_second, blend->turn_second);
  t.length = t.course.length;
  if (blend->consumes_first) {
    queue_.pop_back();
    queue_.push_back(std::move(made));
    return Blended::in_place_of_it;
  }
  p.course.cut_end(blend->cut_first, blend->turn_first);
  p.length = p.course.length;
  p.end = LinuxCncEnd::tangent;
  queue_.push_back(std::move(made));
  return Blended::behind_it;
}

/// Final speeds from the newest segment back.
void LinuxCncPlanner::optimise() {
  constexpr std::size_t depth = 51;
  constexpr int most_peaks = 4;
  constexpr double quarter = 0.25;
  constexpr double periods = 1.02;
  int open_joints = 0;
  int peaks = 0;
  for (std::size_t k = 0; k < depth && queue_.size() >= k + 2; ++k) {
    LinuxCncSegment& t = queue_[queue_.size() - 1 - k];
    LinuxCncSegment& p = queue_[queue_.size() - 2 - k];
    if (p.end != LinuxCncEnd::tangent) {
      if (open_joints++ > 0) {
        return;
      }
      continue;
    }
    if (p.progress / p.length >= quarter || p.splitting || p.overlaps) {
      return;
    }
    if (t.waits_for_spindle) {
      t.final_speed = 0;
      t.final_cause = {CauseKind::exact_stop};
    }
    const double kink = p.kink_speed >= 0 ? p.kink_speed : std::numeric_limits<double>::infinity();
    const double a = t.along_acceleration();
    if (!t.finalised) {
      const double stop = std::sqrt(a * t.length);
      const double target = t.target(settings_);
      p.final_speed = std::min({p.largest, stop, target, kink});
      p.final_cause = p.final_speed == kink     ? Cause{CauseKind::kink}
                      : p.final_speed == target ? t.cause(settings_)
                      : p.final_speed == stop   ? Cause{CauseKind::lookahead_horizon}
                                                : p.cause(settings_);
      t.final_speed = 0;
    } else {
      const double limit = std::min({t.largest, p.largest, kink});
      double v = std::sqrt(t.final_speed * t.final_speed + 2 * a * t.length);
      p.at_peak = v >= limit;
      p.final_cause = !p.at_peak      ? t.final_cause
                      : limit == kink ? Cause{CauseKind::kink}
                                      : (limit == t.largest ? t : p).cause(settings_);
      v = std::min(v, limit);
      p.final_speed = v;
      t.lower_largest(t.length / (periods * settings_.period), {CauseKind::interpolation_period});
    }
    if (t.at_peak && ++peaks > most_peaks) {
      return;
    }
  }
}

double LinuxCncPlanner::final_speed(const LinuxCncSegment& t, const LinuxCncSegment* n) const {
  if (t.end != LinuxCncEnd::tangent || n == nullptr) {
    return 0;
  }
  return std::min({t.final_speed, t.target(settings_), n->target(settings_)});
}

/// Cause of the speed at the end of `t`.
Cause LinuxCncPlanner::final_cause(const LinuxCncSegment& t, const LinuxCncSegment* n) const {
  if (t.end != LinuxCncEnd::tangent || n == nullptr) {
    return {t.end == LinuxCncEnd::parabolic && n != nullptr ? CauseKind::contour_tolerance
                                                            : CauseKind::exact_stop};
  }
  const double of_this = t.target(settings_);
  const double of_next = n->target(settings_);
  if (t.final_speed < std::min(of_this, of_next)) {
    return t.final_cause;
  }
  return of_this < of_next ? t.cause(settings_) : n->cause(settings_);
}

void LinuxCncPlanner::give_causes(LinuxCncStep& step, const LinuxCncSegment* n) const {
  constexpr double rounding = 1e-9;
  const LinuxCncSegment& t = *step.segment;
  step.ahead = final_cause(t, n);
  if (step.after > step.before + rounding) {
    step.cause = {CauseKind::axis_acceleration, t.acceleration_axis};
  } else if (step.after < step.before - rounding) {
    step.cause = {CauseKind::ramp_down};
  } else {
    step.cause = step.after >= t.target(settings_) - rounding ? t.cause(settings_) : step.ahead;
  }
}

void LinuxCncPlanner::activate(LinuxCncSegment& t) {
  constexpr double short_time = 1.0 / 100;  // ARC_BLEND_RAMP_FREQ
  if (t.active) {
    return;
  }
  t.active = true;
  const double mean = t.speed + std::min(t.final_speed, t.target(settings_));
  const double time = mean > 0 ? 2 * t.rest() / mean : std::numeric_limits<double>::infinity();
  t.ramps = time < short_time && !t.rapid && t.end == LinuxCncEnd::tangent;
}

void LinuxCncPlanner::update(LinuxCncSegment& t, const LinuxCncSegment* n, double time, bool overlaps) {
  const double a = t.along_acceleration(only_in_overlap());
  const double v = t.speed;
  const double last = final_speed(t, n);
  const double rest = t.rest();
  double wanted = 0;
  double acceleration = 0;
  if (t.ramps && last >= no_speed) {
    const double mean = (v + last) / 2;
    acceleration = std::clamp((last - v) / (rest / mean), -a, a);
    wanted = std::numeric_limits<double>::infinity();
  } else {
    const double k = a * time / 2;
    const double disc = last * last + a * (2 * rest - v * time) + k * k;
    wanted = disc > k * k ? -k + std::sqrt(disc) : -k;
    acceleration = std::clamp((std::min(wanted, t.target(settings_)) - v) / time, -a, a);
  }
  double next = v + acceleration * time;
  const double from = t.progress;
  if (next < 0) {
    next = 0;
    if (rest < v * time) {
      t.progress = t.length;
    }
  } else {
    t.progress = std::min(t.length, t.progress + (v + next) / 2 * time);
  }
  t.brakes_finally = std::abs(wanted - next) < no_speed && acceleration < 0;
  t.speed = next;
  steps_.push_back({&t, from, t.progress, v, next, time, overlaps, {}, {}});
  give_causes(steps_.back(), n);
}

/// Adds further periods at its target or at full acceleration, as update() would run them one by one;
/// update() runs those near the end of either, and of the segment. From a million periods of constant speed
/// on, whose rounding no control keeps, the others are run at once.
void LinuxCncPlanner::go_on(LinuxCncSegment& t, const LinuxCncSegment* n) {
  constexpr double margin = 1 + 1e-9;
  constexpr int most_periods = 1'000'000;  // then, while speeding up, it checks for cancellation
  LinuxCncStep& step = steps_.back();
  const double time = settings_.period;
  const double a = t.along_acceleration(only_in_overlap());
  const double target = t.target(settings_);
  const bool cruises = step.before == target && step.after == target;
  const bool speeds_up =
      step.cause.kind == CauseKind::axis_acceleration && step.after == step.before + a * time;
  if (t.ramps || t.overlaps || !(cruises || speeds_up)) {
    return;
  }
  const double gain = cruises ? 0 : a * time;
  const double last = final_speed(t, n);
  const double k = a * time / 2;
  for (int periods = 2; periods <= most_periods; ++periods) {
    const double v = t.speed;
    const double next = v + gain;
    const double way = (v + next) / 2 * time;
    const double rest = t.rest();
    const double enough = (next + k) * margin;
    const bool is_free = cruises || next * margin < target;
    const bool need_not_brake = last * last + a * (2 * rest - v * time) + k * k > enough * enough;
    const bool ends_later = rest - way > (std::max(next, last) + a * time) * time * margin;
    if (!is_free || !need_not_brake || !ends_later) {
      return;
    }
    t.progress += way;
    t.speed = next;
    step.to = t.progress;
    step.after = next;
    step.time = periods * time;
  }
  if (cruises) {
    const double way = target * time;
    const double enough = (target + k) * margin;
    const double to_brake = (enough * enough - last * last - k * k) / (2 * a) + way / 2;
    const double to_end = way + (std::max(target, last) + a * time) * time * margin;
    const double periods = std::max(std::floor((t.rest() - std::max(to_brake, to_end)) / way), 0.0);
    t.progress += periods * way;
    step.to = t.progress;
    step.time += periods * time;
  }
}

/// True if it is at its end; it may also find that it gets there within the next period.
bool LinuxCncPlanner::check_end(LinuxCncSegment& t, const LinuxCncSegment* n) const {
  const double rest = t.rest();
  const bool stops = t.end == LinuxCncEnd::stop || t.end == LinuxCncEnd::exact;
  if (rest <= no_length) {
    t.progress = t.length;
    t.splitting = true;
    t.split_time = 0;
    t.split_speed = t.speed;
    return stops;
  }
  if (stops) {
    return false;
  }
  double last = final_speed(t, n);
  const double mean = (t.speed + last) / 2;
  if (!(mean > 0)) {
    return false;
  }
  double time = rest / mean;
  const double needed = (last - t.speed) / time;
  const double a = t.along_acceleration(only_in_overlap());
  if (std::abs(needed) > a) {
    const double allowed = needed > 0 ? a : -a;
    const double disc = t.speed * t.speed + 2 * allowed * rest;
    time = disc < 0 ? -t.speed / allowed : 2 * rest / (t.speed + std::sqrt(disc));
    last = t.speed + time * allowed;
  }
  if (time < settings_.period) {
    t.splitting = true;
    t.split_time = time;
    t.split_speed = last;
  }
  return false;
}

/// Runs the rest of a segment, which then leaves, and the beginning of the next one.
void LinuxCncPlanner::run_split(LinuxCncSegment& t, LinuxCncSegment* n, LinuxCncSegment* after) {
  const double time = t.split_time;
  if (time > 0) {
    steps_.push_back({&t, t.progress, t.length, t.speed, t.split_speed, time, false, {}, {}});
    give_causes(steps_.back(), n);
  }
  t.progress = t.length;
  t.speed = t.split_speed;
  if (n != nullptr) {
    const bool tangential = t.end == LinuxCncEnd::tangent;
    n->in_overlap = false;
    if (tangential) {
      n->speed = t.split_speed;
    }
    const double left = tangential ? settings_.period - time : settings_.period;
    update(*n, after, left, !tangential && time > 0);
    check_end(*n, after);
  }
  first_leaves_ = true;
}

const std::vector<LinuxCncStep>& LinuxCncPlanner::run_period(bool nothing_comes) {
  steps_.clear();
  if (first_leaves_) {
    gone_ = std::move(queue_.front());
    queue_.pop_front();
    first_leaves_ = false;
  }
  if (queue_.empty()) {
    return steps_;
  }
  LinuxCncSegment& t = queue_[0];
  LinuxCncSegment* n = queue_.size() > 1 ? &queue_[1] : nullptr;
  LinuxCncSegment* after = queue_.size() > 2 ? &queue_[2] : nullptr;
  activate(t);
  if (t.splitting) {
    run_split(t, n, after);
    return steps_;
  }
  t.in_overlap = t.overlaps;
  update(t, n, settings_.period, false);
  if (n != nullptr && t.end == LinuxCncEnd::parabolic) {
    const LinuxCncOverlap overlap = find_linuxcnc_overlap(t, *n, settings_, false);
    t.overlaps = t.overlaps || (t.brakes_finally && t.speed < overlap.first);
    if (t.overlaps) {
      t.in_overlap = n->in_overlap = true;
      update(*n, nullptr, settings_.period, true);
    }
  }
  if (check_end(t, n)) {
    first_leaves_ = true;
    t.splitting = false;
  } else if (nothing_comes && !t.splitting) {
    go_on(t, n);
  }
  return steps_;
}

}  // namespace feedscope
