#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr double block_time = 8;  // [ms]

class BlockTime : public ::testing::TestWithParam<const char*> {
 protected:
  static const ControlModel& model() { return find_model(GetParam()); }
  static Trajectory run(const Toolpath& path, double milliseconds) {
    Settings settings = testing::spinner_settings(model());
    if (settings.has("compaction_mm")) {
      settings.set("compaction_mm", 0.0);  // what it joins counts as one block
    }
    if (milliseconds > 0) {
      settings.set(block_time_key, milliseconds);
    }
    return model().simulate(path, testing::spinner(), settings);
  }
};

/// `count` lines of these lengths [mm] along one line, where nothing else limits 12 m/min.
template <typename Length>
Toolpath lines(int count, const Length& length) {
  Toolpath path;
  for (int i = 0; i < count; ++i) {
    const Vec3 start = path.start_of(path.segments.size());
    testing::append_line(path, start + Vec3(length(), 0, 0), units::from_m_min(12));
  }
  return path;
}

/// F = L / t: blocks of one length run as if that had been programmed.
TEST_P(BlockTime, OfBlocksOfOneLengthIsAFeed) {
  const double length = 0.4;
  Toolpath path = lines(300, [&] { return length; });
  const double limited = run(path, block_time).duration();
  EXPECT_GT(limited, 1.05 * run(path, 0).duration());
  for (Segment& segment : path.segments) {
    segment.feed = length / units::from_ms(block_time);
  }
  EXPECT_NEAR(limited / run(path, 0).duration(), 1, 1e-9);
}

TEST_P(BlockTime, BoundsTheFeedOnBlocksOfRandomLengths) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(0.1, 1.5);
  const Toolpath path = lines(200, [&] { return any(random); });
  const Trajectory motion = run(path, block_time);
  const bool filters = !motion.motions().empty();
  bool limits = false;
  for (int k = 0; k <= 20000; ++k) {
    const State state = motion.state(motion.duration() * k / 20000);
    const std::size_t i = motion.path().base_segment_of(state.element);
    // A corner belongs to both blocks, and filters spread the feed of a block over its neighbours.
    const std::size_t first = i - std::min<std::size_t>(i, filters ? 1 : 0);
    const std::size_t last =
        std::min(i + (filters || motion.path().in_corner(state.element) ? 1 : 0), path.segments.size() - 1);
    double longest = 0;
    for (std::size_t j = first; j <= last; ++j) {
      longest = std::max(longest, path.segments[j].length);
    }
    ASSERT_LE(state.speed, 1.01 * longest / units::from_ms(block_time)) << "line " << i + 1;
    limits = limits || state.cause.kind == CauseKind::block_time;
  }
  EXPECT_TRUE(limits);
}

/// Without it nothing is limited; 0 is without.
TEST_P(BlockTime, IsOffByDefault) {
  const Toolpath path = lines(60, [] { return 0.2; });
  Settings settings = testing::spinner_settings(model());
  EXPECT_FALSE(settings.has(block_time_key));
  const double free = run(path, 0).duration();
  settings.set(block_time_key, 0.0);
  EXPECT_EQ(model().simulate(path, testing::spinner(), settings).duration(), free);
}

/// Rapids and parts of one curve of the program are not blocks that follow one another.
TEST_P(BlockTime, LeavesRapidsAndCurvesAlone) {
  Toolpath path = lines(60, [] { return 0.2; });
  for (Segment& segment : path.segments) {
    segment.on_curve = true;
  }
  EXPECT_EQ(run(path, block_time).duration(), run(path, 0).duration());
  for (Segment& segment : path.segments) {
    segment.on_curve = false;
    segment.rapid = true;
    segment.feed = 0;
  }
  EXPECT_EQ(run(path, block_time).duration(), run(path, 0).duration());
}

INSTANTIATE_TEST_SUITE_P(Models, BlockTime,
                         ::testing::Values("tapie", "essid", "gassara", "msaddek", "ward", "optimal"),
                         [](const auto& info) { return std::string(info.param); });

TEST(BlockTimeOfOthers, IsRefused) {
  for (const char* id : {"cam", "grbl", "klipper", "linuxcnc"}) {
    Machine machine = testing::spinner();
    Settings settings;
    EXPECT_THROW(apply_setting("block_time_ms=1", find_model(id), machine, settings), InputError) << id;
  }
}

}  // namespace
}  // namespace feedscope
