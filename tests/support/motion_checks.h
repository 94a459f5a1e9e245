#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/machine/machine.h"
#include "core/toolpath/toolpath.h"
#include "core/trajectory/trajectory.h"

/// What must hold of the motion of any planned model, on any path.
namespace feedscope::testing {

inline void expect_no_gaps_between_pieces(const Trajectory& run) {
  for (std::size_t p = 0; p + 1 < run.pieces().size(); ++p) {
    const State end = run.state_in_piece(p, run.piece_end(p) - run.pieces()[p].time);
    const State next = run.state_in_piece(p + 1, 0);
    ASSERT_LT((end.position - next.position).norm(), 1e-7) << "piece " << p;
    ASSERT_NEAR(end.speed, next.speed, 1e-6 * (1 + end.speed)) << "piece " << p;
    ASSERT_TRUE(std::isfinite(end.speed));
  }
}

inline void expect_rest_at_the_programmed_ends(const Toolpath& path, const Trajectory& run) {
  ASSERT_LT((run.state(0).position - path.start).norm(), 1e-9);
  const State end = run.state(run.duration());
  ASSERT_LT((end.position - path.segments.back().end).norm(), 1e-6);
  ASSERT_LT(end.speed, 1e-3);
}

inline void expect_axis_limits_on_lines(const Trajectory& run, const Machine& machine) {
  for (std::size_t p = 0; p < run.pieces().size(); ++p) {
    for (const double share : {0.0, 1.0}) {
      const State state = run.state_in_piece(p, share * (run.piece_end(p) - run.pieces()[p].time));
      if (run.path().elements[state.element].kind != ElementKind::line) {
        continue;
      }
      for (int j = 0; j < 3; ++j) {
        const AxisLimits& axis = machine.axes[static_cast<std::size_t>(j)];
        ASSERT_LE(std::abs(state.acceleration[j]), axis.acceleration * (1 + 1e-6)) << "piece " << p;
        ASSERT_LE(std::abs(state.jerk[j]), axis.jerk * (1 + 1e-6)) << "piece " << p;
      }
    }
  }
}

}  // namespace feedscope::testing
