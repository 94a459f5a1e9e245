#include "core/identification/telling_parts.h"

#include <gmock/gmock.h>

namespace feedscope {
namespace {

using testing::ElementsAre;

std::vector<std::string> parts_of(const std::string& machine, const std::vector<std::string>& keys) {
  SetupRequest request;
  request.machine = machine;
  const auto setup = make_setup(request);
  return telling_parts(setup, fit_parameters_of(setup, keys));
}

TEST(TellingParts, AreThoseThatAnAxisOrACornerSlowsDown) {
  EXPECT_THAT(
      parts_of("linuxcnc-mill", {"X.acceleration", "Y.acceleration", "Z.velocity", "blend_tolerance_mm"}),
      ElementsAre("SINGLE MOVES OF X", "SINGLE MOVES OF Y", "SINGLE MOVES OF Z",
                  "CORNERS OF 10 TO 170 DEGREES"));
}

TEST(TellingParts, AreNoneForANumberThatTheModelDoesNotUse) {
  EXPECT_THAT(parts_of("linuxcnc-mill", {"X.jerk"}), ElementsAre(""));
  EXPECT_THAT(parts_of("spinner-mvc850", {"X.jerk"}), ElementsAre("SINGLE MOVES OF X"));
}

}  // namespace
}  // namespace feedscope
