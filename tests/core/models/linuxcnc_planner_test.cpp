#include "core/models/linuxcnc/linuxcnc_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/models/linuxcnc/linuxcnc_settings.h"

namespace feedscope {
namespace {

/// Lines at random, some of them long and slow, some exact stops.
std::vector<LinuxCncSegment> random_lines(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::vector<LinuxCncSegment> lines;
  Vec3 place = Vec3::Zero();
  for (std::uint32_t block = 0; block < 12; ++block) {
    LinuxCncSegment line;
    const double size = std::pow(10, between(-1, 2));
    const Vec3 next = place + size * Vec3(between(-1, 1), between(-1, 1), between(-1, 1));
    line.course = LinuxCncCourse::line(place, next);
    line.block = block;
    line.requested = std::pow(10, between(0, 2.5));
    line.largest = 150;
    line.acceleration = 800;
    line.tolerance = between(0, 0.1);
    line.end = between(0, 1) < 0.2 ? LinuxCncEnd::stop : LinuxCncEnd::parabolic;
    lines.push_back(line);
    place = next;
  }
  return lines;
}

LinuxCncSettings settings_of(bool master) {
  LinuxCncSettings settings;
  settings.velocity = Vec3::Constant(150);
  settings.acceleration = Vec3::Constant(800);
  settings.max_velocity = 250;
  settings.blend_tolerance = 0.05;
  settings.master = master;
  return settings;
}

/// What moves last in a period.
struct Instant {
  std::uint32_t block = 0;
  double progress = 0;  ///< [mm]
  double speed = 0;     ///< [mm/s]
  CauseKind cause = CauseKind::programmed_feed;
};

struct PlannedRun {
  std::vector<Instant> at;  ///< by period; those that were run together have the last of them alone
  std::vector<bool> known;
  std::size_t calls = 0;
};

PlannedRun run_of(const std::vector<LinuxCncSegment>& lines, bool master, bool together) {
  const LinuxCncSettings settings = settings_of(master);
  LinuxCncPlanner planner(settings);
  for (const LinuxCncSegment& line : lines) {
    planner.add(line);
  }
  PlannedRun run;
  while (!planner.empty()) {
    ++run.calls;
    const std::vector<LinuxCncStep>& steps = planner.run_period(together);
    if (steps.empty()) {
      continue;
    }
    const LinuxCncStep& last = steps.back();
    const auto periods = static_cast<std::size_t>(
        std::max(1L, steps.size() == 1 ? std::lround(last.time / settings.period) : 1L));
    run.at.resize(run.at.size() + periods);
    run.known.resize(run.at.size());
    run.at.back() = {last.segment->block, last.to, last.after, last.cause.kind};
    run.known.back() = true;
  }
  return run;
}

TEST(LinuxCncPlanner, PeriodsRunTogetherMoveAsOneByOne) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const bool master = seed % 2 == 0;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<LinuxCncSegment> lines = random_lines(seed);
    const PlannedRun single = run_of(lines, master, false);
    const PlannedRun together = run_of(lines, master, true);
    ASSERT_EQ(single.at.size(), together.at.size());
    EXPECT_LT(together.calls, 0.6 * static_cast<double>(single.calls)) << "else the test shows nothing";
    for (std::size_t i = 0; i < single.at.size(); ++i) {
      if (!together.known[i]) {
        continue;
      }
      ASSERT_EQ(single.at[i].block, together.at[i].block) << "period " << i;
      ASSERT_NEAR(single.at[i].progress, together.at[i].progress, 1e-9) << "period " << i;
      ASSERT_NEAR(single.at[i].speed, together.at[i].speed, 1e-9) << "period " << i;
      ASSERT_EQ(single.at[i].cause, together.at[i].cause) << "period " << i;
    }
  }
}

}  // namespace
}  // namespace feedscope
