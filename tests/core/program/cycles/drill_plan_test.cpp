#include "core/program/cycles/drill_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

struct AfterMachineMove {
  Dialect dialect;
  const char* program;
};

class HoleAfterMachineMove : public testing::TestWithParam<AfterMachineMove> {};

/// The tool was at Z10 before it went to a place that only the machine knows; from there the rapid to Z10 is
/// a motion, and the feed starts from it.
TEST_P(HoleAfterMachineMove, IsDrilledFromItsClearance) {
  const ReadProgram program = read_text(GetParam().program, ReadOptions{.dialect = GetParam().dialect});
  EXPECT_NEAR(program.cutting_bounds.min.z(), -5, 1e-9);
  EXPECT_NEAR(program.cutting_bounds.max.z(), 10, 1e-9);
  bool feeds = false;
  for (const MotionBlock& block : program.motions) {
    feeds = feeds || (block.motion == Motion::line && std::abs(block.target.z() + 5) < 1e-9);
  }
  EXPECT_TRUE(feeds);
}

INSTANTIATE_TEST_SUITE_P(
    Dialects, HoleAfterMachineMove,
    testing::Values(AfterMachineMove{Dialect::sinumerik,
                                     "G71 G90 G0 X0 Y0 Z10\nSUPA G0 Z0 D0\nG0 X20 Y0\nF200\n"
                                     "CYCLE81(10,0,10,-5,0)\nM30\n"},
                    AfterMachineMove{Dialect::fanuc,
                                     "G21 G90 G0 X0 Y0 Z10\nG28 Z0\nG0 X20\n"
                                     "G98 G81 X20 Z-5 R10 F200\nG80\nM30\n"},
                    AfterMachineMove{
                        Dialect::heidenhain,
                        "BEGIN PGM A MM\nL X0 Y0 Z10 FMAX\nCYCL DEF 200 DRILLING Q200=10 Q201=-5 "
                        "Q206=200 Q202=5 Q210=0 Q203=0 Q204=10 Q211=0\nL Z0 FMAX M91\n"
                        "L X20 Y0 FMAX M99\nEND PGM A MM\n"}));

}  // namespace
}  // namespace feedscope
