#include "core/analysis/load/load_sampler.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double at_rest = 1e-9;                      // [mm/s]; below, the direction of the segment is used
constexpr double least_across = 0.70710678118654752;  // of a motion at 45 degrees

}  // namespace

LoadSampler::Segment LoadSampler::segment_of(std::uint32_t element, std::uint32_t index) const {
  const feedscope::Segment& segment = trajectory_.path().programmed()->segments[index];
  Segment found{index, LoadState::cutting, -1, 0};
  if (trajectory_.path().kind(element) == ElementKind::dwell || segment.kind == SegmentKind::dwell) {
    found.state = LoadState::dwell;
  } else if (segment.rapid) {
    found.state = LoadState::rapid;
  } else if (found.operation = model_.operation_of(segment.spindle, segment.line); found.operation < 0) {
    found.state = LoadState::no_operation;
  } else if (found.spindle_speed = model_.speed_of(found.operation, segment.spindle);
             !(found.spindle_speed > 0)) {
    found.state = LoadState::no_spindle;
  }
  return found;
}

/// Share of the feed across the tool's axis.
double LoadSampler::share_across(const State& state, std::uint32_t segment) const {
  const Vec3 direction = state.speed > at_rest ? Vec3(state.velocity / state.speed)
                                               : trajectory_.path().programmed()->tangent_at_start(segment);
  return direction.head<2>().norm();
}

CuttingLoad LoadSampler::load_at(double feed) const {
  const LoadedOperation& operation = model_.operations()[static_cast<std::size_t>(segment_.operation)];
  CuttingLoad load;
  load.feed_per_tooth = feed / (segment_.spindle_speed * operation.operation.teeth);
  load.chip_thickness = operation.force.largest_chip(load.feed_per_tooth);
  const CuttingForce::Figures figures = operation.force.at(load.feed_per_tooth);
  load.mean_force = figures.mean.head<2>().norm();
  load.peak_force = figures.peak;
  load.torque = figures.torque;
  load.power = figures.torque * 2 * units::pi * segment_.spindle_speed;
  return load;
}

/// As load_at(), cached: on most segments it is constant.
CuttingLoad LoadSampler::programmed_load_at(double feed) {
  if (feed != programmed_feed_) {
    programmed_ = load_at(feed);
    programmed_feed_ = feed;
  }
  return programmed_;
}

LoadSample LoadSampler::at(const State& state) {
  const std::uint32_t index = trajectory_.path().segment(state.element);
  if (!has_segment_ || segment_.index != index) {
    segment_ = segment_of(state.element, index);
    programmed_feed_ = -1;
    has_segment_ = true;
  }
  LoadSample sample;
  sample.state = segment_.state;
  sample.operation = segment_.operation;
  if (segment_.state != LoadState::cutting) {
    return sample;
  }
  const double across = share_across(state, index);
  if (across < least_across) {
    sample.state = LoadState::plunge;
    return sample;
  }
  sample.predicted = load_at(std::max(0.0, state.speed) * across);  // rounding at standstill
  sample.programmed = programmed_load_at(state.programmed_feed * across);
  return sample;
}

}  // namespace feedscope
