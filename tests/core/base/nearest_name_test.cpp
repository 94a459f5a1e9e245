#include "core/base/nearest_name.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(NearestName, FindsSlipsAndBeginnings) {
  const std::vector<std::string> ids{"spinner-mvc850", "mikron-ucp710", "huron-kx10", "hermle-c800u"};
  EXPECT_EQ(nearest_name("spinner-mvc580", ids), "spinner-mvc850");
  EXPECT_EQ(nearest_name("spiner", ids), "spinner-mvc850");
  EXPECT_EQ(nearest_name("HURON", ids), "huron-kx10");
  EXPECT_EQ(nearest_name("jrek", {"velocity", "acceleration", "jerk"}), "jerk")
      << "two swapped letters are one slip";
  EXPECT_EQ(nearest_name("jxek", {"velocity", "acceleration", "jerk"}), "");
  EXPECT_EQ(nearest_name("jerc", {"velocity", "acceleration", "jerk"}), "jerk");
}

TEST(NearestName, IsNoBeginningWithAnotherFirstLetter) {
  EXPECT_EQ(nearest_name("foo", {"lookahead_blocks", "filters"}), "");
  EXPECT_EQ(nearest_name("lok", {"lookahead_blocks", "filters"}), "lookahead_blocks");
}

TEST(NearestName, PrefersTheWholeNameAmongEqualBeginnings) {
  EXPECT_EQ(nearest_name("jerk", {"jerk_on_blends", "jerk"}), "jerk");
}

TEST(NearestName, GivesNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("zzzzzz", {"velocity", "jerk"}), "");
  EXPECT_EQ(nearest_name("U", {"X", "Y", "Z"}), "");
  EXPECT_EQ(nearest_name("", {"velocity", "jerk"}), "");
  EXPECT_EQ(nearest_name("velocity", {}), "");
}

}  // namespace
}  // namespace feedscope
