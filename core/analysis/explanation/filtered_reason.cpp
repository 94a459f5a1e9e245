#include "core/analysis/explanation/filtered_reason.h"

#include <cmath>
#include <utility>

#include "core/analysis/explanation/reason_source.h"
#include "core/blend/junction.h"
#include "core/blend/path_rules.h"
#include "core/models/ward/corner_pulse.h"
#include "core/trajectory/filtered_corner.h"

namespace feedscope {
namespace {

/// Contour error of an arc, or of the corner of `block` nearest in time.
Formula filtered_corner(const FilteredMotion& motion, std::size_t block, double time) {
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

}  // namespace

Reason filtered_reason(const Trajectory& run, const Settings& settings, const ElementLimits& limits,
                       const State& state, Cause cause) {
  const auto made = [&](Formula formula, double reached) {
    return made_reason(run, limits, cause, std::move(formula), reached, state.element);
  };
  const FilteredMotion& motion = run.motion_of(state.element);
  const PulseTrain& train = motion.train();
  const std::size_t block = run.path().base_segment_of(state.element) - train.first;
  switch (cause.kind) {
    case CauseKind::velocity_filter:
    case CauseKind::ramp_down:
      return made({FormulaId::filter_delay,
                   {{Symbol::filters, -1, static_cast<double>(train.filters)},
                    {Symbol::filter_time, -1, train.filter_time}}},
                  motion.delay());
    case CauseKind::contour_tolerance: {
      const PathRules rules(*run.path().programmed(), settings);
      const double tolerance = rules.tolerance(run.path().segment(state.element));
      return made(filtered_corner(motion, block, state.time - motion.start()), tolerance);
    }
    default:
      return made(limits.speed(cause, state.element), train.blocks[block].feed);
  }
}

}  // namespace feedscope
