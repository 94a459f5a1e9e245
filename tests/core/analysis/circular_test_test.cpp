#include "core/analysis/circularity/circular_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/analysis/circularity/test_program.h"
#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

Setup mikron_with(const std::vector<std::string>& assignments = {}) {
  return make_setup({"mikron-ucp710", "", {}, assignments});
}

CircularRequest circle_of(double radius, double feed_m_min, double entry_radius = 0) {
  CircularRequest request;
  request.radius = radius;
  request.feed = units::from_m_min(feed_m_min);
  request.sweep = full_turn;
  request.entry_radius = entry_radius;
  return request;
}

struct TapieCase {
  CircularRequest request;
  double zone;     ///< um, derived from Kv 60 1/s, Tv 6 ms, full feed-forward
  double squares;  ///< um; 0: not derived
};

// Tapie 2007, tables 3 and 5, as computed; measured were 43, 29, 57, 26, 56, 71 and 20 to 25 um
// (core/models/tapie/README.md).
TEST(CircularTest, CirclesOfTapieAreAsRoundAsTheirDrivesMakeThem) {
  const std::vector<TapieCase> cases{
      {circle_of(2.5, 6), 34.2, 36.5},       {circle_of(30, 6.01), 31.6, 32.5},
      {circle_of(30, 9.01), 63.4, 66.7},     {circle_of(30, 6.748, 20), 27.1, 0},
      {circle_of(30, 9.549, 20), 56.3, 0},   {circle_of(30, 11.968, 20), 65.7, 0},
      {circle_of(2.5, 5.984, 1.5), 24.1, 0},
  };
  for (const TapieCase& c : cases) {
    const CircularTest test = run_circular_test(c.request, mikron_with());
    EXPECT_TRUE(test.actual);
    for (const CirclePass& pass : test.passes) {
      EXPECT_NEAR(units::to_um(pass.circularity.zone), c.zone, 0.005 * c.zone) << c.request.radius;
      if (c.squares > 0) {
        EXPECT_NEAR(units::to_um(pass.circularity.by_squares), c.squares, 0.01 * c.squares)
            << c.request.radius;
      }
    }
  }
}

// In the middle of a circle that is run steadily the radius grows by the gain of the drives, and by as much
// seen from the programmed centre.
TEST(CircularTest, LargestDeviationIsTheSteadyGrowth) {
  const CircularTest test = run_circular_test(circle_of(30, 6), mikron_with());
  EXPECT_NEAR(units::to_um(test.passes[0].circularity.largest), 33.27, 0.2);
  EXPECT_NEAR(units::to_m_min(test.passes[0].reached_feed), 6, 1e-9);
}

TEST(CircularTest, SetPathOfAMachineWithoutDrivesIsRound) {
  const auto setup = make_setup({"spinner-mvc850", "essid", {}, {}});
  const CircularTest test = run_circular_test(circle_of(30, 3), setup);
  EXPECT_FALSE(test.actual);
  EXPECT_LT(test.both->zone, 1e-8);
  EXPECT_LT(std::abs(*test.d()), 1e-8);
}

// Delays of different length tilt the oval one way counter-clockwise and the other way clockwise: each pass
// is as round as the other, both together are not as round.
TEST(CircularTest, DirectionsDifferWhereTheDelaysOfTheAxesDo) {
  const CircularTest test =
      run_circular_test(circle_of(50, 1.2), mikron_with({"Y.velocity_feedforward=0.9"}));
  const double each = test.passes[0].circularity.zone;
  EXPECT_NEAR(test.passes[1].circularity.zone, each, 0.02 * each);
  // v (tau_x - tau_y)/2 sin 2 th: a range of v tau = 20 * 0.1/60.
  EXPECT_NEAR(each, 20 * 0.1 / 60, 0.06 * each);
  EXPECT_GT(test.both->zone, 0.98 * each);
}

TEST(CircularTest, BacklashAndFrictionShowWhereQuadrantsChange) {
  const CircularRequest circle = circle_of(30, 0.6);
  const double plain = run_circular_test(circle, mikron_with()).passes[0].circularity.zone;
  const double loose =
      run_circular_test(circle, mikron_with({"X.backlash=10", "Y.backlash=10"})).passes[0].circularity.zone;
  EXPECT_GT(loose, plain + 0.003);
  const double made_up_for =
      run_circular_test(circle, mikron_with({"X.backlash=10", "X.backlash_compensation=1", "Y.backlash=10",
                                             "Y.backlash_compensation=1"}))
          .passes[0]
          .circularity.zone;
  EXPECT_NEAR(made_up_for, plain, 1e-9);
  const Circularity spiked =
      run_circular_test(circle, mikron_with({"X.friction_spike=8", "X.friction_time=30"}))
          .passes[0]
          .circularity;
  // Held back against the new direction: outwards.
  EXPECT_NEAR(spiked.largest, 0.008 + units::to_m(0) + 0.000333, 0.0006);
}

TEST(CircularTest, PlanesMoveTheirOwnAxes) {
  CircularRequest request = circle_of(10, 3);
  const auto setup = mikron_with({"Z.kv=", "Z.velocity_feedforward=", "Z.velocity_lag="});
  EXPECT_NEAR(run_circular_test(request, setup).both->zone,
              run_circular_test(request, mikron_with()).both->zone, 1e-12);
  request.plane = CirclePlane::zx;  // Z follows exactly, X grows: an oval
  const CircularTest test = run_circular_test(request, setup);
  EXPECT_GT(test.both->zone, 0.01);
  EXPECT_EQ(parse_plane("ZX"), CirclePlane::zx);
  EXPECT_THAT([] { parse_plane("XZ"); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("XY, ZX, YZ")));
}

TEST(CircularTest, ProgramsOfEveryDialectAreReadAsTheSameCircles) {
  const std::vector<CircularRequest> requests{circle_of(30, 6), circle_of(12.5, 2, 5)};
  double path = 0;
  for (const DialectInfo& info : all_dialects()) {
    ReadOptions options;
    options.dialect = info.dialect;
    const std::string text = test_program(requests, info.dialect);
    const LoadedProgram loaded =
        load_program(std::make_shared<const SourceText>(SourceText("test", text)), nullptr, options);
    for (const Diagnostic& d : loaded.program->diagnostics) {
      EXPECT_EQ(d.severity == Severity::error, false)
          << info.id << ": line " << d.line << ": " << d.message.english() << '\n'
          << text;
    }
    double length = 0;
    for (const Segment& segment : loaded.toolpath->segments) {
      length += segment.rapid ? 0 : segment.length;
    }
    path = path == 0 ? length : path;
    EXPECT_NEAR(length, path, 1e-3) << info.id << '\n' << text;
    // Four circles, and quarter circles before and behind two of them.
    EXPECT_NEAR(path, 2 * full_turn * (30 + 12.5) + 2 * full_turn / 4 * 2 * 5 + 4 * std::hypot(7.5, 5), 1e-3)
        << info.id;
    EXPECT_EQ(loaded.toolpath->arcs.size(), 8u) << info.id << '\n' << text;
  }
}

TEST(CircularTest, WrongRequestsAreRefusedWithTheirBounds) {
  const auto message = [](CircularRequest request) {
    try {
      run_circular_test(request, mikron_with());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CircularRequest request = circle_of(30, 6);
  request.radius = 0;
  EXPECT_THAT(message(request),
              ::testing::HasSubstr("radius = 0 mm is out of bounds; it must be at least 0.001 mm"));
  request = circle_of(30, 0);
  EXPECT_THAT(message(request), ::testing::HasSubstr("feed = 0 mm/min is out of bounds"));
  request = circle_of(30, 6, 31);
  EXPECT_THAT(message(request), ::testing::HasSubstr("entry radius = 31 mm is out of bounds"));
  request = circle_of(30, 6);
  request.sweep = 7;
  EXPECT_THAT(message(request), ::testing::HasSubstr("at most 360"));
}

}  // namespace
}  // namespace feedscope
