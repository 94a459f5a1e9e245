#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"
#include "core/models/ward/ward_runner.h"

namespace feedscope {

void WardRunner::lay_motion(const StretchRange& range, const FilteredMotion& motion, ProgressSteps& steps) {
  const std::uint32_t geometry = builder_.add_motion(motion);
  double begin = 0;
  Vec3 start = motion.pulses().front().position;
  std::size_t link = 0;
  for (std::size_t i = range.first; i < range.last; ++i) {
    steps.at(i);
    spans_.clear();
    spans_.push_back({begin, 0, {}, true});
    for (; link < links_.size() && links_[link].segment == i; ++link) {
      add_link_spans(motion, link);
    }
    PathElement element;
    element.kind = ElementKind::filtered;
    element.geometry = geometry;
    element.segment = static_cast<std::uint32_t>(i);
    element.start = start;
    element.end = i + 1 == range.last ? end_ : motion.at(spans_.back().end).position;
    element.length = spans_.back().q;
    const Segment& segment = toolpath_.segments[i];
    const std::uint32_t index = builder_.add_element(
        element, segment.line, programmed_speed(toolpath_, i, axes_.velocity).value, segment.rapid);
    for (std::size_t k = 1; k < spans_.size(); ++k) {
      builder_.add_piece({0, spans_[k - 1].q, 0, 0, 0, index, spans_[k].cause, Law::filtered},
                         motion.start() + spans_[k].end - builder_.time());
    }
    if (i + 1 < range.last && links_[link - 1].turn > straight_angle) {
      add_record(motion, link, index);
    }
    begin = spans_.back().end;
    start = element.end;
  }
}

void WardRunner::add_link_spans(const FilteredMotion& motion, std::size_t link) {
  const LinkPulses pulses = link_pulses(links_, link, half_delay_, corner_speeds_);
  const bool last = link + 1 == links_.size();
  const double end = last ? motion.duration() : link_start_[link + 1] + half_delay_;
  const double begin = spans_.back().end;
  constexpr double rounding = 1e-9;
  const auto add = [&](double to, bool settled, std::optional<std::size_t> corner) {
    to = std::min(to, end);
    const double from = spans_.back().end;
    if (to - from > rounding * filter_time_) {
      add_span(motion, to, cause_between(motion, from, to, link, pulses.feed, corner), settled);
    }
  };
  if (end - begin <= filter_time_ / 2) {
    add(end, false, pulses.width > 0 ? std::nullopt : std::optional(last ? link : link + 1));
    return;
  }
  const double feed_from = link_start_[link] + pulses.width_left;
  const double feed_to = feed_from + pulses.width;
  add(feed_from + (link > 0 ? half_delay_ : 0), false, link);
  const double settled_from = feed_from + 2 * half_delay_;
  if (settled_from < feed_to) {
    add(settled_from, false, std::nullopt);
    add(feed_to, true, std::nullopt);
  } else {
    add((spans_.back().end + std::min(end, feed_to + half_delay_)) / 2, false, std::nullopt);
  }
  add(last ? end : feed_to + half_delay_, false, std::nullopt);
  add(end, false, link + 1);
}

void WardRunner::add_span(const FilteredMotion& motion, double end, const Cause& cause, bool settled) {
  const Span before = spans_.back();
  const double q = before.q + motion.length(before.end, end);
  if (spans_.size() > 1 && !settled && !before.settled && before.cause == cause &&
      end - spans_[spans_.size() - 2].end <= filter_time_) {
    spans_.back().end = end;
    spans_.back().q = q;
    return;
  }
  spans_.push_back({end, q, cause, settled});
}

bool WardRunner::slowed_by_tolerance(std::size_t corner) const {
  constexpr double rounding = 1e-9;
  return corner > 0 && corner < links_.size() &&
         corner_speeds_[corner] <
             std::min(links_[corner - 1].feed.value, links_[corner].feed.value) * (1 - rounding);
}

Cause WardRunner::cause_between(const FilteredMotion& motion, double from, double to, std::size_t link,
                                double feed, std::optional<std::size_t> corner) const {
  constexpr double reached = 0.99;
  const Kinematics at = motion.at((from + to) / 2);
  if (at.velocity.norm() >= reached * links_[link].feed.value) {
    return links_[link].feed.cause;
  }
  if (feed < reached * links_[link].feed.value || (corner && slowed_by_tolerance(*corner))) {
    return {CauseKind::contour_tolerance};
  }
  return at.acceleration.dot(at.velocity) >= 0 ? Cause{CauseKind::axis_jerk} : Cause{CauseKind::ramp_down};
}

void WardRunner::add_record(const FilteredMotion& motion, std::size_t corner, std::uint32_t element) {
  const LinkPulses before = link_pulses(links_, corner - 1, half_delay_, corner_speeds_);
  const LinkPulses after = link_pulses(links_, corner, half_delay_, corner_speeds_);
  const double middle = link_start_[corner] + half_delay_;
  const double from = middle - before.width_right;
  const double to = middle + after.width_left;
  const Approach nearest = approach(motion, corner, 0);
  const Kinematics at = motion.at(nearest.time);
  const double bend = at.velocity.cross(at.acceleration).norm();

  BlendRecord record;
  record.line = toolpath_.segments[links_[corner - 1].segment].line;
  record.element = element;
  record.corner = links_[corner].start;
  record.turn = links_[corner - 1].turn;
  record.transition = corner_speeds_[corner] * std::max(before.width_right, after.width_left);
  record.epsilon = nearest.distance;
  record.length = motion.length(from, to);
  record.min_radius = bend > 0 ? std::pow(at.velocity.norm(), 3) / bend : 0;
  record.entry_speed = motion.velocity(from).norm();
  record.exit_speed = motion.velocity(to).norm();
  builder_.add_blend_record(record);
}

}  // namespace feedscope
