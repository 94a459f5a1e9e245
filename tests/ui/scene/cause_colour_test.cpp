#include "ui/scene/cause_colour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/cielab.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {
namespace {

using test::ColourTriple;
using Matrix = std::array<ColourTriple, 3>;

/// What is left of linear light without one kind of cones: Machado, Oliveira and Fernandes 2009, severity 1.
constexpr std::array<Matrix, 4> visions{
    Matrix{ColourTriple{1, 0, 0}, ColourTriple{0, 1, 0}, ColourTriple{0, 0, 1}},
    Matrix{ColourTriple{0.152286, 1.052583, -0.204868}, ColourTriple{0.114503, 0.786281, 0.099216},
           ColourTriple{-0.003882, -0.048116, 1.051998}},
    Matrix{ColourTriple{0.367322, 0.860646, -0.227968}, ColourTriple{0.280085, 0.672501, 0.047413},
           ColourTriple{-0.011820, 0.042940, 0.968881}},
    Matrix{ColourTriple{1.255528, -0.076749, -0.178779}, ColourTriple{-0.078411, 0.930809, 0.147602},
           ColourTriple{0.004733, 0.691367, 0.303900}}};

ColourTriple seen(const Rgb& colour, const Matrix& vision) {
  const ColourTriple light = test::to_linear(colour);
  ColourTriple left;
  std::ranges::transform(vision, left.begin(), [&](const ColourTriple& row) {
    return std::clamp(row[0] * light[0] + row[1] * light[1] + row[2] * light[2], 0.0, 1.0);
  });
  return test::to_lab(left);
}

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
  for (const Matrix& vision : visions) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(test::lab_distance(seen(cause_colour(kinds[i], GetParam()), vision),
                                     seen(cause_colour(kinds[j], GetParam()), vision)),
                  15)
            << cause_title({kinds[i], -1}) << " and " << cause_title({kinds[j], -1});
      }
    }
  }
}

TEST_P(CauseColour, StandsOutFromTheBackground) {
  const ColourTriple background = seen(scene_colours(GetParam()).background, visions[0]);
  for (const CauseKind kind : all_kinds()) {
    const ColourTriple colour = seen(cause_colour(kind, GetParam()), visions[0]);
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
