#include "ui/charts/run_overlay.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

/// Many corners: what the blends save adds up.
std::string staircase(int steps) {
  std::string text = "G21 G91 G94 F3000\n";
  for (int i = 0; i < steps; ++i) {
    text += i % 2 == 0 ? "G1 X2\n" : "G1 Y2\n";
  }
  return text;
}

TEST(CuttingFeed, OfThinPeaksIsThatOfTheRest) {
  const auto run = test::simulate_text("G21 G90 G94 F3000\nG1 X100\n", "cam");
  const Envelope envelope(run.trajectory);
  const double fastest = envelope.cutting()[QuantityId::feed].max;  // [mm/s]
  std::vector<Band> columns(30);
  for (Band& band : columns) {
    band[QuantityId::feed].add(5);
    band[QuantityId::programmed_feed].add(5);
  }
  columns[7][QuantityId::feed].add(static_cast<float>(fastest));
  for (std::size_t rapid = 12; rapid < 20; ++rapid) {
    columns[rapid][QuantityId::feed].add(static_cast<float>(4 * fastest));
  }
  const CuttingFeed peaks = cutting_feed(&envelope, columns, {}).value();
  EXPECT_TRUE(peaks.without_peaks);
  EXPECT_NEAR(peaks.achieved, 5, 1e-6);
  for (std::size_t operation = 8; operation < 11; ++operation) {
    columns[operation][QuantityId::feed].add(static_cast<float>(fastest));
  }
  const CuttingFeed whole = cutting_feed(&envelope, columns, {}).value();
  EXPECT_FALSE(whole.without_peaks);
  EXPECT_EQ(whole.achieved, fastest);
}

TEST(SamePlace, IsTheSameWhereThePathIsTheSame) {
  const auto run = test::simulate_text(staircase(20));
  const BlendedPath& path = run.trajectory->path();
  for (double s = 0; s <= path.length(); s += 0.37) {
    EXPECT_NEAR(same_place(path, s, path), s, 1e-9);
  }
}

TEST(SamePlace, IsNearOnAPathWithOtherBlends) {
  const auto rounded = test::simulate_text(staircase(200)).trajectory;
  const auto sharp = test::simulate_text(staircase(200), "cam").trajectory;
  ASSERT_GT(sharp->path_length() - rounded->path_length(), 2);
  double largest = 0;
  for (double s = 0; s <= rounded->path_length(); s += 0.21) {
    const double there = same_place(rounded->path(), s, sharp->path());
    const Vec3 gap = rounded->state_at_path(s).position - sharp->state_at_path(there).position;
    largest = std::max(largest, gap.norm());
  }
  EXPECT_LT(largest, 0.6);  // within a corner's transition, whatever lies behind
  EXPECT_NEAR(same_place(rounded->path(), rounded->path_length(), sharp->path()), sharp->path_length(), 1e-9);
}

TEST(SamePlace, NeverFalls) {
  const auto compacted = test::simulate_text(staircase(60), "msaddek").trajectory;
  const auto sharp = test::simulate_text(staircase(60), "cam").trajectory;
  double before = 0;
  for (double s = 0; s <= sharp->path_length(); s += 0.05) {
    const double there = same_place(sharp->path(), s, compacted->path());
    EXPECT_GE(there, before - 1e-9);
    before = there;
  }
}

TEST(SamePlace, OfNothingIsTheBeginning) {
  EXPECT_EQ(same_place(BlendedPath(), 3, BlendedPath()), 0);
}

}  // namespace
}  // namespace feedscope::ui
