#include "core/program/path/path_extents.h"
#include "core/base/units.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/toolpath/toolpath.h"
#include "tests/core/program/random_path.h"
#include "tests/core/program/read_text.h"

namespace feedscope {
namespace {

using units::pi;

/// `exact` holds all of `sampled`, and not more than what lies between two samples beyond it.
void expect_tight(const Bounds& exact, const Bounds& sampled, double between) {
  EXPECT_TRUE(((sampled.min - exact.min).array() > -1e-9).all()) << sampled.min << "\n" << exact.min;
  EXPECT_TRUE(((exact.max - sampled.max).array() > -1e-9).all()) << sampled.max << "\n" << exact.max;
  EXPECT_TRUE(((sampled.min - exact.min).array() < between).all()) << sampled.min << "\n" << exact.min;
  EXPECT_TRUE(((exact.max - sampled.max).array() < between).all()) << sampled.max << "\n" << exact.max;
}

TEST(ArcExtent, HoldsAllPointsOfAnyHelixTightly) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 500; ++round) {
    const Vec3 axis = Vec3(number(random), number(random), number(random)).normalized();
    const Vec3 x = axis.cross(Vec3(number(random), number(random), number(random))).normalized();
    const Vec3 center(number(random), 0, number(random));
    const double radius = 2 + number(random);
    const double sweep = (1.001 + number(random)) * (round % 2 == 0 ? 0.5 : 3) * pi;
    const double rise = number(random);
    const auto place = [&](double a) -> Vec3 {
      return center + radius * (std::cos(a) * x + std::sin(a) * axis.cross(x)) + rise * a * axis;
    };
    const ArcWords words{center, axis, std::floor(sweep / (2 * pi))};
    Bounds exact;
    if (round % 3 == 0) {
      exact.add(place(sweep / 2));  // as an extent that has begun
    }
    add_arc(exact, place(0), place(sweep), words);
    Bounds sampled;
    for (int i = 0; i <= 3000; ++i) {
      sampled.add(place(sweep * i / 3000));
    }
    expect_tight(exact, sampled, 1e-3);
    ASSERT_FALSE(HasFailure()) << "round " << round;
    const Bounds before = exact;
    add_arc(exact, place(0), place(sweep), words);
    EXPECT_TRUE(before.min == exact.min && before.max == exact.max) << "nothing new comes in";
  }
}

std::string written(const std::vector<Move>& path) {
  std::string text = "G21 F600\n";
  Vec3 position = Vec3::Zero();
  for (const Move& move : path) {
    const std::string to =
        fmt::format("X{:.9f} Y{:.9f} Z{:.9f}", move.target.x(), move.target.y(), move.target.z());
    if (move.motion == Motion::arc) {
      const Vec3 offset = move.center - position;
      text += fmt::format("G{} G{} {} I{:.9f} J{:.9f} K{:.9f}\n", 19 - move.axis, move.ccw ? 3 : 2, to,
                          offset.x(), offset.y(), offset.z());
    } else {
      text += fmt::format("G{} {}\n", move.motion == Motion::rapid ? 0 : 1, to);
    }
    position = move.target;
  }
  return text;
}

/// What the path reaches, from `samples` places of each segment.
struct Reached {
  Bounds all;
  Bounds cutting;
  Bounds rapid;
};

Reached reached(const Toolpath& path, int samples) {
  Reached found;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    const Vec3& start = path.start_of(i);
    for (int j = 0; j <= samples; ++j) {
      const double share = static_cast<double>(j) / samples;
      const Vec3 place = segment.kind == SegmentKind::arc
                             ? path.arc_of(segment).at(share * segment.length).position
                             : Vec3(start + share * (segment.end - start));
      found.all.add(place);
      (segment.rapid ? found.rapid : found.cutting).add(place);
    }
  }
  return found;
}

TEST(PathExtents, AreThoseOfTheSampledPathCuttingAndRapidApart) {
  std::mt19937 random(5);
  constexpr double longest_arc = 2 * pi * 180;
  constexpr int samples = 400;
  for (int round = 0; round < 100; ++round) {
    std::vector<Move> path = random_path(random);
    // The assumed start is no part of a path that begins with a rapid, so that it may not begin one here.
    path.front() = {Motion::line, Vec3(1, 2, 3), {}, 2, true, 0};
    const std::string text = written(path);
    const ReadProgram program = read_text(text);
    const Reached found = reached(build_toolpath(program), samples);
    const double between = longest_arc / samples * 0.1;
    expect_tight(program.bounds, found.all, between);
    expect_tight(program.cutting_bounds, found.cutting, between);
    expect_tight(program.rapid_bounds, found.rapid, between);
    ASSERT_FALSE(HasFailure()) << "round " << round << "\n" << text;
  }
}

TEST(PathExtents, HoldFullCirclesThatEndWhereTheyStart) {
  std::string text = "G0 X50 Y0 Z5\nG1 Z0 F500\n";
  for (int i = 0; i < 200; ++i) {
    text += "G2 I-50\n";
  }
  const ReadProgram program = read_text(text + "G0 Z80\n");
  EXPECT_LT((program.bounds.min - Vec3(-50, -50, 0)).norm(), 1e-12);
  EXPECT_LT((program.bounds.max - Vec3(50, 50, 80)).norm(), 1e-12);
  EXPECT_LT((program.cutting_bounds.max - Vec3(50, 50, 5)).norm(), 1e-12);
  EXPECT_LT((program.rapid_bounds.min - Vec3(50, 0, 0)).norm(), 1e-12);
}

TEST(PathExtents, LeaveOutTheAssumedStart) {
  const ReadProgram rapid = read_text("G0 Z50\nG0 X10 Y20\nZ1\nG1 Z-5 F100\nX30\n");
  EXPECT_EQ(rapid.rapid_bounds.min, Vec3(10, 20, 1));
  EXPECT_EQ(rapid.rapid_bounds.max, Vec3(10, 20, 50));
  EXPECT_EQ(rapid.cutting_bounds.min, Vec3(10, 20, -5));
  EXPECT_EQ(rapid.cutting_bounds.max, Vec3(30, 20, 1));
  EXPECT_TRUE(read_text("G1 X10 F100\n").rapid_bounds.empty());
}

}  // namespace
}  // namespace feedscope
