#include "core/compressor/compressor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/units.h"
#include "tests/support/paths.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

using Points = std::vector<Vec3>;

Settings settings_within(double tolerance) {
  Settings settings;
  settings.set("contour_tolerance_mm", tolerance);
  settings.set("program_tolerance", "on");
  return settings;
}

struct Compressed {
  Toolpath path;
  std::vector<SmoothCurve> curves;
};

Compressed compress(const Points& points, double tolerance, const CompressorRule& rule) {
  Compressed result;
  result.path = testing::polyline(points, 50);
  const PathRules rules(result.path, settings_within(tolerance));
  CompressorSettings settings;
  settings.on = true;
  settings.rule = rule;
  result.curves = Compressor(result.path, rules, settings).compress(0, result.path.segments.size());
  return result;
}

Compressed compress(const Points& points, double tolerance) {
  return compress(points, tolerance, {20, units::from_deg(36), true});
}

/// Points of `at` for shares 0, 1/count, ... 1.
template <typename At>
Points sampled(int count, const At& at) {
  Points points;
  for (int i = 0; i <= count; ++i) {
    points.push_back(at(static_cast<double>(i) / count));
  }
  return points;
}

Vec3 on_circle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

double distance_from_line(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double share = std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (point - from - share * way).norm();
}

/// Many places of a curve in order.
Points places_of(const SmoothCurve& curve, int a_span) {
  Points places;
  for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
    const CourseSpan span(curve.knots[k], curve.knots[k + 1]);
    for (int i = 0; i < a_span; ++i) {
      places.push_back(span.at(span.length() * i / a_span).position);
    }
  }
  places.push_back(curve.knots.back().position);
  return places;
}

/// Largest distance of one broken line's points from another, in order: each is looked for around the place
/// of the one before.
double largest_distance(const Points& points, const Points& line) {
  double largest = 0;
  for (const Vec3& point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      nearest = std::min(nearest, distance_from_line(point, line[i], line[i + 1]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// The programmed points that a curve stands for, with both of its ends.
Points programmed_under(const Compressed& made, const SmoothCurve& curve) {
  Points points{curve.knots.front().position};
  for (std::size_t i = curve.run.first; i < curve.run.last; ++i) {
    points.push_back(made.path.segments[i].end);
  }
  points.push_back(curve.knots.back().position);
  return points;
}

/// Brute force: both ways, the curve by 24 places a span.
double deviation_of(const Compressed& made, const SmoothCurve& curve) {
  const Points curve_places = places_of(curve, 24);
  const Points programmed = programmed_under(made, curve);
  Points on_chords;
  for (std::size_t i = 0; i + 1 < programmed.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      on_chords.push_back(programmed[i] + k / 4.0 * (programmed[i + 1] - programmed[i]));
    }
  }
  return std::max(largest_distance(on_chords, curve_places), largest_distance(curve_places, programmed));
}

TEST(Compressor, ChordsOfACircleBecomeItsCurvatureWithinOnePercent) {
  for (const double radius : {1.0, 10.0, 100.0}) {
    SCOPED_TRACE(radius);
    const double chord_error = 0.002;
    const double step = 2 * std::acos(1 - chord_error / radius);
    const int count = static_cast<int>(std::ceil(std::numbers::pi / step));
    const Compressed made =
        compress(sampled(count, [&](double x) { return on_circle(radius, std::numbers::pi * x); }), 0.01);
    ASSERT_EQ(made.curves.size(), 1U);
    const SmoothCurve& curve = made.curves[0];
    EXPECT_LT(curve.knots.size() - 1, made.path.segments.size());
    // At the ends, which are free, the fit has points on one side only.
    const double margin = 0.25 * curve.knots.back().s;
    for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
      const CourseSpan span(curve.knots[k], curve.knots[k + 1]);
      for (const double x : {0.0, 0.25, 0.5, 0.75}) {
        const double s = curve.knots[k].s + x * span.length();
        if (s > margin && s < curve.knots.back().s - margin) {
          EXPECT_NEAR(span.by_share(x).d2.norm() * radius, 1, 0.01) << "at " << s << " mm";
        }
      }
    }
  }
}

TEST(Compressor, ChordsOfAHelixBecomeItsCurvatureWithinOnePercent) {
  const double radius = 5;
  const double pitch = 2;
  const double curvature = radius / (radius * radius + std::pow(pitch / (2 * std::numbers::pi), 2));
  const Compressed made = compress(sampled(240,
                                           [&](double x) {
                                             Vec3 point = on_circle(radius, 6 * std::numbers::pi * x);
                                             point.z() = 3 * pitch * x;
                                             return point;
                                           }),
                                   0.01);
  ASSERT_EQ(made.curves.size(), 1U);
  const SmoothCurve& curve = made.curves[0];
  for (const CourseKnot& knot : curve.knots) {
    if (knot.s > 8 && knot.s < curve.knots.back().s - 8) {
      EXPECT_NEAR(knot.curvature.norm(), curvature, 0.01 * curvature) << "at " << knot.s << " mm";
    }
  }
}

TEST(Compressor, StraightStaysLines) {
  EXPECT_TRUE(compress(sampled(100, [](double x) { return Vec3(30 * x, 40 * x, 0); }), 0.01).curves.empty());
}

TEST(Compressor, StraightWithinACurveStaysStraight) {
  // A quarter circle of chords, then 40 mm of short collinear blocks.
  Points points = sampled(60, [](double x) { return on_circle(10, std::numbers::pi / 2 * x); });
  for (int i = 1; i <= 80; ++i) {
    points.push_back({-0.5 * i, 10, 0});
  }
  const Compressed made = compress(points, 0.01);
  ASSERT_EQ(made.curves.size(), 1U);
  for (const CourseKnot& knot : made.curves[0].knots) {
    if (knot.position.x() < -15) {
      EXPECT_NEAR(knot.position.y(), 10, 1e-4);
      EXPECT_LT(knot.curvature.norm(), 1e-4);
    }
  }
}

TEST(Compressor, CornersAboveTheAngleStay) {
  const auto with_corner = [](double angle) {
    Points points;
    for (int i = -40; i <= 0; ++i) {
      points.push_back({0.05 * i, 0, 0});
    }
    for (int i = 1; i <= 40; ++i) {
      points.push_back({0.05 * i * std::cos(angle), 0.05 * i * std::sin(angle), 0});
    }
    return points;
  };
  const Compressed below = compress(with_corner(units::from_deg(35.9)), 0.01);
  ASSERT_EQ(below.curves.size(), 1U);
  EXPECT_LE(below.curves[0].run.first, 38U);
  EXPECT_TRUE(compress(with_corner(units::from_deg(36.1)), 0.01).curves.empty());
}

TEST(Compressor, LongLinesStayLines) {
  Points points{{-50, 0, 0}};
  for (int i = 0; i <= 60; ++i) {
    points.push_back(Vec3(0, 10, 0) + on_circle(10, std::numbers::pi / 2 * (i / 60.0 - 1)));
  }
  points.push_back({10, 60, 0});
  const Compressed made = compress(points, 0.01);
  ASSERT_EQ(made.curves.size(), 1U);
  EXPECT_EQ(made.curves[0].run.first, 0U);
  EXPECT_DOUBLE_EQ(made.curves[0].run.begin, 40);
  EXPECT_EQ(made.curves[0].run.last, made.path.segments.size() - 1);
  EXPECT_DOUBLE_EQ(made.curves[0].run.end, 10);
  EXPECT_EQ(made.curves[0].knots.front().position, Vec3(-10, 0, 0));
}

TEST(Compressor, KeepsTheToleranceBothWaysOnRandomDensePoints) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int run = 0; run < test::random_cases(16); ++run) {
    SCOPED_TRACE(run);
    const double tolerance = run % 2 == 0 ? 0.01 : 0.05;
    const double noise = run % 4 < 2 ? 0 : 0.4 * tolerance;
    const double a = 2 + unit(random);
    const double b = 5 + 3 * unit(random);
    double x = 0;
    Points points;
    for (int i = 0; i < 300; ++i) {
      points.push_back(
          {x, a * std::sin(x / b) + noise * unit(random), std::cos(x / a) + noise * unit(random)});
      x += 0.05 + 0.3 * std::pow(std::abs(unit(random)), 3);
    }
    const Compressed made = compress(points, tolerance);
    ASSERT_FALSE(made.curves.empty());
    for (const SmoothCurve& curve : made.curves) {
      EXPECT_LE(deviation_of(made, curve), tolerance);
      for (std::size_t k = 1; k + 1 < curve.knots.size(); ++k) {
        const CourseSpan before(curve.knots[k - 1], curve.knots[k]);
        const CourseSpan after(curve.knots[k], curve.knots[k + 1]);
        const CurvePoint end = before.at(before.length());
        const CurvePoint start = after.at(0);
        EXPECT_LT((end.position - start.position).norm(), 1e-9);
        EXPECT_LT((end.d1 - start.d1).norm(), 1e-9);
        EXPECT_LT((end.d2 - start.d2).norm(), 1e-6);
      }
    }
  }
}

/// A wave with an offset of digits, as CAM systems write it.
Points wave(int count) {
  return sampled(count, [&](double x) {
    const double s = 0.2 * count * x;
    return Vec3(s, std::round(3000 * std::sin(s / 4)) / 1000, std::round(1000 * std::cos(s / 7)) / 1000);
  });
}

TEST(Compressor, WhatComesAHundredBlocksLaterChangesNothing) {
  Points points = wave(600);
  const Compressed first = compress(points, 0.01);
  for (std::size_t i = 400; i < points.size(); ++i) {
    points[i].y() += 0.5 * std::sin(0.1 * static_cast<double>(i - 400));
  }
  const Compressed second = compress(points, 0.01);
  ASSERT_EQ(first.curves.size(), 1U);
  ASSERT_EQ(second.curves.size(), 1U);
  for (std::size_t k = 0; k < first.curves[0].knots.size(); ++k) {
    const double block = first.curves[0].knots[k].position.x() / 0.2;
    if (block > 300) {
      break;
    }
    // A spline passes on what it is told by less than half from border to border.
    const double allowed = block > 150 ? 2e-5 : 1e-9;
    EXPECT_LT((first.curves[0].knots[k].position - second.curves[0].knots[k].position).norm(), allowed) << k;
  }
}

TEST(Compressor, PointsAddedOnTheChordsChangeLittle) {
  const Points points = wave(300);
  Points more;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    more.push_back(points[i]);
    more.push_back(points[i] + 0.3 * (points[i + 1] - points[i]));
  }
  more.push_back(points.back());
  const Compressed first = compress(points, 0.01);
  const Compressed second = compress(more, 0.01);
  ASSERT_EQ(second.curves.size(), 1U);
  EXPECT_LT(largest_distance(places_of(second.curves[0], 8), places_of(first.curves[0], 64)), 0.003);
}

TEST(Compressor, RoundingOfThePointsChangesNothing) {
  const Points points = wave(300);
  Points moved = points;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (Vec3& point : moved) {
    point += 1e-9 * Vec3(unit(random), unit(random), unit(random));
  }
  const Compressed first = compress(points, 0.01);
  const Compressed second = compress(moved, 0.01);
  ASSERT_EQ(first.curves.size(), second.curves.size());
  ASSERT_EQ(first.curves[0].knots.size(), second.curves[0].knots.size());
  for (std::size_t k = 0; k < first.curves[0].knots.size(); ++k) {
    EXPECT_LT((first.curves[0].knots[k].position - second.curves[0].knots[k].position).norm(), 1e-7);
  }
}

TEST(Compressor, BadPointsFinishWithinTheTolerance) {
  const double tolerance = 0.01;
  const auto check = [&](const char* name, const Points& points) {
    SCOPED_TRACE(name);
    const Compressed made = compress(points, tolerance);
    for (const SmoothCurve& curve : made.curves) {
      EXPECT_LE(deviation_of(made, curve), tolerance);
    }
  };
  Points zigzag;
  for (int i = 0; i < 200; ++i) {
    zigzag.push_back({0.1 * i, i % 2 == 0 ? 0 : 0.012, 0});
  }
  check("zigzag at the tolerance", zigzag);
  Points tiny;
  for (int i = 0; i < 60; ++i) {
    tiny.push_back({3.0 * i, std::sin(0.3 * i), 0});
    tiny.push_back({3.0 * i + 1e-5, std::sin(0.3 * i) + 1e-5, 0});
  }
  check("blocks of 1e-5 mm between long ones", tiny);
  Points back = wave(100);
  for (int i = 99; i >= 0; --i) {
    back.push_back(back[static_cast<std::size_t>(i)]);
  }
  check("reversal", back);
}

TEST(Compressor, IsGivenUpWhenCancelled) {
  const Toolpath path = compress(sampled(200, [](double x) { return on_circle(50, x); }), 0.01).path;
  const PathRules rules(path, settings_within(0.01));
  Progress progress;
  progress.cancel();
  CompressorSettings settings;
  settings.on = true;
  settings.rule = {20, units::from_deg(36), true};
  EXPECT_THROW(Compressor(path, rules, settings).compress(0, path.segments.size(), &progress), Cancelled);
}

}  // namespace
}  // namespace feedscope
