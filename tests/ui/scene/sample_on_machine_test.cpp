#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "tests/core/analysis/turned_runs.h"
#include "ui/scene/path_scene.h"
#include "ui/scene/render_window.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {
namespace {

using test::turned;
using test::TurnedRun;

const std::vector<std::string> known_place{"tool_length_mm=150", "part_zero_x_mm=30", "part_zero_y_mm=0",
                                           "part_zero_z_mm=-320"};
/// A line on which the table turns by 90 degrees under the tip.
const std::string long_turn = "TRAORI\nG0 X40 Y0 Z0\nG1 X60 C90 F3000\n";

SampledPath samples_of(const TurnedRun& run) {
  return sample_executed(run.trajectory, default_max_points, {}, nullptr, run.sources);
}

TEST(OnMachine, PointsAreWhereTheAxesStand) {
  const TurnedRun run = turned(long_turn, "essid", known_place);
  const SampledPath path = samples_of(run);
  ASSERT_NE(path.on_machine, nullptr);
  const SampledPath& machine = *path.on_machine;
  ASSERT_EQ(machine.times.size(), machine.size());
  int known = 0;
  for (std::size_t i = 0; i < machine.size(); ++i) {
    const RotarySample sample = test::at(run, machine.times[i]);
    for (int axis = 0; axis < 3; ++axis) {
      if (const double place = sample.linear[static_cast<std::size_t>(axis)].position; !std::isnan(place)) {
        EXPECT_NEAR(machine.position(i)[axis], place, 1e-3) << i << ' ' << axis;
        ++known;
      }
    }
  }
  EXPECT_GT(known, 90);
  EXPECT_TRUE(machine.found_deviations().shifts.empty()) << "there is no programmed path on the machine";
}

/// A turn of 90 degrees at 70 mm from the axis bends the way of X and Y: spans of 3 degrees are 0.024 mm off.
TEST(OnMachine, PointsAreCloseEnoughForTurnsOfTheTable) {
  const TurnedRun run = turned(long_turn, "essid", known_place);
  const SampledPath path = samples_of(run);
  ASSERT_NE(path.on_machine, nullptr);
  const SampledPath& machine = *path.on_machine;
  double most = 0;
  for (std::size_t i = 0; i + 1 < machine.size(); ++i) {
    const double middle = (machine.times[i] + machine.times[i + 1]) / 2;
    const Vec3 place = run.sources.rotary->slides(run.trajectory->state(middle));
    const Vec3 chord = machine.position(i + 1) - machine.position(i);
    const Vec3 away = place - machine.position(i);
    const double length = chord.norm();
    most = std::max(most, length > 0 ? away.cross(chord).norm() / length : away.norm());
  }
  EXPECT_LT(most, 0.05);
  EXPECT_GT(most, 0) << "the way is bent";
}

TEST(OnMachine, IsNotThereWhereItIsNotKnown) {
  EXPECT_EQ(samples_of(turned(long_turn)).on_machine, nullptr) << "without part zero";
  EXPECT_EQ(samples_of(turned("G1 X20 F1000\n", "essid", known_place)).on_machine, nullptr)
      << "no rotary axis turns";
}

TEST(OnMachine, TheSceneDrawsRunAndToolThere) {
  const TurnedRun run = turned(long_turn, "essid", known_place);
  const auto window = make_render_window(RenderBackend::software);
  PathScene scene;
  scene.attach(*window);
  window->SetSize(800, 600);
  scene.set_programmed(run.path.toolpath);
  scene.set_executed(run.trajectory, std::make_shared<const SampledPath>(samples_of(run)));
  EXPECT_TRUE(scene.knows_machine());
  const double time = run.trajectory->duration() * 0.7;
  EXPECT_EQ(scene.drawn_at(time), run.trajectory->state(time).position);

  scene.set_on_machine(true);
  scene.set_standard_view(StandardView::top);
  window->Render();
  const Vec3 place = run.sources.rotary->slides(run.trajectory->state(time));
  EXPECT_EQ(scene.drawn_at(time), place);
  EXPECT_GT((place - run.trajectory->state(time).position).norm(), 10);
  const std::optional<double> picked = scene.pick_time(scene.pixel_of(place));
  ASSERT_TRUE(picked);
  EXPECT_NEAR(*picked, time, 0.02 * run.trajectory->duration());

  scene.set_on_machine(false);
  EXPECT_EQ(scene.drawn_at(time), run.trajectory->state(time).position);
  scene.detach();
}

TEST(OnMachine, TheToolLeansWithAHeadAndNotWithATable) {
  const TurnedRun table = turned("TRAORI\nG0 X40\nG1 X60 A30 F3000\n", "essid", known_place);
  const State end = table.trajectory->state(table.trajectory->duration());
  EXPECT_NEAR((table.sources.rotary->tool_on_machine(end) - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR(table.sources.rotary->tool_direction(end).dot(Vec3::UnitZ()), std::cos(units::pi / 6), 1e-9);
}

}  // namespace
}  // namespace feedscope::ui
