#include "core/limits/cause.h"

#include <gtest/gtest.h>

#include <set>

namespace feedscope {
namespace {

TEST(Cause, HasAStableKeyWithItsAxis) {
  EXPECT_EQ(cause_key({CauseKind::programmed_feed, -1}), "programmed_feed");
  EXPECT_EQ(cause_key({CauseKind::axis_jerk, 0}), "axis_jerk_x");
  EXPECT_EQ(cause_key({CauseKind::blend_radial_acceleration, 2}), "blend_radial_acceleration_z");
  EXPECT_EQ(cause_key({CauseKind::axis_velocity, -1}), "axis_velocity");
  EXPECT_EQ(cause_key({CauseKind::axis_velocity, 3}), "axis_velocity_a");
  EXPECT_EQ(cause_key({CauseKind::indexing, 5}), "indexing_c");
  EXPECT_EQ(cause_key({CauseKind::swing, 1}), "swing_y");
}

TEST(Cause, HasATitleForPeople) {
  EXPECT_EQ(cause_title({CauseKind::programmed_feed, -1}), "programmed feed");
  EXPECT_EQ(cause_title({CauseKind::axis_jerk, 0}), "jerk of axis X");
  EXPECT_EQ(cause_title({CauseKind::indexing, 3}), "indexing of axis A");
  EXPECT_EQ(cause_title({CauseKind::blend_radial_jerk, 1}), "radial jerk of axis Y on a blend");
  EXPECT_EQ(cause_title({CauseKind::curvature_crossing, -1}), "jerk at a change of curvature");
}

TEST(Cause, IgnoresTheAxisOfAKindThatNoAxisSets) {
  EXPECT_EQ(cause_key({CauseKind::dwell, 1}), "dwell");
  EXPECT_EQ(cause_title({CauseKind::dwell, 1}), "dwell");
  EXPECT_EQ(cause_index({CauseKind::dwell, 1}), cause_index({CauseKind::dwell, -1}));
}

TEST(Cause, IndexIsThePositionInTheList) {
  for (std::size_t i = 0; i < all_causes().size(); ++i) {
    EXPECT_EQ(cause_index(all_causes()[i]), i) << cause_key(all_causes()[i]);
  }
}

TEST(Cause, EveryCauseIsListedOnceUnderItsOwnKeyAndTitle) {
  std::set<std::string> keys;
  std::set<std::string> titles;
  for (const Cause cause : all_causes()) {
    EXPECT_TRUE(keys.insert(cause_key(cause)).second) << cause_key(cause);
    EXPECT_TRUE(titles.insert(cause_title(cause)).second) << cause_title(cause);
  }
  EXPECT_EQ(cause_index({CauseKind::swing, 5}), all_causes().size() - 1);
}

}  // namespace
}  // namespace feedscope
