#include "core/analysis/time/cause_times.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/analysis/run/summary.h"
#include "tests/support/parts.h"
#include "tests/ui/run_fixture.h"

namespace feedscope {
namespace {

std::vector<double> by_parts(const Trajectory& trajectory, double from, double to) {
  std::vector<double> times(all_causes().size());
  for (const Part& part : feedscope::testing::parts_of(trajectory)) {
    const double begin = std::max(from, part.time);
    const double end = std::min(to, part.time + part.duration);
    times[cause_index(part.cause)] += std::max(0.0, end - begin);
  }
  return times;
}

std::string zigzag(unsigned seed, int blocks) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-9, 9);
  std::string text = "G21 G91 G94 F6000\n";
  for (int i = 0; i < blocks; ++i) {
    text += "G1 X" + std::to_string(step(random)) + " Y" + std::to_string(step(random)) + '\n';
  }
  return text + "G4 F0.5\n";
}

TEST(CauseTimes, AgreeWithTheSumOverPartsInAnyStretch) {
  for (const char* model : {"essid", "tapie", "optimal"}) {
    const auto run = test::simulate_text(zigzag(5, 150), model);
    const CauseTimes causes(run.trajectory);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> anywhere(0, run.trajectory->duration());
    for (int i = 0; i < 40; ++i) {
      const auto [from, to] = std::minmax({anywhere(random), anywhere(random)});
      const std::vector<double> expected = by_parts(*run.trajectory, from, to);
      const std::vector<double> found = causes.between(from, to);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_NEAR(found[k], expected[k], 1e-9) << model << ' ' << cause_key(all_causes()[k]);
      }
    }
  }
}

TEST(CauseTimes, OfTheWholeRunAreThoseOfItsSummary) {
  const auto run = test::simulate_text(zigzag(9, 300));
  const std::vector<double> found = CauseTimes(run.trajectory).between(-1, 1e9);
  ASSERT_EQ(found.size(), run.summary.time_by_cause.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k], run.summary.time_by_cause[k], 1e-9) << cause_key(all_causes()[k]);
  }
}

TEST(CauseTimes, MostTimeDecidesAColumn) {
  // 100 mm at 6000 mm/min on a control without dynamics, then half a second at rest.
  const auto run = test::simulate_text("G21 G90 F6000\nG1 X100\nG4 P0.5\nG1 X200\n", "cam");
  const CauseTimes causes(run.trajectory);
  const std::vector<double> times{0, 1, 1.5, 2.4, 2.4};
  const auto kinds = causes.dominating(times);
  ASSERT_EQ(kinds.size(), 4U);
  EXPECT_EQ(kinds[0], CauseKind::programmed_feed);
  EXPECT_EQ(kinds[1], CauseKind::dwell);
  EXPECT_EQ(kinds[2], CauseKind::programmed_feed);
  EXPECT_EQ(kinds[3], std::nullopt);
  const std::vector<double> wide{0.7, 1.6};  // 0.4 s of feed, 0.5 s of dwell
  EXPECT_EQ(causes.dominating(wide).front(), CauseKind::dwell);
}

TEST(CauseTimes, OfNothingAreNone) {
  const std::vector<double> times{0, 1};
  for (const CauseTimes& causes : {CauseTimes(), CauseTimes(std::make_shared<const Trajectory>())}) {
    EXPECT_EQ(causes.dominating(times).front(), std::nullopt);
    const std::vector<double> none = causes.between(0, 1);
    EXPECT_EQ(std::accumulate(none.begin(), none.end(), 0.0), 0);
  }
}

}  // namespace
}  // namespace feedscope
