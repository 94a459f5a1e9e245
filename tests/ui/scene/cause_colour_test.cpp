#include "ui/scene/cause_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/cielab.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {
namespace {

std::vector<CauseKind> all_kinds() {
  std::vector<CauseKind> kinds;
  for (const Cause& cause : all_causes()) {
    if (cause.axis < 0) {
      kinds.push_back(cause.kind);
    }
  }
  return kinds;
}

class CauseColour : public testing::TestWithParam<Background> {};

TEST_P(CauseColour, AnyTwoAreToldApartWithEveryKindOfColourVision) {
  const std::vector<CauseKind> kinds = all_kinds();
  for (const test::ColourVision& vision : test::colour_visions) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(test::lab_distance(test::seen_lab(cause_colour(kinds[i], GetParam()), vision),
                                     test::seen_lab(cause_colour(kinds[j], GetParam()), vision)),
                  15)
            << cause_title({kinds[i], -1}) << " and " << cause_title({kinds[j], -1});
      }
    }
  }
}

TEST_P(CauseColour, StandsOutFromTheBackground) {
  const auto background = test::seen_lab(scene_colours(GetParam()).background, test::colour_visions[0]);
  for (const CauseKind kind : all_kinds()) {
    const auto colour = test::seen_lab(cause_colour(kind, GetParam()), test::colour_visions[0]);
    EXPECT_GE(test::lab_distance(colour, background), 15) << cause_title({kind, -1});
    if (GetParam() == Background::dark) {
      EXPECT_GE(colour[0] - background[0], 25) << cause_title({kind, -1});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(LightAndDark, CauseColour, testing::Values(Background::light, Background::dark));

TEST(CauseKindTitle, IsOneOfItsOwnForEveryKind) {
  std::set<std::string> titles;
  for (const CauseKind kind : all_kinds()) {
    titles.insert(cause_title({kind, -1}));
  }
  EXPECT_EQ(titles.size(), all_kinds().size());
  EXPECT_EQ(cause_title({CauseKind::axis_jerk, -1}), "axis jerk");
  EXPECT_EQ(cause_title({CauseKind::blend_radial_jerk, -1}), "radial jerk on a blend");
}

}  // namespace
}  // namespace feedscope::ui
