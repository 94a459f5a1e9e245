#include "core/analysis/envelope/usual_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/analysis/envelope/envelope.h"
#include "tests/ui/run_fixture.h"

namespace feedscope {
namespace {

/// A long line at 1200 mm/min, cut 40 times, after rapids to and fro.
std::string cuts_and_rapids() {
  std::string text = "G21 G90 G94 G0 X0 Y0 F1200\n";
  for (int i = 0; i < 40; ++i) {
    text += "G1 X100\nG0 Y10\nG0 X0\nG0 Y0\n";
  }
  return text;
}

TEST(UsualMotion, OfALongLineIsItsProgrammedFeed) {
  // Ramps to 20 mm/s last less than a tenth of a second of the five that a line takes.
  const auto run = test::simulate_text("G21 G90 G94 G1 X1000 F1200\n");
  const std::vector<double> times{0, run.trajectory->duration()};
  const UsualMotion usual = usual_motion(*run.trajectory, times, true);
  ASSERT_EQ(usual.ranges.size(), 1U);
  EXPECT_NEAR(usual.ranges[0][QuantityId::feed].min, 20, 1e-4);
  EXPECT_NEAR(usual.ranges[0][QuantityId::feed].max, 20, 1e-4);
  EXPECT_NEAR(usual.ranges[0][QuantityId::acceleration_x].max, 0, 1e-4);
  EXPECT_EQ(usual.feeds.size(), 192U);
}

TEST(UsualMotion, FallsWithinTheExtremesAndOmitsRapids) {
  const auto run = test::simulate_text(cuts_and_rapids());
  const Envelope envelope(run.trajectory);
  std::vector<double> times;
  for (int i = 0; i <= 10; ++i) {
    times.push_back(run.trajectory->duration() * i / 10);
  }
  for (const bool rapids : {true, false}) {
    const UsualMotion usual = usual_motion(*run.trajectory, times, rapids);
    const std::vector<Band> extremes = rapids ? envelope.columns(times) : envelope.cutting_columns(times);
    ASSERT_EQ(usual.ranges.size(), extremes.size());
    for (std::size_t i = 0; i < extremes.size(); ++i) {
      for (std::size_t k = 0; k < charted_of_motion.count; ++k) {
        const Extent& range = usual.ranges[i].extents[k];
        ASSERT_FALSE(range.empty());
        EXPECT_GE(range.min, extremes[i].extents[k].min - 1e-3F) << i << " " << k;
        EXPECT_LE(range.max, extremes[i].extents[k].max + 1e-3F) << i << " " << k;
      }
    }
    EXPECT_TRUE(std::ranges::is_sorted(usual.feeds));
    // Rapids of this machine run far beyond 20 mm/s.
    EXPECT_EQ(usual.feeds.back() > 20.01F, rapids);
  }
}

TEST(Envelope, OfTheCuttingKnowsNoRapid) {
  const auto run = test::simulate_text(cuts_and_rapids());
  const Envelope envelope(run.trajectory);
  std::vector<double> times;
  for (int i = 0; i <= 500; ++i) {
    times.push_back(run.trajectory->duration() * i / 500);
  }
  const std::vector<Band> columns = envelope.cutting_columns(times);
  std::size_t empty = 0;
  for (const Band& column : columns) {
    const Extent& feed = column[QuantityId::feed];
    empty += feed.empty() ? 1 : 0;
    if (!feed.empty()) {
      EXPECT_LE(feed.max, 20.001F);
      EXPECT_NEAR(column[QuantityId::programmed_feed].max, 20, 1e-4);
      EXPECT_NEAR(column[QuantityId::velocity_y].max, 0, 1e-3) << "Y moves in rapids alone";
    }
  }
  EXPECT_GT(empty, 0U) << "a rapid is longer than a column";
  const auto stretches = envelope.rapids().outside(times);
  const std::vector<double> causes = envelope.causes().within(stretches);
  EXPECT_EQ(causes[cause_index({CauseKind::rapid})], 0);
  const auto kinds = envelope.causes().dominating(stretches, columns.size());
  EXPECT_EQ(static_cast<std::size_t>(
                std::ranges::count_if(kinds, [](const auto& kind) { return !kind.has_value(); })),
            empty);
}

}  // namespace
}  // namespace feedscope
