#include "core/program/sinumerik/geometry/coordinates.h"

#include <gtest/gtest.h>

#include "tests/core/program/sinumerik/part_bench.h"

namespace feedscope::sinumerik {
namespace {

struct SinumerikCoordinates : testing::Test {
  /// A frame function with the words that the block holds, which then ends.
  void run(Action action) {
    const Function function{"FRAME", Group::own_block, action};
    bench.context.functions.own_block = &function;
    bench.context.functions.own_column = 7;
    coordinates.run();
    bench.clear();
  }
  /// Where X1 Y0 Z0 is shown.
  Vec3 shown() const { return bench.path.frame().to_shown(Vec3::UnitX()); }
  void expect_shown(const Vec3& expected) const {
    EXPECT_LT((shown() - expected).norm(), 1e-12)
        << shown().transpose() << " instead of " << expected.transpose();
  }

  PartBench bench;
  LastMotion last;
  Targets targets{bench.context};
  Splines splines{bench.context, targets, last};
  Coordinates coordinates{bench.context, targets, splines};
};

TEST_F(SinumerikCoordinates, ReplaceByTransAndAddByAtrans) {
  bench.set('X', 10);
  run(Action::shift);
  bench.set('Y', 5);
  run(Action::shift_more);
  expect_shown({11, 5, 0});
  bench.set('Z', 1);
  run(Action::shift);
  expect_shown({1, 0, 1});
}

TEST_F(SinumerikCoordinates, TurnInThePlaneByRpl) {
  bench.set(Address::rpl, 90);
  run(Action::turn);
  expect_shown({0, 1, 0});
  bench.context.modal.plane = Plane::zx;
  bench.set(Address::rpl, 90);
  run(Action::turn);
  expect_shown({0, 0, -1});
}

TEST_F(SinumerikCoordinates, ScaleByOneInsteadOfZero) {
  bench.set('X', 0);
  run(Action::scale);
  expect_shown({1, 0, 0});
  EXPECT_EQ(bench.log.take().at(0).code, "scale-factor");
}

TEST_F(SinumerikCoordinates, UseASettableFrameOnceItsWordIsProgrammed) {
  FrameValue value;
  value.set(FrameValue::Part::shift, 1, 20);
  coordinates.set_settable(2, value);
  expect_shown({1, 0, 0});
  coordinates.select_work_offset(55, 1);
  expect_shown({1, 20, 0});
  coordinates.select_work_offset(500, 1);
  expect_shown({1, 0, 0});
}

TEST_F(SinumerikCoordinates, TakeFramesBackThatAreOutOfRange) {
  for (int i = 0; i < 2; ++i) {
    bench.set('X', 1e6);
    run(Action::scale_more);
  }
  expect_shown({1, 0, 0});
  const std::vector<Diagnostic> diagnostics = bench.log.take();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].code, "frame-range");
  EXPECT_EQ(diagnostics[0].column, 7U);
}

TEST_F(SinumerikCoordinates, RestoreWhatWasInForce) {
  bench.set('X', 10);
  run(Action::shift);
  const Coordinates::Modes modes = coordinates.modes();
  bench.set('X', -5);
  run(Action::shift_more);
  coordinates.restore(modes);
  expect_shown({11, 0, 0});
}

}  // namespace
}  // namespace feedscope::sinumerik
