#include "core/load/material.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Materials, ThatAreShippedHaveSourceAndForce) {
  const std::vector<Material> all = shipped_materials();
  EXPECT_GE(all.size(), 6U);
  std::set<std::string> ids;
  for (const Material& material : all) {
    EXPECT_TRUE(ids.insert(material.id).second) << material.id;
    EXPECT_GT(material.source.size(), 20U) << material.id;
    EXPECT_NE(material.title, "") << material.id;
    // At h = 0.1 mm a tooth takes some hundred N per mm of width whatever it cuts.
    const ForceLaw law = force_law(material);
    const double force = law.chip[0] * std::pow(0.1, law.exponent) + law.edge[0];
    EXPECT_GT(force, 50) << material.id;
    EXPECT_LT(force, 1000) << material.id;
  }
}

TEST(Materials, OfOnesOwnStandBeforeThoseShipped) {
  Material own;
  own.id = "steel-c45";
  own.title = "mine";
  EXPECT_EQ(find_material("steel-c45", {own}).title, "mine");
  EXPECT_NE(find_material("steel-c45", {}).title, "mine");
}

TEST(Materials, ThatAreNotKnownAreRefusedWithTheNearest) {
  EXPECT_THAT([] { find_material("steel-c46", {}); },
              ThrowsMessage<InputError>(
                  HasSubstr("material 'steel-c46' is not known; did you mean 'steel-c45'?, or add")));
  EXPECT_THAT([] { find_material("\xe6\x9c\xa8", {}); },
              ThrowsMessage<InputError>(HasSubstr("[[material]]")));
}

TEST(ForceLaw, OfKienzleIsAPowerWithShares) {
  Material material;
  material.law = CuttingLaw::kienzle;
  material.specific_force = 2000;
  material.exponent = 0.25;
  material.share = {1, 0.3, 0.1};
  const ForceLaw law = force_law(material);
  EXPECT_EQ(law.exponent, 0.75);
  EXPECT_EQ(law.chip[0], 2000);
  EXPECT_EQ(law.chip[1], 600);
  EXPECT_EQ(law.chip[2], 200);
  EXPECT_EQ(law.edge[0], 0);
}

}  // namespace
}  // namespace feedscope
