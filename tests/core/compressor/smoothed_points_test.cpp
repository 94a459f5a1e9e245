#include "core/compressor/smoothed_points.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/analysis/run/run.h"
#include "core/analysis/run/run_stages.h"

namespace feedscope {
namespace {

constexpr double step = 0.2;  // mm between points

/// A wave of `count` points, `noise` [mm] off it at random, behind lines of words.
std::string noisy_wave(double noise, int count = 300, const std::string& words = "G90 G94") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-noise, noise);
  std::string text = words + "\nG0 X0 Y0\nG1 F6000\n";
  for (int i = 1; i <= count; ++i) {
    text += fmt::format("X={:.12f} Y={:.12f}\n", step * i, 3 * std::sin(step * i / 3) + off(random));
  }
  return text + "M30\n";
}

LoadedProgram loaded(const std::string& text) {
  return load_program(std::make_shared<const SourceText>("dense.mpf", text), nullptr,
                      {.dialect = Dialect::sinumerik});
}

Setup ward(double tolerance, std::vector<std::string> assignments) {
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  request.model = "ward";
  request.assignments = std::move(assignments);
  Setup setup = make_setup(request);
  set_tolerance(setup, tolerance);
  return setup;
}

double time_of(const std::string& text, std::vector<std::string> assignments) {
  return simulate_motion(loaded(text), ward(0.01, std::move(assignments))).trajectory->duration();
}

/// Sum of direction changes between points [rad].
double whole_turn(const Toolpath& path, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i + 1 < last; ++i) {
    sum += turn_angle(path.tangent_at_end(i), path.tangent_at_start(i + 1));
  }
  return sum;
}

struct MovedPoints {
  LoadedProgram program;
  Toolpath commanded;
  SmoothCurve curve;
  bool moved = false;
};

MovedPoints moved_points(const std::string& text, double tolerance) {
  MovedPoints made;
  made.program = loaded(text);
  const Toolpath& programmed = *made.program.toolpath;
  made.commanded = programmed;
  const Setup setup = ward(tolerance, {"compressor=on"});
  const PathRules rules(programmed, setup.settings);
  Compressor compressor(programmed, rules, CompressorSettings(setup.settings));
  const auto curves = compressor.compress(1, programmed.segments.size());
  EXPECT_EQ(curves.size(), 1U);
  made.curve = curves.front();
  made.moved = move_points(made.curve, made.commanded);
  return made;
}

TEST(SmoothedPoints, LieOnTheCurveInTheirOrderWithinTheTolerance) {
  for (const double tolerance : {0.002, 0.01, 0.05}) {
    const MovedPoints made = moved_points(noisy_wave(tolerance / 4), tolerance);
    ASSERT_TRUE(made.moved);
    const Toolpath& programmed = *made.program.toolpath;
    std::vector<CurvePoint> places;  // of the curve, 5 um apart
    for (double s = 0; s < made.curve.knots.back().s; s += 0.005) {
      places.push_back(course_at(made.curve.knots, s));
    }
    std::size_t from = 0;
    for (std::size_t i = made.curve.run.first; i < made.curve.run.last; ++i) {
      const Vec3& point = made.commanded.segments[i].end;
      EXPECT_LE((point - programmed.segments[i].end).norm(), tolerance);
      std::size_t nearest = from;
      for (std::size_t k = from; k < std::min(places.size(), from + 200); ++k) {
        if ((places[k].position - point).norm() < (places[nearest].position - point).norm()) {
          nearest = k;
        }
      }
      const Vec3 off = point - places[nearest].position;
      EXPECT_LT((off - off.dot(places[nearest].d1) * places[nearest].d1).norm(), 1e-5);
      EXPECT_GT(nearest, from);
      from = nearest;
    }
  }
}

TEST(SmoothedPoints, LeaveEndsAndKindsAndCarryTrueLengths) {
  const MovedPoints made = moved_points(noisy_wave(0.002), 0.01);
  const Toolpath& programmed = *made.program.toolpath;
  ASSERT_EQ(made.commanded.segments.size(), programmed.segments.size());
  EXPECT_EQ(made.commanded.segments.back().end, programmed.segments.back().end);
  for (std::size_t i = 0; i < programmed.segments.size(); ++i) {
    const Segment& segment = made.commanded.segments[i];
    EXPECT_NEAR(segment.length, (segment.end - made.commanded.start_of(i)).norm(), 1e-12);
    EXPECT_EQ(segment.line, programmed.segments[i].line);
    EXPECT_EQ(segment.feed, programmed.segments[i].feed);
  }
}

TEST(SmoothedPoints, NoiseOfPointsNoLongerTurnsThePath) {
  const MovedPoints made = moved_points(noisy_wave(0.02), 0.05);
  const std::size_t first = made.curve.run.first;
  const std::size_t last = made.curve.run.last;
  const double smooth = whole_turn(*moved_points(noisy_wave(0), 0.05).program.toolpath, first, last);
  EXPECT_GT(whole_turn(*made.program.toolpath, first, last), 1.5 * smooth);
  EXPECT_LT(whole_turn(made.commanded, first, last), 1.1 * smooth);
}

TEST(SmoothedPoints, StayWhereTheToleranceLeavesThemNoPlaceOfTheirOwn) {
  MovedPoints made = moved_points(noisy_wave(0.002), 0.01);
  made.commanded = *made.program.toolpath;
  made.curve.tolerance = 1e-6;
  EXPECT_FALSE(move_points(made.curve, made.commanded));
  for (std::size_t i = 0; i < made.commanded.segments.size(); ++i) {
    EXPECT_EQ(made.commanded.segments[i].end, made.program.toolpath->segments[i].end);
  }
}

TEST(WardWithCompressor, IsOffAtFirstAndFollowsTheProgramWhereItIsToldTo) {
  const std::string plain = noisy_wave(0.002);
  const std::string asks = noisy_wave(0.002, 300, "G90 G94 COMPCAD");
  const double off = time_of(plain, {"compressor=off"});
  const double on = time_of(plain, {"compressor=on"});
  EXPECT_EQ(time_of(plain, {}), off);
  EXPECT_EQ(time_of(asks, {}), off);
  EXPECT_NE(on, off);
  EXPECT_NEAR(on, off, 0.1 * off);
  EXPECT_EQ(time_of(plain, {"compressor=program"}), off);
  EXPECT_EQ(time_of(asks, {"compressor=program"}), on);
}

TEST(WardWithCompressor, KeepsTheToleranceAtProgrammedPoints) {
  for (const double tolerance : {0.002, 0.01, 0.05}) {
    const feedscope::Run run = simulate_motion(loaded(noisy_wave(0.003)), ward(tolerance, {"compressor=on"}));
    for (std::size_t i = 0; i < run.trajectory->blend_count(); ++i) {
      const BlendRecord corner = run.trajectory->blend(i);
      EXPECT_LE(corner.epsilon, tolerance * (1 + 2e-6));
    }
    const auto& segments = run.trajectory->path().programmed()->segments;
    std::size_t piece = 0;
    double from = 0;
    for (std::size_t i = 1; i + 1 < segments.size();
         i += 7) {  // brute force, without what the model measures
      double nearest = 1e9;
      for (double t = from; t < run.trajectory->duration(); t += 2e-5) {
        const double distance = (run.trajectory->state(t).position - segments[i].end).norm();
        if (distance < nearest) {
          nearest = distance;
          from = t;
        } else if (distance > nearest + 2 * step) {
          break;
        }
      }
      EXPECT_LE(nearest, tolerance + 1e-4) << i;
      ++piece;
    }
    EXPECT_GT(piece, 40U);
  }
}

TEST(WardWithCompressor, NoiseOfRoundingAndStandstillsChangeNothing) {
  const double time = time_of(noisy_wave(0), {"compressor=on"});
  EXPECT_NEAR(time_of(noisy_wave(1e-9), {"compressor=on"}), time, 1e-5 * time);
  const std::string whole = noisy_wave(0.001);
  const std::size_t middle = whole.find("X=30.2000");
  const std::string first = whole.substr(0, middle);
  const std::string last_point = first.substr(first.rfind("X="), first.size() - first.rfind("X=") - 1);
  const double split = time_of(first + "G4 F0.1\nG1 F6000\n" + whole.substr(middle), {"compressor=on"}) - 0.1;
  const double apart =
      time_of(first + "M30\n", {"compressor=on"}) +
      time_of("G0 " + last_point + "\nG1 F6000\n" + whole.substr(middle), {"compressor=on"}) -
      time_of("G0 " + last_point + "\nM30\n", {"compressor=on"});
  EXPECT_NEAR(split, apart, 1e-9 * split);
}

}  // namespace
}  // namespace feedscope
