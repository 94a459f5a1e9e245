#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/toolpath/toolpath.h"
#include "tests/support/parts.h"

/// What must hold of the motion of any planned model, on any path.
namespace feedscope::testing {

inline void expect_no_gaps_between_pieces(const Trajectory& run) {
  const std::vector<Part> parts = testing::parts_of(run);
  for (std::size_t p = 0; p + 1 < parts.size(); ++p) {
    const State end = testing::state_in(run, parts[p], parts[p].duration);
    const State next = testing::state_in(run, parts[p + 1], 0);
    ASSERT_LT((end.position - next.position).norm(), 1e-7) << "part at " << parts[p].time;
    ASSERT_NEAR(end.speed, next.speed, 1e-6 * (1 + end.speed)) << "part at " << parts[p].time;
    ASSERT_TRUE(std::isfinite(end.speed));
  }
}

inline void expect_rest_at_the_programmed_ends(const Toolpath& path, const Trajectory& run) {
  ASSERT_LT((run.state(0).position - path.start).norm(), 1e-9);
  const State end = run.state(run.duration());
  ASSERT_LT((end.position - path.segments.back().end).norm(), 1e-6);
  ASSERT_LT(end.speed, 1e-3);
}

}  // namespace feedscope::testing
