#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

/// Of the last motion.
PathControl control_of(const std::string& text) {
  const ReadProgram program = read_clean(text);
  return program.path_controls.at(program.motions.back().path_control);
}

/// A PathControl of which only what differs need be named.
struct Expected {
  PathMode mode = PathMode::machine;
  ExactStopWindow exact_stop_window = ExactStopWindow::machine;
  std::optional<double> contour_tolerance = std::nullopt;
  std::optional<double> blend_distance = std::nullopt;
  std::optional<double> orientation_tolerance = std::nullopt;
  Switch compaction = Switch::machine;
  AccelerationMode acceleration = AccelerationMode::machine;
  Switch feed_forward = Switch::machine;

  PathControl control() const {
    PathControl all;
    all.mode = mode;
    all.exact_stop_window = exact_stop_window;
    all.contour_tolerance = contour_tolerance;
    all.blend_distance = blend_distance;
    all.orientation_tolerance = orientation_tolerance;
    all.compaction = all.compressor = compaction;
    all.acceleration = acceleration;
    all.feed_forward = feed_forward;
    return all;
  }
};

constexpr double degree = std::numbers::pi / 180;

struct ControlCase {
  const char* words;
  Expected control;
};

void PrintTo(const ControlCase& c, std::ostream* out) {
  *out << c.words;
}

class SinumerikPathControl : public testing::TestWithParam<ControlCase> {};

TEST_P(SinumerikPathControl, MotionHasWhatTheWordsSet) {
  EXPECT_EQ(control_of(std::string(GetParam().words) + "\nG1 X1 F100"), GetParam().control.control());
}

INSTANTIATE_TEST_SUITE_P(
    Words, SinumerikPathControl,
    testing::Values(
        ControlCase{"", {}}, ControlCase{"G60", {.mode = PathMode::exact_stop}},
        ControlCase{"G60 G601", {.mode = PathMode::exact_stop, .exact_stop_window = ExactStopWindow::fine}},
        ControlCase{"G602\nG60",
                    {.mode = PathMode::exact_stop, .exact_stop_window = ExactStopWindow::coarse}},
        ControlCase{"G60 G603",
                    {.mode = PathMode::exact_stop, .exact_stop_window = ExactStopWindow::interpolation_end}},
        ControlCase{"G60 G603\nG64", {.mode = PathMode::continuous}},
        ControlCase{"G64", {.mode = PathMode::continuous}},
        ControlCase{"G64 CTOL=0.01", {.mode = PathMode::continuous}},
        ControlCase{"G641 ADIS=0.5 ADISPOS=2", {.mode = PathMode::continuous, .blend_distance = 0.5}},
        ControlCase{"G641", {.mode = PathMode::continuous, .blend_distance = 0}},
        ControlCase{"G642 CTOL=0.02", {.mode = PathMode::continuous, .contour_tolerance = 0.02}},
        ControlCase{"G643 CTOL=0.02", {.mode = PathMode::continuous, .contour_tolerance = 0.02}},
        ControlCase{"G644 CTOL=0.02", {.mode = PathMode::continuous}},
        ControlCase{"G645 CTOL=0.02\nCTOL=-1", {.mode = PathMode::continuous}},
        ControlCase{"G70 G642 CTOL=0.001", {.mode = PathMode::continuous, .contour_tolerance = 0.0254}},
        ControlCase{"CTOL=0.02", {.contour_tolerance = 0.02}},
        ControlCase{"G642 OTOL=0.5", {.mode = PathMode::continuous, .orientation_tolerance = 0.5 * degree}},
        ControlCase{"COMPCAD CTOL=0.01", {.contour_tolerance = 0.01, .compaction = Switch::on}},
        ControlCase{"COMPCURV", {.compaction = Switch::on}},
        ControlCase{"COMPON", {.compaction = Switch::on}},
        ControlCase{"COMPCAD\nCOMPOF", {.compaction = Switch::off}},
        ControlCase{"SOFT", {.acceleration = AccelerationMode::soft}},
        ControlCase{"BRISK FFWON", {.acceleration = AccelerationMode::brisk, .feed_forward = Switch::on}},
        ControlCase{"DRIVE FFWOF", {.acceleration = AccelerationMode::drive, .feed_forward = Switch::off}}));

constexpr Expected high_speed{
    .mode = PathMode::continuous, .contour_tolerance = 0.05, .compaction = Switch::on};

INSTANTIATE_TEST_SUITE_P(
    Cycle832, SinumerikPathControl,
    testing::Values(ControlCase{"CYCLE832(0.05,3)", high_speed},
                    ControlCase{"CYCLE832(0.05,_ROUGH,1)", high_speed},
                    ControlCase{"CYCLE832(0.05,1,1)", high_speed},
                    ControlCase{"CYCLE832(0.05,2000003,1)", high_speed},
                    ControlCase{"CYCLE832(0.05,_ORI_FINISH,0.4)",
                                {.mode = PathMode::continuous,
                                 .contour_tolerance = 0.05,
                                 .orientation_tolerance = 0.4 * degree,
                                 .compaction = Switch::on}},
                    ControlCase{"CYCLE832(0.05,112101)",
                                {.mode = PathMode::continuous,
                                 .contour_tolerance = 0.05,
                                 .compaction = Switch::on,
                                 .acceleration = AccelerationMode::soft,
                                 .feed_forward = Switch::on}},
                    ControlCase{"CYCLE832(0.05,20001)",
                                {.mode = PathMode::continuous,
                                 .compaction = Switch::off,
                                 .acceleration = AccelerationMode::brisk,
                                 .feed_forward = Switch::off}},
                    ControlCase{"CYCLE832(0.05,3)\nCYCLE832(0,0,1)",
                                {.mode = PathMode::continuous, .compaction = Switch::off}},
                    ControlCase{"CYCLE832(0.05,3)\nCYCLE832()",
                                {.mode = PathMode::continuous, .compaction = Switch::off}}));

TEST(SinumerikPathControl, RapidsHaveTheirOwnDistance) {
  const ReadProgram program = read_clean("G641 ADIS=0.5 ADISPOS=2\nG0 X1\nG1 X2 F100\nG0 X3");
  ASSERT_EQ(program.motions.size(), 3U);
  const auto distance = [&](std::size_t i) {
    return program.path_controls.at(program.motions[i].path_control).blend_distance;
  };
  EXPECT_EQ(distance(0), 2);
  EXPECT_EQ(distance(1), 0.5);
  EXPECT_EQ(distance(2), 2);
  EXPECT_EQ(program.path_controls.size(), 3U);
}

TEST(SinumerikPathControl, ExactStopOfOneBlockIsOver) {
  const ReadProgram program = read_clean("G64 G602 G1 X1 F100\nG9 X2\nX3");
  ASSERT_EQ(program.motions.size(), 3U);
  const PathControl& stop = program.path_controls.at(program.motions[1].path_control);
  EXPECT_EQ(stop.mode, PathMode::exact_stop);
  EXPECT_EQ(describe(stop), "exact stops (coarse)");
  EXPECT_EQ(program.motions[0].path_control, program.motions[2].path_control);
}

}  // namespace
}  // namespace feedscope
