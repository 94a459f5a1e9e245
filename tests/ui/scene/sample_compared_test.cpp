#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/analysis/difference/run_difference.h"
#include "core/analysis/run/run.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/path/compare_sampled.h"

namespace feedscope::ui {
namespace {

LoadedProgram read(const char* text) {
  return load_program(std::make_shared<const SourceText>("test.nc", text));
}

std::shared_ptr<const Trajectory> run_with(const LoadedProgram& program, const std::string& model,
                                           double tolerance) {
  return simulate_run(program,
                      make_setup({.machine = {}, .model = model, .tolerance = tolerance, .assignments = {}}))
      .trajectory;
}

using SharedMotion = std::shared_ptr<const Trajectory>;

SampledPath compared(const SharedMotion& run, const SharedMotion& reference) {
  return sample_compared(run, *reference, sample_executed(reference).times);
}

constexpr const char* corners = "G1 F6000 X50\nY50\nX100 Y0\nG4 P0.5\nG1 X150\nG0 X0\n";

TEST(SampleCompared, HoldsTheDifferencesAtItsPoints) {
  const LoadedProgram program = read(corners);
  const auto fine = run_with(program, "essid", 0.005);
  const auto coarse = run_with(program, "essid", 0.1);
  const SampledPath path = compared(fine, coarse);
  ASSERT_TRUE(path.compared());
  ASSERT_EQ(path.lost.size(), path.size());
  const RunDifference difference = compare_places(*fine, *coarse, path.times);
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_NEAR(double{path.lost[i]}, difference.lost[i], 1e-6) << i;
    EXPECT_NEAR(path.value(Colouring::time_lost, i), double{difference.pace[i]},
                0.004 * std::abs(double{difference.pace[i]}) + 1e-12);
  }
  EXPECT_NEAR(double{path.lost.back()}, fine->duration() - coarse->duration(), 1e-6);
  EXPECT_FALSE(sample_executed(fine).compared());
  double by_cause = 0;
  for (std::size_t i = 0; i < cause_kind_count; ++i) {
    by_cause += path.cause_times[i] - path.reference_cause_times[i];
  }
  EXPECT_NEAR(by_cause, fine->duration() - coarse->duration(), 1e-9);
  const ColourKey key = colour_key(path, Colouring::time_lost);
  EXPECT_NEAR(key.lost, by_cause, 1e-6);
  ASSERT_FALSE(key.changes.empty());
  for (const CauseChange& change : key.changes) {
    const auto kind = static_cast<std::size_t>(change.kind);
    EXPECT_EQ(change.time, path.cause_times[kind] - path.reference_cause_times[kind]);
    EXPECT_LE(std::abs(change.time), std::abs(key.changes.front().time));
  }
}

void expect_same(const SampledPath& one, const SampledPath& other) {
  EXPECT_EQ(one.times, other.times);
  EXPECT_TRUE(one.positions == other.positions);
  EXPECT_EQ(one.lost, other.lost);
  EXPECT_TRUE(one.values == other.values);
}

/// Whether points of both runs are needed or, in the long program, those of one are close enough.
TEST(SampleCompared, IsTheSameOfARunThatHasBeenDrawn) {
  std::string zigzag = "G1 F3000\n";
  for (int i = 1; i <= 12'000; ++i) {
    zigzag += "X" + std::to_string(i) + (i % 2 == 0 ? " Y0\n" : " Y1\n");
  }
  for (const std::string& text : {std::string(corners), zigzag}) {
    const LoadedProgram program = read(text.c_str());
    const auto fine = run_with(program, "essid", 0.005);
    const auto coarse = run_with(program, "essid", 0.1);
    const std::vector<double> times = sample_executed(coarse).times;
    EXPECT_EQ(times.size() > 300'000, text == zigzag) << times.size();
    expect_same(compare_sampled(sample_executed(fine), fine, *coarse, times),
                sample_compared(fine, *coarse, times));
  }
}

/// A run at one feed has two points on a line; where the other one brakes there must be more.
TEST(SampleCompared, HasPointsWhereTheOtherRunChangesItsFeed) {
  const LoadedProgram program = read(corners);
  const auto level = run_with(program, "cam", 0.01);
  const auto real = run_with(program, "essid", 0.01);
  const std::size_t alone = sample_executed(level).size();
  const SampledPath path = compared(level, real);
  EXPECT_GT(path.size(), alone + 50);
  EXPECT_TRUE(std::ranges::is_sorted(path.times));
  EXPECT_EQ(path.found_deviations().shifts.size(), path.size());
  EXPECT_LT(double{path.lost.back()}, 0);  // nothing is as fast as the program
}

TEST(SampleCompared, OfRunsOfOtherProgramsIsRefused) {
  const auto run = run_with(read(corners), "cam", 0.01);
  const auto other = run_with(read("G1 X10 F100\n"), "cam", 0.01);
  EXPECT_THROW(compared(run, other), std::invalid_argument);
}

}  // namespace
}  // namespace feedscope::ui
