#include "core/base/diagnostic.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(Diagnostic, PrintsPlaceSeverityMessageCodeAndHint) {
  const Diagnostic d{Severity::error, 3, 7, "arc-radius", "radius is off", "check I and J"};
  EXPECT_EQ(format(d, "part.nc"), "part.nc:3:7: error: radius is off [arc-radius] (check I and J)");
}

TEST(Diagnostic, LeavesOutPlaceAndHintThatAreNotKnown) {
  EXPECT_EQ(format({Severity::warning, 0, 0, "empty", "no blocks", ""}, "part.nc"),
            "part.nc: warning: no blocks [empty]");
  EXPECT_EQ(format({Severity::info, 2, 0, "x", "y", ""}, "part.nc"), "part.nc:2: info: y [x]");
}

TEST(Diagnostic, OnlyErrorsCountAsErrors) {
  EXPECT_FALSE(has_errors({{Severity::warning, 1, 1, "a", "b", ""}, {Severity::info, 1, 1, "a", "b", ""}}));
  EXPECT_TRUE(has_errors({{Severity::info, 1, 1, "a", "b", ""}, {Severity::error, 1, 1, "a", "b", ""}}));
}

}  // namespace
}  // namespace feedscope
