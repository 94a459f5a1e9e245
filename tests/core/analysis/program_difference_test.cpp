#include "core/analysis/difference/program_difference.h"

#include <gtest/gtest.h>

#include <random>

#include "core/analysis/difference/toolpath_match.h"

namespace feedscope {
namespace {

using Lines = std::vector<std::string>;

std::string program_of(const Lines& lines) {
  std::string text = "G21 G90 G17 F3000\nG0 X0 Y0 Z2\nG1 Z0\n";
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text + "M30\n";
}

feedscope::Run run_lines(const Lines& lines, const std::string& model = "essid") {
  SetupRequest request;
  request.model = model;
  return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", program_of(lines))),
                      make_setup(request));
}

const Lines plain{"G1 X20", "Y10", "G2 X30 Y20 I10", "G1 X50", "G4 P300", "Y0", "X70"};

ProgramDifference difference_of(const Lines& old, const Lines& now, const std::string& model = "essid") {
  return compare_programs(run_lines(old, model), run_lines(now, model));
}

TEST(ProgramDifference, TheSameProgramIsTheSameThroughout) {
  const ProgramDifference same = difference_of(plain, plain);
  ASSERT_EQ(same.stretches.size(), 1U);
  EXPECT_EQ(same.stretches[0].change, ProgramChange::none);
  EXPECT_EQ(same.stretches[0].gained(), 0);
  EXPECT_EQ(same.same_share(), 1);
  EXPECT_TRUE(largest_changes(same, 10).empty());
}

TEST(ProgramDifference, SaysWhichLinesWentCameOrChanged) {
  Lines removed = plain;
  removed.insert(removed.begin() + 2, {"X22 Y12", "X20 Y10"});  // back to where it was
  const ProgramDifference went = difference_of(removed, plain);
  ASSERT_EQ(went.of(ProgramChange::removed).count, 1U);
  EXPECT_EQ(went.stretches[1].old.first_line, 6U);
  EXPECT_EQ(went.stretches[1].old.last_line, 7U);
  EXPECT_EQ(went.stretches[1].now.first_line, 0U) << "nothing takes its place";
  EXPECT_GT(went.stretches[1].gained(), 0);
  EXPECT_EQ(difference_of(plain, removed).of(ProgramChange::added).count, 1U);

  Lines other = plain;
  other[3] = "G1 X40 Y25\nX50 Y20";
  const ProgramDifference path = difference_of(plain, other);
  ASSERT_EQ(path.of(ProgramChange::path).count, 1U);
  EXPECT_EQ(path.stretches[1].old.first_line, 7U);
  EXPECT_EQ(path.stretches[1].now.last_line, 8U);
  EXPECT_NEAR(path.of(ProgramChange::path).old.length, 20, 1e-9);

  Lines faster = plain;
  faster[5] += " F4000";
  const ProgramDifference feed = difference_of(plain, faster);
  EXPECT_EQ(feed.of(ProgramChange::path).count, 0U);
  EXPECT_EQ(feed.of(ProgramChange::feed).count, 1U);
  EXPECT_EQ(feed.same_share(), 1);
}

TEST(ProgramDifference, ADwellThatIsShortenedIsAnotherMotionOfNoLength) {
  Lines shorter = plain;
  shorter[4] = "G4 P100";
  const ProgramDifference difference = difference_of(plain, shorter);
  const ProgramDifference::Sum& sum = difference.of(ProgramChange::path);
  EXPECT_EQ(sum.count, 1U);
  EXPECT_NEAR(sum.old.time - sum.now.time, 0.2, 1e-9);
  EXPECT_EQ(sum.old.length, 0);
}

TEST(ProgramDifference, TimesOfEachSideAddUpToItsCycleTimeWithEveryModel) {
  Lines now = plain;
  now[1] = "Y10 F2000";
  now.erase(now.begin() + 5);
  for (const ControlModel* model : all_models()) {
    SCOPED_TRACE(model->info().id);
    const feedscope::Run before = run_lines(plain, model->info().id);
    const feedscope::Run after = run_lines(now, model->info().id);
    double old_time = 0, new_time = 0, old_length = 0;
    for (const ProgramStretch& stretch : compare_programs(before, after).stretches) {
      old_time += stretch.old.time;
      new_time += stretch.now.time;
      old_length += stretch.old.length;
    }
    EXPECT_NEAR(old_time, before.summary.cycle_time, 1e-9 * before.summary.cycle_time);
    EXPECT_NEAR(new_time, after.summary.cycle_time, 1e-9 * after.summary.cycle_time);
    EXPECT_NEAR(old_length, before.trajectory->path().programmed()->length(), 1e-9);
  }
}

TEST(ToolpathMatch, CoversBothPathsInOrderAndCallsOnlyTheSameTheSame) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial) {
    Lines old;
    std::uniform_int_distribution<int> coordinate(0, 6);  // few places: motions come again
    for (int i = 0; i < 60; ++i) {
      old.push_back("G1 X" + std::to_string(coordinate(random)) + " Y" + std::to_string(coordinate(random)));
    }
    Lines now = old;
    for (int edit = 0; edit < 4; ++edit) {
      const auto place = now.begin() + std::uniform_int_distribution<int>(0, 40)(random);
      edit % 2 == 0 ? now.erase(place, place + coordinate(random))
                    : now.insert(place, "G1 X" + std::to_string(coordinate(random) + 10));
    }
    const auto path_of = [](const Lines& lines) {
      return load_program(std::make_shared<const SourceText>("test.nc", program_of(lines))).toolpath;
    };
    const auto old_path = path_of(old);
    const auto new_path = path_of(now);
    std::uint32_t old_at = 0, new_at = 0, same = 0;
    for (const MatchedStretch& stretch : match_toolpaths(*old_path, *new_path)) {
      ASSERT_EQ(stretch.old_begin, old_at) << program_of(old) << program_of(now);
      ASSERT_EQ(stretch.now_begin, new_at);
      for (std::uint32_t i = 0; stretch.same && i < stretch.old_end - stretch.old_begin; ++i) {
        const std::uint32_t one = stretch.old_begin + i;
        const std::uint32_t other = stretch.now_begin + i;
        EXPECT_EQ(old_path->start_of(one), new_path->start_of(other));
        EXPECT_EQ(old_path->segments[one].end, new_path->segments[other].end);
        ++same;
      }
      old_at = stretch.old_end;
      new_at = stretch.now_end;
    }
    EXPECT_EQ(old_at, old_path->segments.size());
    EXPECT_EQ(new_at, new_path->segments.size());
    EXPECT_GT(same, old_path->segments.size() / 4) << program_of(old) << program_of(now);
  }
}

}  // namespace
}  // namespace feedscope
