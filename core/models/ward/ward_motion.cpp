#include "core/models/ward/ward_motion.h"

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"
#include "core/models/ward/corner_pulse.h"
#include "core/trajectory/filtered_corner.h"

namespace feedscope {

void WardMotion::lay(double error, ProgressSteps& steps) {
  PulseTrain& train = pulses_.train;
  const double start = builder_.time();
  FilterWalk walk;
  LengthWalk length(walk, train, 0);
  for (std::size_t i = 0; i < train.size(); ++i) {
    steps.at(train.first + i);
    if (i > 0 && corner_turn(train, i) > straight_angle) {
      builder_.add_filtered_corner();
    }
    add_spans(length, i);
    add_element(start, i);
  }
  train.blocks.shrink_to_fit();
  builder_.add_motion({start, std::move(train), error});
}

void WardMotion::add_element(double start, std::size_t block) {
  const std::uint32_t index = builder_.add_filtered(static_cast<std::uint32_t>(pulses_.train.first + block),
                                                    spans_.back().q, builder_.motion_count());
  for (std::size_t k = 1; k < spans_.size(); ++k) {
    builder_.add_piece({0, spans_[k - 1].q, 0, 0, 0, index, spans_[k].cause, Law::filtered},
                       start + spans_[k].end - builder_.time());
  }
}

void WardMotion::add_spans(LengthWalk& length, std::size_t block) {
  const double c = pulses_.train.half_delay();
  const bool last = block + 1 == pulses_.train.size();
  const double begin = block > 0 ? pulses_.train.blocks[block].start + c : 0;
  const double end = last ? pulses_.train.duration() : pulses_.train.blocks[block + 1].start + c;
  const PulseWidths widths = pulses_.train.widths(block);
  spans_.clear();
  spans_.push_back({begin, 0, {}, true});
  if (end - begin <= pulses_.train.filter_time / 2) {
    const bool no_middle = widths.middle <= 0;
    add_span(length, block, {end, no_middle ? std::optional(last ? block : block + 1) : std::nullopt});
    return;
  }
  const double feed_from = pulses_.train.blocks[block].start + widths.left;
  const double feed_to = pulses_.train.blocks[block + 1].start - widths.right;
  const double settled_from = feed_from + 2 * c;
  add_span(length, block, {std::min(end, feed_from + (block > 0 ? c : 0)), block});
  if (settled_from < feed_to) {
    add_span(length, block, {settled_from});
    add_span(length, block, {feed_to, std::nullopt, !pulses_.is_arc(block)});
  } else {
    add_span(length, block, {(spans_.back().end + std::min(end, feed_to + c)) / 2});
  }
  add_span(length, block, {last ? end : std::min(end, feed_to + c)});
  add_span(length, block, {end, block + 1});
}

void WardMotion::add_span(LengthWalk& length, std::size_t block, const SpanEnd& to) {
  constexpr double rounding = 1e-9;
  const Span before = spans_.back();
  if (to.time - before.end <= rounding * pulses_.train.filter_time) {
    return;
  }
  const double q = before.q + length.advance_to(to.time);
  const Cause cause = cause_at(length.sample_at((before.end + to.time) / 2), block, to.corner);
  if (spans_.size() > 1 && !to.settled && !before.settled && before.cause == cause) {
    spans_.back() = {to.time, q, cause, false};
  } else {
    spans_.push_back({to.time, q, cause, to.settled});
  }
}

bool WardMotion::slowed_by_tolerance(std::size_t corner) const {
  constexpr double rounding = 1e-9;
  return corner > 0 && corner < pulses_.train.size() &&
         pulses_.corner_speeds[corner] <
             std::min(pulses_.limits[corner - 1].value, pulses_.limits[corner].value) * (1 - rounding);
}

Cause WardMotion::cause_at(const SpeedSample& at, std::size_t block,
                           std::optional<std::size_t> corner) const {
  constexpr double reached = 0.99;
  const double limit = pulses_.limits[block].value;
  if (at.speed >= reached * limit * (pulses_.is_arc(block) ? arc_gain(block) : 1.0)) {
    return pulses_.limits[block].cause;
  }
  if (pulses_.train.blocks[block].feed < reached * limit || (corner && slowed_by_tolerance(*corner))) {
    return {CauseKind::contour_tolerance};
  }
  return at.slope >= 0 ? Cause{CauseKind::velocity_filter} : Cause{CauseKind::ramp_down};
}

double WardMotion::arc_gain(std::size_t block) const {
  const double rate = pulses_.limits[block].value / pulses_.train.arc(block).length_per_radian();
  return turn_gain(pulses_.train.filters, rate * pulses_.train.filter_time / 2);
}

}  // namespace feedscope
