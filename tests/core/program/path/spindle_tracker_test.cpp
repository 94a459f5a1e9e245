#include "core/program/path/spindle_tracker.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(SpindleTracker, GivesEqualStatesOneIndex) {
  std::vector<SpindleState> states;
  DiagnosticLog log;
  SpindleTracker spindle(states, log);
  EXPECT_EQ(spindle.index(0, {}), 0);
  EXPECT_EQ(spindle.index(100, {}), 1);
  spindle.set_tool(2);
  EXPECT_EQ(spindle.index(100, {}), 2);
  spindle.set_stands(true);
  EXPECT_EQ(spindle.index(100, {}), 3);
  spindle.set_stands(false);
  EXPECT_EQ(spindle.index(100, {}), 2);
  spindle.set_surface_speed(true);
  EXPECT_EQ(spindle.index(100, {}), 4);
  ASSERT_EQ(states.size(), 5U);
  EXPECT_EQ(states[2], (SpindleState{2, 100, SpindleState::Turning::as_said}));
  EXPECT_EQ(states[3].turning, SpindleState::Turning::stands);
  EXPECT_EQ(states[4].turning, SpindleState::Turning::surface_speed);
}

TEST(SpindleTracker, KnowsNothingOfMoreStatesThanMotionsCanPointTo) {
  std::vector<SpindleState> states;
  DiagnosticLog log;
  SpindleTracker spindle(states, log);
  for (int i = 1; i <= 65535; ++i) {
    ASSERT_EQ(spindle.index(i, {}), i);
  }
  EXPECT_EQ(spindle.index(70000, {7, 1}), 0);
  EXPECT_EQ(spindle.index(5, {8, 1}), 5);
  const auto diagnostics = log.take();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].code, "spindle-speeds");
  EXPECT_EQ(diagnostics[0].line, 7U);
}

}  // namespace
}  // namespace feedscope
