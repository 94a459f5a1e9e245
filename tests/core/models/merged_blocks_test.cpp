#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/analysis/time/line_times.h"
#include "core/base/error.h"
#include "tests/support/motion_checks.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

constexpr const char* key = "merge_collinear_mm";
/// For points that are off by rounding alone, so that the first part of a line is not merged where the whole
/// line is not [mm].
constexpr double exact = 1e-9;

/// A model that plans blocks, and a setting of it.
struct Case {
  const char* model;
  const char* key = "";
  const char* value = "";
};

class MergedBlocks : public ::testing::TestWithParam<Case> {
 protected:
  static Settings settings(std::optional<double> merge) {
    Settings settings = testing::spinner_settings(find_model(GetParam().model));
    if (*GetParam().key != 0) {
      settings.set(GetParam().key, std::string(GetParam().value));
    }
    if (merge) {
      settings.set(key, *merge);
    }
    return settings;
  }
  static Trajectory run(const Toolpath& path, std::optional<double> merge) {
    return find_model(GetParam().model).simulate(path, testing::spinner(), settings(merge));
  }
};

/// Every line of `path` in `parts` lines, of the same length or of random ones, whose ends are off by up to
/// `noise` [mm]; lines are numbered from 1.
Toolpath split(const Toolpath& path, int parts, bool even, double noise, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Toolpath out = path;
  out.segments.clear();
  std::uint32_t line = 0;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Vec3 from = path.start_of(i);
    Segment segment = path.segments[i];
    const Vec3 end = segment.end;
    std::vector<double> shares{1};
    for (int k = 1; segment.kind == SegmentKind::line && !segment.rapid && k < parts; ++k) {
      shares.push_back(even ? static_cast<double>(k) / parts : 0.001 + 0.998 * unit(random));
    }
    std::sort(shares.begin(), shares.end());
    for (const double share : shares) {
      const Vec3 off = Vec3(unit(random), unit(random), unit(random)) - Vec3::Constant(0.5);
      segment.end = share == 1 ? end : Vec3(from + share * (end - from) + noise * off);
      if (segment.kind == SegmentKind::line) {
        segment.length = (segment.end - out.start_of(out.segments.size())).norm();
      }
      segment.line = ++line;
      out.segments.push_back(segment);
    }
  }
  return out;
}

TEST_P(MergedBlocks, RunALineThatIsSplitAsTheWholeLine) {
  // The merged path is the path of the whole lines, so that the plan is the same.
  std::mt19937 random(1);
  for (int i = 0; i < 12; ++i) {
    const Toolpath path = testing::random_path(random, 1 + 3 * i);
    const double whole = run(path, exact).duration();
    for (const int parts : {2, 3, 7}) {
      const Toolpath pieces = split(path, parts, i % 2 == 0, 0, random);
      EXPECT_NEAR(run(pieces, exact).duration() / whole, 1, 1e-9) << "program " << i << ", " << parts;
    }
  }
}

TEST_P(MergedBlocks, FollowTheSameCourseOnTheLinesOfTheProgram) {
  std::mt19937 random(2);
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Toolpath path = testing::random_path(random, 2 + 3 * i);
    const Toolpath pieces = split(path, 3, false, 0, random);
    const Trajectory whole = run(path, exact);
    const Trajectory merged = run(pieces, exact);
    ASSERT_EQ(merged.path().programmed()->segments.size(), pieces.segments.size());
    testing::expect_no_gaps_between_pieces(merged);
    testing::expect_rest_at_the_programmed_ends(pieces, merged);
    for (int k = 0; k <= 200; ++k) {
      const double time = whole.duration() * k / 200;
      const State a = whole.state(time);
      const State b = merged.state(time);
      ASSERT_LT((a.position - b.position).norm(), 1e-6) << time;
      ASSERT_NEAR(a.speed, b.speed, 1e-5 * (1 + a.speed)) << time;
      ASSERT_NEAR(a.path_length, b.path_length, 1e-6 * (1 + a.path_length)) << time;
    }
  }
}

TEST_P(MergedBlocks, GiveEveryLineItsTimeAndItsPlace) {
  // A straight line from rest to rest: nothing of it is taken by corners. Filters let the path lag, not
  // leave.
  std::mt19937 random(3);
  const Toolpath path = testing::polyline({{0, 0, 0}, {30, 20, 10}}, 50);
  const Toolpath pieces = split(path, 5, false, 0, random);
  const Trajectory merged = run(pieces, 1e-6);
  const LineTimes times(merged);
  constexpr double rounding = 1e-9;  // of the clock [s]
  double sum = 0;
  for (std::uint32_t line = 1; line <= 5; ++line) {
    const LineTime of_line = times.of(line, line);
    EXPECT_GT(of_line.time, 0) << line;
    EXPECT_NEAR(of_line.length, pieces.segments[line - 1].length, 1e-6) << line;
    sum += of_line.time;
    const State begin = merged.state(merged.time_of_line(line) + rounding);
    EXPECT_LT((begin.position - pieces.start_of(line - 1)).norm(), 1e-6) << line;
    EXPECT_EQ(begin.line, line);
  }
  EXPECT_NEAR(sum, merged.duration(), 1e-9);
}

TEST_P(MergedBlocks, AddUpToTheCycleTime) {
  std::mt19937 random(4);
  for (int i = 0; i < 12; ++i) {
    const Toolpath pieces = split(testing::random_path(random, 2 + 3 * i), 4, false, 5e-7, random);
    const Trajectory merged = run(pieces, 1e-6);
    const LineTimes times(merged);
    EXPECT_NEAR(times.of(1, times.line_count()).time, merged.duration(), 1e-9 * (1 + merged.duration()));
    std::uint32_t before = 0;
    for (std::size_t e = 0; e < merged.path().size(); ++e) {
      ASSERT_GE(merged.path().segment(e), before);
      before = merged.path().segment(e);
    }
  }
}

TEST_P(MergedBlocks, AreNotMergedWithoutTheSetting) {
  std::mt19937 random(5);
  const Toolpath pieces = split(testing::random_path(random, 30), 2, true, 0, random);
  EXPECT_EQ(run(pieces, std::nullopt).duration(), run(pieces, 0).duration());
}

INSTANTIATE_TEST_SUITE_P(Models, MergedBlocks,
                         ::testing::Values(Case{"essid"}, Case{"essid", "reading", "strict"},
                                           Case{"essid", "compressor", "on"}, Case{"gassara"}, Case{"tapie"},
                                           Case{"msaddek"}, Case{"ward"}, Case{"optimal"},
                                           Case{"optimal", "path", "msaddek"}),
                         [](const auto& of) { return std::string(of.param.model) + of.param.value; });

TEST(MergedBlocksOfEssid, CostNoneOfTheTimeThatHalfBlocksCost) {
  // Blends take half of a block at most: with chords of a circle in two, a quarter of a chord.
  std::mt19937 random(6);
  std::vector<Vec3> points;
  for (int i = 0; i <= 60; ++i) {
    points.push_back({5 * std::cos(0.1 * i), 5 * std::sin(0.1 * i), 0});
  }
  const Toolpath chords = testing::polyline(points, 50);
  const Toolpath halves = split(chords, 2, true, 0, random);
  const ControlModel& essid = find_model("essid");
  Settings settings = testing::spinner_settings(essid);
  const double whole = essid.simulate(chords, testing::spinner(), settings).duration();
  EXPECT_GT(essid.simulate(halves, testing::spinner(), settings).duration(), 1.05 * whole);
  settings.set(key, exact);
  EXPECT_DOUBLE_EQ(essid.simulate(halves, testing::spinner(), settings).duration(), whole);
}

TEST(MergedBlocksOfMsaddek, AreCompactedFurther) {
  std::mt19937 random(7);
  const ControlModel& msaddek = find_model("msaddek");
  Settings settings = testing::spinner_settings(msaddek);
  settings.set("compaction_mm", 5.0);
  settings.set(key, exact);
  for (int i = 0; i < 12; ++i) {
    const Toolpath path = testing::random_path(random, 30);
    const Toolpath pieces = split(path, 3, true, 0, random);
    const Trajectory merged = msaddek.simulate(pieces, testing::spinner(), settings);
    EXPECT_NEAR(merged.duration() / msaddek.simulate(path, testing::spinner(), settings).duration(), 1, 1e-9);
    testing::expect_no_gaps_between_pieces(merged);
  }
}

TEST(MergedBlocksOfOpenControls, AreRefused) {
  for (const char* id : {"grbl", "klipper", "linuxcnc"}) {
    Machine machine = testing::spinner();
    Settings settings;
    EXPECT_THROW(apply_setting("merge_collinear_mm=0.000001", find_model(id), machine, settings), InputError)
        << id;
  }
}

}  // namespace
}  // namespace feedscope
