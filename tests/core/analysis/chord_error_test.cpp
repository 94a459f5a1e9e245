#include "core/analysis/contour/chord_error.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run.h"
#include "tests/support/english.h"
#include "tests/support/folders.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A curve by its length [mm].
using Curve = std::function<Vec3(double)>;

Toolpath chords(const std::vector<Vec3>& points) {
  return testing::polyline(points, 50);
}

/// Largest distance of a curve from the chord between two places on it, by brute force.
double sagitta(const Curve& curve, double from, double to) {
  const Vec3 a = curve(from);
  const Vec3 along = (curve(to) - a).normalized();
  double largest = 0;
  for (int i = 1; i < 16; ++i) {
    const Vec3 way = curve(from + (to - from) * i / 16) - a;
    largest = std::max(largest, (way - way.dot(along) * along).norm());
  }
  return largest;
}

/// Points on a curve from 0 to `end`, each as far from the one before as `error` allows, at most `longest`.
std::vector<Vec3> cut(const Curve& curve, double end, double error, double longest) {
  std::vector<Vec3> points{curve(0)};
  for (double at = 0; at < end;) {
    double low = 0;
    double high = std::min(longest, end - at);
    if (sagitta(curve, at, at + high) > error) {
      for (int i = 0; i < 25; ++i) {
        const double middle = (low + high) / 2;
        (sagitta(curve, at, at + middle) > error ? high : low) = middle;
      }
    }
    at += high;
    points.push_back(curve(at));
  }
  return points;
}

Curve helix(double radius, double rise) {
  const double per_angle = std::hypot(radius, rise);
  return [=](double s) {
    const double angle = s / per_angle;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), rise * angle);
  };
}

/// Curvature growing from 0 as `rate` times the length, by quadrature.
Curve clothoid(double rate) {
  return [=](double s) {
    Vec3 at = Vec3::Zero();
    constexpr int steps = 60;
    for (int i = 0; i < steps; ++i) {
      const double middle = s * (i + 0.5) / steps;
      at += s / steps * Vec3(std::cos(rate * middle * middle / 2), std::sin(rate * middle * middle / 2), 0);
    }
    return at;
  };
}

void move_at_random(std::vector<Vec3>& points, double deviation) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, deviation);
  for (Vec3& point : points) {
    point += Vec3(noise(random), noise(random), noise(random));
  }
}

TEST(ChordError, OfACircleInEqualChordsIsExact) {
  for (const int count : {12, 64, 400}) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 3 * count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      points.emplace_back(20 * std::cos(angle), 20 * std::sin(angle), 0);
    }
    const auto error = chord_error_of(chords(points));
    ASSERT_TRUE(error) << count;
    const double exact = 20 * (1 - std::cos(std::numbers::pi / count));
    EXPECT_NEAR(error->value, exact, 1e-6 * exact) << count;
    EXPECT_EQ(error->chords, static_cast<std::size_t>(3 * count - 2));
  }
}

TEST(ChordError, OfCurvesCutToAChordErrorIsThatOne) {
  for (const double wanted : {0.002, 0.01, 0.05}) {
    for (const auto& [name, curve] : {std::pair("circle", helix(25, 0)), std::pair("helix", helix(10, 4)),
                                      std::pair("clothoid", clothoid(0.002))}) {
      const auto error = chord_error_of(chords(cut(curve, 90, wanted, 5)));
      ASSERT_TRUE(error) << name << " " << wanted;
      EXPECT_NEAR(error->value, wanted, 0.03 * wanted) << name;
    }
  }
}

TEST(ChordError, IsThatOfTheCurveWhereThePointsAreNoisy) {
  constexpr double wanted = 0.01;
  std::vector<Vec3> points = cut(helix(25, 0), 150, wanted, 5);
  move_at_random(points, wanted / 4);
  const auto error = chord_error_of(chords(points));
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->value, wanted, 0.1 * wanted);
}

TEST(ChordError, OfNoiseOnAStraightPathIsAnEighthOfItAtMost) {
  constexpr double deviation = 0.02;
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) {
    points.emplace_back(0.5 * i, 0, 0);
  }
  move_at_random(points, deviation);
  const auto error = chord_error_of(chords(points));
  ASSERT_TRUE(error);
  // In two directions across: a Rayleigh variable, of which 95 % lie below 2.45 deviations, and those that
  // alternate are no chords.
  EXPECT_LT(error->value, 2.45 * deviation / 4);
}

TEST(ChordError, DoesNotChangeWithPlaceDirectionAndTurnOfThePath) {
  std::vector<Vec3> points = cut(clothoid(0.003), 60, 0.004, 5);
  const auto error = chord_error_of(chords(points));
  ASSERT_TRUE(error);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& point : points) {
    point = turn * point + Vec3(100, -30, 7);
  }
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(chord_error_of(chords(points))->value, error->value, 1e-9);
}

TEST(ChordError, IsNotThatOfCornersAndStraightParts) {
  // Staircase, polygon of long sides, straight rows with a corner every 10 mm, a few chords only.
  std::vector<Vec3> stairs;
  std::vector<Vec3> rows;
  for (int i = 0; i < 300; ++i) {
    stairs.emplace_back(i / 2, (i + 1) / 2, 0);
    rows.emplace_back(i, (i / 10) % 2 == 0 ? 0.3 * (i % 10) : 0.3 * (10 - i % 10), 0);
  }
  EXPECT_FALSE(chord_error_of(chords(stairs)));
  EXPECT_FALSE(chord_error_of(chords(rows)));
  std::vector<Vec3> few = cut(helix(25, 0), 10, 0.002, 5);
  EXPECT_FALSE(chord_error_of(chords(few)));
  EXPECT_FALSE(chord_error_of(Toolpath()));
}

TEST(ChordError, OfTheFreeFormSurfaceIsThatOfItsGenerator) {
  const LoadedProgram program =
      load_program(std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / "resources/programs/freeform_finish.nc");
  ASSERT_TRUE(program.chord_error);
  EXPECT_LE(program.chord_error->value, 0.0021);
  EXPECT_GE(program.chord_error->value, 0.0015);
}

std::string circle_program(const std::string& modes) {
  std::string text = "G21 G90 G17 " + modes + "\nG0 X20 Y0\nG1 F3000\n";
  for (int i = 1; i <= 200; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100;
    text += fmt::format("X{:.6f} Y{:.6f}\n", 20 * std::cos(angle), 20 * std::sin(angle));
  }
  return text + "M30\n";
}

LoadedProgram loaded(const std::string& text) {
  return load_program(std::make_shared<const SourceText>("circle.nc", text));
}

TEST(ChordError, IsAMessageOfTheProgramWithHeidenhainsAdvice) {
  const LoadedProgram program = loaded(circle_program(""));
  const auto& messages = program.program->diagnostics;
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].code, "chord-error");
  EXPECT_EQ(messages[0].severity, Severity::info);
  EXPECT_THAT(messages[0].message.english(), HasSubstr("0.0099 mm"));
  EXPECT_THAT(messages[0].hint.english(), HasSubstr("Heidenhain"));
  EXPECT_THAT(messages[0].hint.english(), HasSubstr("0.011 to 0.02 mm"));
  const LoadedProgram advised = loaded(circle_program("G64 P0.015"));
  ASSERT_EQ(advised.program->diagnostics.size(), 1U);
  EXPECT_EQ(advised.program->diagnostics[0].hint.english(), "");
  EXPECT_TRUE(loaded("G21 G90\nG0 X0\nG1 X10 F500\nG1 Y10\nM30\n").program->diagnostics.empty());
}

/// Tighter than advised: the tool follows the chords. Wider ones are usual.
TEST(ChordError, IsRemarkedOfRunsWhoseToleranceIsTighterThanAdvised) {
  const LoadedProgram program = loaded(circle_program(""));
  const auto said = [&](const char* model, std::optional<double> tolerance, UnitSystem units) {
    const auto run = simulate_run(program, make_setup({"spinner-mvc850", model, tolerance}));
    return in_english(texts_about(remarks(run, units), {Remark::About::time}));
  };
  EXPECT_THAT(
      said("essid", 0.005, UnitSystem::metric),
      ElementsAre("The contour tolerance of 0.005 mm is 51 % of the estimated chord error of the short "
                  "lines (0.0099 mm); Heidenhain advises 110 to 200 %."));
  EXPECT_THAT(said("essid", 0.005, UnitSystem::inch), ElementsAre(HasSubstr("0.0002 in is 51 %")));
  EXPECT_THAT(said("essid", 0.015, UnitSystem::metric), IsEmpty());
  EXPECT_THAT(said("essid", 0.05, UnitSystem::metric), IsEmpty());
  EXPECT_THAT(said("cam", {}, UnitSystem::metric), IsEmpty());
}

}  // namespace
}  // namespace feedscope
