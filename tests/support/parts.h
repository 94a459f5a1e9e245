#pragma once

#include <vector>

#include "core/trajectory/part_walk.h"

/// The whole of what a trajectory computes on demand, for tests that look at all of it.
namespace feedscope::testing {

inline std::vector<Part> parts_of(const Trajectory& run) {
  std::vector<Part> parts;
  for (PartWalk walk(run); !walk.done(); walk.next()) {
    parts.push_back(walk.part());
  }
  return parts;
}

inline State state_in(const Trajectory& run, const Part& part, double tau) {
  return PartMotion(run, part).state(tau);
}

inline std::vector<BlendRecord> blends_of(const Trajectory& run) {
  std::vector<BlendRecord> blends;
  for (std::size_t i = 0; i < run.blend_count(); ++i) {
    blends.push_back(run.blend(i));
  }
  return blends;
}

}  // namespace feedscope::testing
