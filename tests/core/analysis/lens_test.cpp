#include "core/analysis/contour/lens.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/analysis/contour/path_deviation.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

LoadedProgram loaded(const std::string& text) {
  return load_program(std::make_shared<const SourceText>("lens.nc", text));
}

Run run_of(const LoadedProgram& program, const char* model, double tolerance,
           const char* machine = "spinner-mvc850") {
  return simulate_run(program, make_setup({machine, model, tolerance}));
}

Lens lens_of_line(const std::vector<feedscope::Run>& runs, std::uint32_t line) {
  std::vector<const feedscope::Run*> all;
  for (const feedscope::Run& run : runs) {
    all.push_back(&run);
  }
  return lens_at(all, 0, lens_time(runs.front(), line).value());
}

/// The point of a run that is nearest to the corner.
double nearest_to_corner(const LensRun& run) {
  double nearest = INFINITY;
  for (const LensPoint& point : run.path) {
    nearest = std::min(nearest, point.norm());
  }
  return nearest;
}

TEST(Lens, ShowsACornerWithItsBlendInTwoThirdsOfTheWidth) {
  const LoadedProgram program = loaded("G1 X10 F2000\nX20 Y5\n");
  const std::vector<feedscope::Run> runs{run_of(program, "essid", 0.01), run_of(program, "essid", 0.05)};
  const Lens lens = lens_of_line(runs, 1);
  EXPECT_EQ(lens.centre, Vec3(10, 0, 0));
  EXPECT_EQ(lens.along, Vec3::UnitX());
  EXPECT_NEAR((lens.across - Vec3::UnitY()).norm(), 0, 1e-12) << "the corner opens to that side";
  EXPECT_EQ(lens.line, 1u);
  EXPECT_TRUE(lens.deviates);
  EXPECT_EQ(lens.tolerance, 0.01) << "of the run that is shown";

  const BlendRecord wide = runs[1].trajectory->blend(0);
  EXPECT_NEAR(lens.width, 1.5 * wide.length, 1e-9);
  // Off both lines by epsilon cos(turn/2) in the middle.
  const double error = wide.epsilon * std::cos(std::atan2(5, 10) / 2);
  EXPECT_NEAR(lens.height, 3 * error, 1e-4 * error);
  EXPECT_NEAR(nearest_to_corner(lens.runs[1]), wide.epsilon, 1e-3 * wide.epsilon);
  EXPECT_NEAR(nearest_to_corner(lens.runs[0]), runs[0].trajectory->blend(0).epsilon, 1e-3 * wide.epsilon);
  EXPECT_GT(lens.stretch(), 1);
  EXPECT_NEAR(lens.runs[0].error, runs[0].summary.max_contour_error, 1e-6) << "the cursor is in the middle";
}

TEST(Lens, LeavesLinesWhereTheyAre) {
  const LoadedProgram program = loaded("G1 X10 F2000\nX20 Y5\n");
  const std::vector<feedscope::Run> runs{run_of(program, "essid", 0.05)};
  const Lens lens = lens_of_line(runs, 1);
  const double half = runs[0].trajectory->blend(0).length / 2;
  for (const LensPoint& point : lens.runs[0].path) {
    if (point.x() < -1.01 * half) {
      EXPECT_NEAR(point.y(), 0, 1e-9);
    } else if (point.x() > 1.01 * half) {
      EXPECT_NEAR(point.y(), point.x() / 2, 1e-9);
    }
  }
  ASSERT_EQ(lens.programmed.size(), 1u);
  for (const LensPoint& point : lens.programmed[0]) {
    EXPECT_NEAR(point.y(), std::max(0.0, point.x() / 2), 1e-9);
  }
}

TEST(Lens, SaysWhereNothingDeviates) {
  const LoadedProgram program = loaded("G1 X10 F2000\nX20 Y5\n");
  const std::vector<feedscope::Run> exact{run_of(program, "essid", 0)};
  const Lens corner = lens_of_line(exact, 1);
  EXPECT_FALSE(corner.deviates);
  EXPECT_EQ(corner.stretch(), 1);
  const std::vector<feedscope::Run> blended{run_of(program, "essid", 0.01)};
  const Lens line = lens_at(std::vector<const feedscope::Run*>{&blended[0]}, 0, 0.05);
  EXPECT_FALSE(line.deviates) << "in the middle of a line";
  EXPECT_LT(line.centre.x(), 10);
}

TEST(Lens, LooksAtTheCornerNearby) {
  const LoadedProgram program = loaded("G1 X10 F2000\nX20 Y5\n");
  const feedscope::Run run = run_of(program, "essid", 0.05);
  const Trajectory& trajectory = *run.trajectory;
  const BlendRecord blend = trajectory.blend(0);
  const double begin = trajectory.path().s(blend.element);
  for (const double beside : {-0.2, 0.0, 0.5, 1.0, 1.2}) {
    const double time = trajectory.state_at_path(begin + beside * blend.length).time;
    EXPECT_EQ(lens_at(std::vector<const feedscope::Run*>{&run}, 0, time).centre, Vec3(10, 0, 0)) << beside;
  }
  const double far = trajectory.state_at_path(begin - 2 * blend.length).time;
  EXPECT_LT(lens_at(std::vector<const feedscope::Run*>{&run}, 0, far).centre.x(), 10);
}

TEST(Lens, FindsCornersOfArcs) {
  const LoadedProgram program = loaded("G1 X10 F1000\nG2 X20 Y10 I10 J0\nX30 Y0 I0 J-10\n");
  const std::vector<feedscope::Run> runs{run_of(program, "linuxcnc", 0.05, "linuxcnc-mill"),
                                         run_of(program, "ward", 0.05, "dmg-mori-evo40")};
  const Lens line_to_arc = lens_of_line({runs[1]}, 1);
  EXPECT_EQ(line_to_arc.centre, Vec3(10, 0, 0));
  EXPECT_TRUE(line_to_arc.deviates);
  const LensPoint rim = line_to_arc.programmed.back().back();
  EXPECT_NEAR((LensPoint(10, 0) - rim).norm(), 10, 1e-9) << "on the circle about (20, 0)";
}

TEST(Lens, HasAtMostTheContourErrorOfTheRunOnRandomPrograms) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  const int programs = test::random_cases(160);
  for (int n = 0; n < programs; ++n) {
    std::string text = "G0 X0 Y0 Z0\n";
    for (int i = 0; i < 12; ++i) {
      text += fmt::format("G1 X{:.4f} Y{:.4f} Z{:.4f} F{:.0f}\n", 8 * any(random), 8 * any(random),
                          any(random), 500 + 4000 * any(random));
    }
    const LoadedProgram program = loaded(text);
    std::vector<feedscope::Run> runs;
    for (const ControlModel* model : all_models()) {
      runs.push_back(run_of(program, model->info().id.c_str(), 0.002 + 0.1 * any(random)));
    }
    std::vector<const feedscope::Run*> all;
    for (const feedscope::Run& run : runs) {
      all.push_back(&run);
    }
    const std::size_t shown = random() % all.size();
    const Lens lens = lens_at(all, shown, any(random) * all[shown]->trajectory->duration());
    ASSERT_GT(lens.width, 0) << n;
    ASSERT_GT(lens.height, 0) << n;
    ASSERT_NEAR(lens.along.dot(lens.across), 0, 1e-12);
    ASSERT_NEAR(lens.across.norm(), 1, 1e-12);
    ASSERT_EQ(lens.runs.size(), runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      constexpr double of_search = 1e-6;  // [mm]
      const double most = runs[i].summary.max_contour_error + of_search;
      // The nearest point on the way is not always the nearest one of the whole path, but for other passes.
      EXPECT_LE(lens.runs[i].error, std::max(most, lens.runs[i].largest_error)) << n << ' ' << i;
      EXPECT_LE(3 * lens.runs[i].largest_error, lens.height * (1 + 1e-12) + least_deviation * 3);
      for (const LensPoint& point : lens.runs[i].path) {
        ASSERT_TRUE(point.allFinite());
      }
    }
  }
}

/// A slot whose walls are joined by a small arc: the other wall is at the same place along the first one, and
/// its error, which the picture does not show, must not set the scale.
TEST(Lens, TheErrorFarBesideTheCornerDoesNotSetTheScale) {
  const LoadedProgram program = loaded("G1 X10 F2000\nX10.2 Y0.01\nX10.4\nY6\nX10 Y6.2\nX0 Y9\n");
  const feedscope::Run run = run_of(program, "essid", 0.05);
  const Lens lens = lens_of_line({run}, 1);
  for (const LensRun& seen : lens.runs) {
    double largest = 0;
    const PathDeviation deviation(*run.trajectory->path().programmed());
    for (double s = 0; s < run.trajectory->path_length(); s += 1e-3) {
      const State state = run.trajectory->state_at_path(s);
      if (lens.seen(state.position).norm() <= lens.width / 2) {
        const auto foot = deviation.foot_near(run.trajectory->path().segment(state.element), state.position);
        largest = std::max(largest, std::sqrt(foot.squared));
      }
    }
    EXPECT_LE(seen.largest_error, largest * 1.01 + least_deviation);
  }
}

TEST(Lens, ALineThatMovesNothingHasNoTime) {
  const LoadedProgram program = loaded("G1 X10 F2000\n(nothing)\nX20 Y5\n");
  const feedscope::Run run = run_of(program, "essid", 0.05);
  EXPECT_FALSE(lens_time(run, 2));
  EXPECT_FALSE(lens_time(run, 99));
  EXPECT_TRUE(lens_time(run, 3));
}

}  // namespace
}  // namespace feedscope
