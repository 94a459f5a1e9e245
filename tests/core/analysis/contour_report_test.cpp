#include "core/analysis/contour/contour_report.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace feedscope {
namespace {

using Kind = ContourSpot::Kind;
constexpr double degree = std::numbers::pi / 180;

Run run_of(const std::string& text, const std::string& model, std::optional<double> tolerance = {},
           const std::vector<std::string>& assignments = {}) {
  SetupRequest request;
  request.model = model;
  request.tolerance = tolerance;
  request.assignments = assignments;
  return simulate_run(load_program(std::make_shared<const SourceText>("test.nc", text)), make_setup(request));
}

const std::string two_corners =
    "G21 G90 G94 F3000\n"
    "N10 G1 X20 Y0\n"
    "N20 G1 X40 Y20\n"
    "N30 G1 X40 Y-20\n";

TEST(ContourReport, NamesCornersByTheirTurnAndSide) {
  const ContourReport report = contour_report(run_of(two_corners, "essid", 0.05), 5);
  ASSERT_EQ(report.worst.size(), 2U);  // 45 degrees to the left, 135 to the right
  for (const ContourFinding& found : report.worst) {
    const bool is_first = found.place.side > 0;
    EXPECT_EQ(found.spot.kind, Kind::corner);
    EXPECT_NEAR(found.spot.turn, (is_first ? 45 : 135) * degree, 1e-9);
    EXPECT_TRUE(found.spot.inside);
    EXPECT_EQ(found.block, is_first ? "N10" : found.place.line == 3 ? "N20" : "N30");
    EXPECT_GT(found.feed, 0);
    EXPECT_NEAR(found.programmed_feed, 50, 1e-9);
    EXPECT_EQ(found.tolerance, 0.05);
  }
  EXPECT_EQ(report.largest, report.worst[0].place.error);
  EXPECT_EQ(report.tolerance, (std::array{0.05, 0.05}));
}

/// The corner behind a block so short that the nearest point of it lies in its first half.
TEST(ContourReport, TakesTheToleranceOfTheNeighbourThatTheCornerIsOf) {
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  request.tolerance = 0.3;
  request.assignments = {"enforce=off"};
  const auto text = std::make_shared<const SourceText>(
      "test.nc", "G17 G21 G90 G94\nG1 X0.5 F6000\nG1 X-3.2950 Y3.2555 F3000\nG1 X16.7050\nM30\n");
  const ContourReport report = contour_report(simulate_run(load_program(text), make_setup(request)), 10);
  ASSERT_FALSE(report.worst.empty());
  bool short_block = false;
  for (const ContourFinding& found : report.worst) {
    EXPECT_EQ(found.tolerance, 0.3);
    if (found.spot.kind == Kind::corner) {
      const std::size_t own = found.place.segment;
      EXPECT_TRUE(found.spot.neighbour == own + 1 || found.spot.neighbour + 1 == own);
      short_block = short_block || found.place.segment == 0;
    }
  }
  EXPECT_TRUE(short_block);
}

TEST(ContourReport, ListsPlacesThatAreAsBadInTheOrderOfTheProgram) {
  std::string zigzag = "G21 G90 G94 F3000\n";
  for (int i = 1; i <= 12; ++i) {
    zigzag += "G1 X" + std::to_string(7.3 * i) + " Y" + (i % 2 == 1 ? "9.1" : "0") + "\n";
  }
  const ContourReport report = contour_report(run_of(zigzag, "essid", 0.05), 20);
  ASSERT_EQ(report.worst.size(), 11U);
  for (std::size_t i = 1; i < report.worst.size(); ++i) {
    EXPECT_GT(report.worst[i].place.time, report.worst[i - 1].place.time);
  }
}

TEST(ContourReport, FilteredMotionCutsCornersAndArcsInside) {
  const ContourReport corners = contour_report(run_of(two_corners, "ward"), 2);
  ASSERT_EQ(corners.worst.size(), 2U);
  EXPECT_EQ(corners.worst[0].spot.kind, Kind::corner);
  EXPECT_TRUE(corners.worst[0].spot.inside);
  const ContourReport arc =
      contour_report(run_of("G21 G17 G90 G94 F6000\nG1 X10 Y0\nG3 X10 Y20 I0 J10\nG1 X0 Y20\n", "ward"), 1);
  ASSERT_EQ(arc.worst.size(), 1U);
  EXPECT_EQ(arc.worst[0].spot.kind, Kind::arc);
  EXPECT_NEAR(arc.worst[0].spot.radius, 10, 1e-9);
  EXPECT_TRUE(arc.worst[0].spot.inside);
  EXPECT_GT(arc.worst[0].place.side, 0);
}

TEST(ContourReport, TakesTheToleranceThatTheProgramAsksFor) {
  const std::string text =
      "G21 G90 G94 F3000\nG64 P0.02\nG1 X20 Y0\nG1 X20 Y20\nG64 P0.1\nG1 X40 Y20\nG1 X40 Y40\nG1 X60 Y40\n";
  const ContourReport report = contour_report(run_of(text, "essid"), 5);
  ASSERT_EQ(report.tolerance, (std::array{0.02, 0.1}));
  ASSERT_EQ(report.worst.size(), 4U);
  EXPECT_EQ(report.worst[0].tolerance, 0.1);
  EXPECT_EQ(report.worst[3].tolerance, 0.02);
  for (const ContourFinding& found : report.worst) {
    EXPECT_TRUE(keeps_tolerance(found.place.error, *found.tolerance));
  }
}

TEST(ContourReport, OfAPathThatIsFollowedExactlyIsEmpty) {
  const ContourReport report = contour_report(run_of(two_corners, "cam", 0.0), 5);
  EXPECT_EQ(report.largest, 0);
  EXPECT_TRUE(report.worst.empty());
  EXPECT_EQ(std::accumulate(report.spread.right.begin(), report.spread.right.end(), 0.0), 0);
}

TEST(ContourReport, OfAnEmptyProgramIsEmpty) {
  for (const char* model : {"essid", "ward", "msaddek", "optimal"}) {
    EXPECT_TRUE(contour_report(run_of("%\n", model), 3).worst.empty()) << model;
  }
}

TEST(ContourSpot, OfTheLaterTurnsOfAHelixLiesOnThem) {
  Toolpath path;
  Segment block{};
  block.kind = SegmentKind::arc;
  block.index = 0;
  block.end = Vec3::Zero();
  Arc helix{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(0, 0, 0.1), 5, 6 * std::numbers::pi};
  block.length = helix.length();
  path.arcs = {helix};
  path.segments = {block};
  ContourPlace place;
  place.error = 0.01;
  place.programmed = helix.at(0.7 * helix.length()).position;
  const Vec3 outwards = (place.programmed - Vec3(0, 0, place.programmed.z())).normalized();
  for (const double side : {-0.01, 0.01}) {
    place.position = place.programmed + side * outwards;
    const ContourSpot spot = contour_spot(path, place);
    EXPECT_EQ(spot.kind, Kind::arc);
    EXPECT_EQ(spot.inside, side < 0);
  }
}

}  // namespace
}  // namespace feedscope
