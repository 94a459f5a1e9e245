#include "core/analysis/contour/programmed_place.h"

#include <gtest/gtest.h>

#include "core/analysis/run/run.h"

namespace feedscope {
namespace {

constexpr const char* corners =
    "G1 F6000 X50\nY50\nG2 X100 Y0 I50 J0\nG4 P0.5\nG1 X150\nY0.5\nX200 Z10\nG0 X0\n";

LoadedProgram read(const char* text) {
  return load_program(std::make_shared<const SourceText>("corners.nc", text));
}

Run run_with(const LoadedProgram& program, const std::string& model, double tolerance) {
  return simulate_run(program,
                      make_setup({.machine = {}, .model = model, .tolerance = tolerance, .assignments = {}}));
}

TEST(ProgrammedPlace, FindsTheTimeThatItCameFrom) {
  const LoadedProgram program = read(corners);
  for (const ControlModel* model : all_models()) {
    const feedscope::Run run = run_with(program, model->info().id, 0.02);
    const Trajectory& trajectory = *run.trajectory;
    for (int i = 0; i <= 400; ++i) {
      const State at = trajectory.state(trajectory.duration() * i / 400);
      const double time = time_of(trajectory, programmed_place(trajectory, at.time));
      EXPECT_NEAR(trajectory.state(time).path_length, at.path_length, 1e-6) << model->info().id << ' ' << i;
      EXPECT_LE(time, at.time + 1e-6);  // the first instant: a place is held during a dwell or a stop
    }
  }
}

TEST(ProgrammedPlace, StaysWithinABlendUnderAnotherTolerance) {
  const LoadedProgram program = read(corners);
  const feedscope::Run narrow = run_with(program, "essid", 0.005);
  const feedscope::Run wide = run_with(program, "essid", 0.1);
  double longest = 0;
  for (std::size_t i = 0; i < wide.trajectory->blend_count(); ++i) {
    longest = std::max(longest, wide.trajectory->blend(i).length);
  }
  for (int i = 0; i <= 100; ++i) {
    const State at = narrow.trajectory->state(narrow.trajectory->duration() * i / 100);
    const double time = time_of(*wide.trajectory, programmed_place(*narrow.trajectory, at.time));
    EXPECT_LT((wide.trajectory->state(time).position - at.position).norm(), longest) << i;
  }
}

/// A corner belongs to both of its segments, so that the middle of a wide one is that of a narrow one.
TEST(ProgrammedPlace, TheMiddleOfACornerIsTheSameUnderEveryTolerance) {
  const LoadedProgram program = read("G1 F6000 X50\nY50\nX100\nY0\n");
  for (const double tolerance : {0.005, 0.1, 0.3}) {
    const feedscope::Run run = run_with(program, "essid", tolerance);
    for (std::uint32_t segment = 1; segment < 4; ++segment) {
      const Vec3 corner = program.toolpath->start_of(segment);
      const Vec3 bisector = (program.toolpath->start_of(segment - 1) - corner).normalized() +
                            (program.toolpath->segments[segment].end - corner).normalized();
      const double time = time_of(*run.trajectory, {segment, 0});
      const Vec3 middle = run.trajectory->state(time).position - corner;
      EXPECT_GT(middle.norm(), 0.5 * tolerance);
      EXPECT_NEAR(middle.normalized().dot(bisector.normalized()), 1, 1e-6) << segment << ", " << tolerance;
      EXPECT_NEAR(time, time_of(*run.trajectory, {segment - 1, 1}), 1e-9);
    }
  }
}

TEST(ProgrammedPlace, OfNothingIsTheBeginning) {
  EXPECT_EQ(programmed_place(Trajectory(), 3), ProgrammedPlace{});
  EXPECT_EQ(time_of(Trajectory(), {7, 0.5}), 0);
}

TEST(ProgrammedPlace, BeyondTheProgramIsItsEnd) {
  const feedscope::Run run = run_with(read(corners), "cam", 0.01);
  EXPECT_DOUBLE_EQ(time_of(*run.trajectory, {1000, 0.5}), run.trajectory->duration());
}

}  // namespace
}  // namespace feedscope
