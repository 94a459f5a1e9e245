#include "ui/scene/path/colouring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "core/base/units.h"
#include "tests/ui/run_fixture.h"
#include "ui/scene/cause_colour.h"

namespace feedscope::ui {
namespace {

const std::string program = "G21 G90 G94 F3000\nG1 X40\nY40\nX80 F1200\nG0 Z20\n";

SampledPath executed(const std::string& model = "essid") {
  return sample_executed(test::simulate_text(program, model).trajectory);
}

/// Executed points with one quantity.
SampledPath with_values(Colouring quantity, const std::vector<double>& values) {
  SampledPath path;
  for (std::size_t i = 0; i < values.size(); ++i) {
    path.positions.emplace_back(float(i), 0.0F, 0.0F);
    path.kinds.push_back(SpanKind::cut);
    path.times.push_back(double(i));
    path.causes.push_back(CauseKind::programmed_feed);
    for (std::size_t q = 0; q < sampled_count; ++q) {
      const bool wanted = quantity != Colouring::contour_error && q == sample_index(quantity);
      path.values[q].push_back(Stored(wanted ? float(values[i]) : 0.0F));
    }
  }
  path.deviations = std::make_shared<const AskedDeviations>([values](std::span<const double>) {
    SampledDeviations found;
    std::ranges::transform(values, std::back_inserter(found.errors),
                           [](double value) { return Stored(float(value)); });
    return found;
  });
  return path;
}

TEST(ColourKey, OfFeedEndsAtARoundValueAboveThePeak) {
  const ColourKey key = colour_key(executed(), Colouring::feed);
  EXPECT_EQ(key.scale.unit, "mm/min");
  EXPECT_DOUBLE_EQ(key.scale.high, 3000);
  EXPECT_EQ(key.scale.low, 0);
  EXPECT_NEAR(key.scale.position(units::from_mm_min(1500)), 0.5, 1e-12);
}

TEST(ColourKey, OfSignedQuantitiesIsSymmetric) {
  for (const Colouring colouring : {Colouring::tangential_acceleration, Colouring::tangential_jerk}) {
    const ColourKey key = colour_key(executed(), colouring);
    EXPECT_TRUE(key.scale.diverging);
    EXPECT_EQ(key.scale.low, -key.scale.high);
    EXPECT_GT(key.scale.high, 0);
    EXPECT_NEAR(key.scale.position(0), 0.5, 1e-12);
  }
}

TEST(ColourKey, LeavesRarePeaksOutOfTheScaleAndSaysSo) {
  std::vector<double> values(1000, 900);
  ColourKey key = colour_key(with_values(Colouring::jerk, values), Colouring::jerk);
  EXPECT_FALSE(key.scale.beyond);
  EXPECT_NEAR(key.scale.high, 0.9, 0.011);
  values[500] = 1e6;
  key = colour_key(with_values(Colouring::jerk, values), Colouring::jerk);
  EXPECT_TRUE(key.scale.beyond);
  EXPECT_NEAR(key.scale.high, 0.9, 0.011);
}

TEST(ColourKey, OfFeedIsThatOfTheTimeAndNotOfOneFastMove) {
  // Four of 100 seconds at a feed 40 times as high as in the others.
  std::vector<double> feeds(100, units::from_mm_min(300));
  for (std::size_t i = 50; i < 54; ++i) {
    feeds[i] = units::from_mm_min(12000);
  }
  SampledPath path = with_values(Colouring::feed, feeds);
  path.peak_feed = units::from_mm_min(12000);
  const ColourScale cut = colour_key(path, Colouring::feed).scale;
  EXPECT_TRUE(cut.beyond);
  EXPECT_NEAR(cut.high, 300, 15);
  // As fast for half of the time, it is no exception.
  for (std::size_t i = 0; i < 50; ++i) {
    path.values[sample_index(Colouring::feed)][i] = Stored(float(path.peak_feed));
  }
  const ColourScale whole = colour_key(path, Colouring::feed).scale;
  EXPECT_FALSE(whole.beyond);
  EXPECT_NEAR(whole.high, 12000, 600);
}

TEST(ColourKey, OfTimeLostIsThatOfThePathOnWhichAnyIsLost) {
  // A stretch of loss with one place a thousand times as bad, in a path that loses nothing to speak of.
  std::vector<double> lost(10'000, 1e-9);
  for (std::size_t i = 4000; i < 4200; ++i) {
    lost[i] = (i % 2 == 0 ? 1 : -1) * 0.005;
  }
  lost[4100] = 0.1;
  const ColourKey key = colour_key(with_values(Colouring::time_lost, lost), Colouring::time_lost);
  EXPECT_TRUE(key.scale.beyond);
  EXPECT_NEAR(key.scale.high, 5, 0.5) << "ms/mm";
  EXPECT_EQ(key.scale.low, -key.scale.high);
}

/// At a stop a loss for each mm has no bound; it must not take the colours from the path.
TEST(ColourKey, OfTimeLostIsNotThatOfAPlaceWithoutLength) {
  std::vector<double> lost(10'000, 1e-9);
  std::fill(lost.begin() + 4000, lost.begin() + 4200, 0.005);
  lost[4100] = 1e6;
  SampledPath path = with_values(Colouring::time_lost, lost);
  path.positions[4100] = path.positions[4099];
  EXPECT_NEAR(colour_key(path, Colouring::time_lost).scale.high, 5, 0.5) << "ms/mm";
  // Where no more than rounding is lost, rounding has the scale.
  for (Stored& value : path.values[sample_index(Colouring::time_lost)]) {
    value = Stored(1e-5F);
  }
  EXPECT_NEAR(colour_key(path, Colouring::time_lost).scale.high, 0.01, 0.001) << "ms/mm";
}

/// However the values are spread: of what counts at most the rare share lies beyond, and a scale says so.
TEST(ColourKey, HoldsAllButWhatIsRareAndSaysWhatItLeavesOut) {
  std::mt19937 random(5);
  for (int round = 0; round < 40; ++round) {
    std::lognormal_distribution<double> spread(-3, 0.2 + 0.1 * round);
    std::vector<double> values(3000);
    std::ranges::generate(values, [&] { return spread(random); });
    for (const auto& [colouring, quantity] : {std::pair{Colouring::feed, Colouring::feed},
                                              {Colouring::jerk, Colouring::jerk},
                                              {Colouring::time_lost, Colouring::time_lost}}) {
      SampledPath path = with_values(quantity, values);
      path.peak_feed = *std::ranges::max_element(values);
      const ColourScale scale = colour_key(path, colouring).scale;
      const auto beyond =
          std::ranges::count_if(values, [&](double value) { return scale.position(value) > 1.005; });
      EXPECT_EQ(beyond > 0, scale.beyond) << "round " << round;
      EXPECT_LE(beyond, 0.051 * 3000) << "round " << round;
    }
  }
}

TEST(ColourKey, OfContourErrorTakesMicrometresOrMillimetres) {
  EXPECT_EQ(
      colour_key(with_values(Colouring::contour_error, {0, 0.004}), Colouring::contour_error).scale.unit,
      "µm");
  const ColourKey large = colour_key(with_values(Colouring::contour_error, {0, 4}), Colouring::contour_error);
  EXPECT_EQ(large.scale.unit, "mm");
  EXPECT_NEAR(large.scale.high, 4, 0.2);
  const ColourKey none = colour_key(with_values(Colouring::contour_error, {0, 0}), Colouring::contour_error);
  EXPECT_TRUE(none.has_scale()) << "no error is shown as the lowest of a micrometre";
}

TEST(ColourKey, AgainstNoOtherRunHasNoScale) {
  for (const Colouring colouring : {Colouring::time_lost, Colouring::path_distance}) {
    ASSERT_TRUE(needs_reference(colouring));
    EXPECT_FALSE(colour_key(executed(), colouring).has_scale());
    const Rgb blue{0, 0, 1};
    const SampledPath path = executed();
    for (const Rgba& colour : point_colours(path, colour_key(path, colouring), Background::light, blue)) {
      EXPECT_EQ(colour, (Rgba{0, 0, 255, 255}));
    }
  }
}

TEST(ColourKey, OfTimeLostIsNeutralAtZeroAndAsFarOnBothSides) {
  const ColourKey key =
      colour_key(with_values(Colouring::time_lost, {-0.002, 0, 0.0015}), Colouring::time_lost);
  EXPECT_EQ(key.scale.unit, "ms/mm");
  EXPECT_TRUE(key.scale.diverging);
  EXPECT_DOUBLE_EQ(key.scale.high, 2);
  EXPECT_DOUBLE_EQ(key.scale.low, -2);
  EXPECT_NEAR(key.scale.position(0), 0.5, 1e-12);
  const ColourKey same = colour_key(with_values(Colouring::time_lost, {0, 1e-12, 0}), Colouring::time_lost);
  EXPECT_TRUE(same.has_scale()) << "rounding is drawn as no time lost, not as the ends of a scale";
  EXPECT_NEAR(same.scale.position(1e-12), 0.5, 1e-6);
}

TEST(ColourKey, OfTwoPathsHoldsBoth) {
  const SampledPath small = with_values(Colouring::path_distance, {0, 0.004});
  const SampledPath large = with_values(Colouring::path_distance, {0, 4});
  for (const auto& key : {colour_key(small, large, Colouring::path_distance),
                          colour_key(large, small, Colouring::path_distance)}) {
    EXPECT_EQ(key.scale.unit, "mm");
    EXPECT_NEAR(key.scale.high, 4, 0.2);
  }
  EXPECT_EQ(colour_key(small, executed(), Colouring::path_distance).scale.unit, "µm");
}

/// Rapids included, however few points the path is drawn with: the legend says what the tables say.
TEST(ColourKey, OfCausesHasTheSharesOfTheCycleTimeThatTheSummaryHas) {
  const feedscope::Run run = test::simulate_text(program);
  std::array<double, cause_kind_count> expected{};
  for (std::size_t i = 0; i < run.summary.time_by_cause.size(); ++i) {
    expected[static_cast<std::size_t>(all_causes()[i].kind)] +=
        run.summary.time_by_cause[i] / run.summary.cycle_time;
  }
  for (const std::size_t points : {std::size_t{6}, default_max_points}) {
    const ColourKey key = colour_key(sample_executed(run.trajectory, points), Colouring::cause);
    ASSERT_FALSE(key.causes.empty());
    double sum = 0;
    for (std::size_t i = 0; i < key.causes.size(); ++i) {
      const CauseShare& cause = key.causes[i];
      EXPECT_NEAR(cause.share, expected[static_cast<std::size_t>(cause.kind)], 1e-12);
      sum += cause.share;
      if (i > 0) {
        EXPECT_LE(cause.share, key.causes[i - 1].share);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(ColourKey, OfNothingIsEmpty) {
  for (const Colouring colouring : all_colourings()) {
    const ColourKey key = colour_key(SampledPath(), colouring);
    EXPECT_FALSE(key.has_scale());
    EXPECT_TRUE(key.causes.empty());
  }
}

Rgba bytes(const Rgb& colour) {
  const auto byte = [](double part) { return static_cast<unsigned char>(std::lround(255 * part)); };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2]), 255};
}

TEST(PointColours, FollowTheScale) {
  const SampledPath path = with_values(Colouring::feed_ratio, {0, 0.5, 1, 1.5});
  for (const Background background : {Background::light, Background::dark}) {
    const auto colours = point_colours(path, colour_key(path, Colouring::feed_ratio), background, {});
    ASSERT_EQ(colours.size(), 4);
    EXPECT_EQ(colours[0], bytes(map_colour(0, background)));
    EXPECT_EQ(colours[2], bytes(map_colour(1, background)));
    EXPECT_EQ(colours[3], colours[2]) << "clamped";
    EXPECT_NE(colours[1], colours[0]);
    EXPECT_NE(colours[1], colours[2]);
  }
}

TEST(PointColours, AreThoseOfCausesAndRuns) {
  const SampledPath path = executed();
  const auto causes = point_colours(path, colour_key(path, Colouring::cause), Background::dark, {});
  const Rgb green{0, 0.5, 0.25};
  const auto run = point_colours(path, colour_key(path, Colouring::run), Background::dark, green);
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(causes[i], bytes(cause_colour(path.causes[i], Background::dark)));
    EXPECT_EQ(run[i], bytes(green));
  }
}

TEST(ColouringKey, IsOneOfItsOwn) {
  std::set<std::string> keys;
  for (const Colouring colouring : all_colourings()) {
    keys.insert(colouring_key(colouring));
  }
  EXPECT_EQ(keys.size(), all_colourings().size());
}

}  // namespace
}  // namespace feedscope::ui
