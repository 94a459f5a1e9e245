#pragma once

#include <cstdint>

#include "core/analysis/load/load_sample.h"
#include "core/analysis/load/run_load.h"

namespace feedscope {

/// Computes the load at any state of a run.
class LoadSampler {
 public:
  /// `load` must outlive this.
  explicit LoadSampler(const RunLoad& load) : model_(load.model()), trajectory_(load.trajectory()) {}

  /// `state`: of the trajectory. Constant time; cheapest for states in order of segments.
  LoadSample at(const State& state);

 private:
  /// Constant data of a segment.
  struct Segment {
    std::uint32_t index = 0;
    LoadState state = LoadState::dwell;
    int operation = -1;
    double spindle_speed = 0;  ///< [1/s]
  };

  CuttingLoad programmed_load_at(double feed);
  Segment segment_of(std::uint32_t element, std::uint32_t index) const;
  double share_across(const State& state, std::uint32_t segment) const;
  CuttingLoad load_at(double feed) const;

  const LoadModel& model_;
  const Trajectory& trajectory_;
  Segment segment_;
  double programmed_feed_ = -1;  ///< across the axis, for `programmed_`; below 0: none [mm/s]
  CuttingLoad programmed_;       ///< for the segment
  bool has_segment_ = false;
};

}  // namespace feedscope
