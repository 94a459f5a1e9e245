#include <cmath>

#include "core/analysis/explanation/reason_finder.h"
#include "core/blend/junction.h"
#include "core/blend/path_rules.h"
#include "core/models/ward/corner_pulse.h"
#include "core/trajectory/filtered_corner.h"

namespace feedscope {

/// The pulses are limited, and the filters draw them out: on settled stretches the pulse of the block counts.
Reason ReasonFinder::filtered(const State& state, Cause cause) const {
  const FilteredMotion& motion = run_.motion_of(state.element);
  const PulseTrain& train = motion.train();
  const std::size_t block = run_.path().segment(state.element) - train.first;
  switch (cause.kind) {
    case CauseKind::velocity_filter:
    case CauseKind::ramp_down:
      return made(cause,
                  {FormulaId::filter_delay,
                   {{Symbol::filters, -1, static_cast<double>(train.filters)},
                    {Symbol::filter_time, -1, train.filter_time}}},
                  motion.delay(), state.element);
    case CauseKind::contour_tolerance: {
      const PathRules rules(*run_.path().programmed(), settings_);
      const double tolerance = rules.tolerance(train.first + block);
      return made(cause, filtered_corner(motion, block, state.time - motion.start()), tolerance,
                  state.element);
    }
    default:
      return made(cause, limits_.speed(cause, state.element), train.blocks[block].feed, state.element);
  }
}

/// Contour error of an arc, or of the corner of `block` that lies nearest in time.
Formula ReasonFinder::filtered_corner(const FilteredMotion& motion, std::size_t block, double time) const {
  const PulseTrain& train = motion.train();
  const double feed = train.blocks[block].feed;
  if (train.segment(block).kind == SegmentKind::arc) {
    const double rate = feed / train.arc(block).length_per_radian();
    return {FormulaId::arc_error,
            {{Symbol::radius, -1, train.arc(block).radius},
             {Symbol::filter_angle, -1, rate * train.filter_time / 2},
             {Symbol::filters, -1, static_cast<double>(train.filters)}}};
  }
  const auto is_corner = [&](std::size_t corner) {
    return corner > 0 && corner < train.size() && corner_turn(train, corner) > straight_angle;
  };
  const auto distance = [&](std::size_t corner) {
    return std::abs(train.blocks[corner].start + train.half_delay() - time);
  };
  const bool later = is_corner(block + 1) && (!is_corner(block) || distance(block + 1) < distance(block));
  const std::size_t corner = later ? block + 1 : block;
  if (!is_corner(corner)) {
    return {};
  }
  const double speed = train.blocks[corner].corner_speed;
  const auto leg = [&](std::size_t side) {
    const double pulse = train.blocks[side].feed;
    return pulse * train.filter_time * corner_distance(train.filters, std::min(speed / pulse, 1.0));
  };
  return {FormulaId::corner_error,
          {{Symbol::leg_before, -1, leg(corner - 1)},
           {Symbol::leg_after, -1, leg(corner)},
           {Symbol::turn, -1, corner_turn(train, corner)}}};
}

}  // namespace feedscope
