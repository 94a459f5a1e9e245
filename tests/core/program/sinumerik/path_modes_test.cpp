#include "core/program/sinumerik/geometry/path_modes.h"

#include <gtest/gtest.h>

#include "core/program/text/read_fault.h"
#include "tests/core/program/sinumerik/part_bench.h"

namespace feedscope::sinumerik {
namespace {

struct SinumerikPathModes : testing::Test {
  bool run(std::string_view name, std::string_view rest) {
    Scanner scanner(rest);
    return modes.run(scanner, name, 1);
  }
  const PathControl& control(bool rapid) {
    modes.use(rapid);
    return bench.path.path_control();
  }

  PartBench bench;
  PathModes modes{bench.context, bench.values};
};

TEST_F(SinumerikPathModes, GiveRapidsADistanceOfTheirOwn) {
  modes.apply("G641");
  EXPECT_TRUE(run("ADIS", "=0.5"));
  EXPECT_TRUE(run("ADISPOS", "=2"));
  EXPECT_EQ(control(false).blend_distance, 0.5);
  EXPECT_EQ(control(true).blend_distance, 2);
  EXPECT_EQ(control(false).blend_distance, 0.5);
}

TEST_F(SinumerikPathModes, StopExactlyForOneBlockByG9) {
  modes.apply("G64");
  bench.context.functions.exact_stop = true;
  EXPECT_EQ(control(false).mode, PathMode::exact_stop);
  bench.clear();
  EXPECT_EQ(control(false).mode, PathMode::continuous);
}

TEST_F(SinumerikPathModes, TakeTolerancesInTheUnitOfLengths) {
  modes.apply("G642");
  bench.context.modal.inch = true;
  EXPECT_TRUE(run("CTOL", "=0.001"));
  EXPECT_NEAR(control(false).contour_tolerance.value_or(0), 0.0254, 1e-12);
}

TEST_F(SinumerikPathModes, RefuseNegativeDistancesAndOtherNames) {
  EXPECT_THROW(run("ADIS", "=-1"), ReadFault);
  EXPECT_FALSE(run("RNDM", "=1"));
}

TEST_F(SinumerikPathModes, RestoreWordsThatTheNextMotionHas) {
  modes.apply("G60");
  const PathWords words = modes.words();
  modes.apply("G64");
  EXPECT_EQ(control(false).mode, PathMode::continuous);
  modes.restore(words);
  EXPECT_EQ(control(false).mode, PathMode::exact_stop);
}

}  // namespace
}  // namespace feedscope::sinumerik
