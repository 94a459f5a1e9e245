#include "core/program/path/curve_arcs.h"
#include "core/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/program/path/b_spline.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

using units::pi;

using Bezier = std::array<Vec3, 4>;

ParametricCurve curve_of(const Bezier& p) {
  return [p](double t) -> CurvePlace {
    const double s = 1 - t;
    return {s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3],
            3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]))};
  };
}

/// A piece with its start, to ask for places on it.
struct Placed {
  Vec3 start;
  CurvePiece piece;

  double sweep() const { return piece.length / (start - piece.center).norm(); }
  Vec3 at(double share) const {
    return piece.is_arc
               ? Vec3(piece.center + Eigen::AngleAxisd(share * sweep(), piece.axis) * (start - piece.center))
               : Vec3(start + share * (piece.end - start));
  }
  Vec3 tangent(const Vec3& point) const {
    return piece.is_arc ? Vec3(piece.axis.cross(point - piece.center).normalized())
                        : Vec3((piece.end - start).normalized());
  }
  double distance(const Vec3& point) const {
    double nearest = std::min((point - start).norm(), (point - piece.end).norm());
    if (!piece.is_arc) {
      const Vec3 way = piece.end - start;
      const double share = std::clamp((point - start).dot(way) / way.squaredNorm(), 0.0, 1.0);
      return std::min(nearest, (start + share * way - point).norm());
    }
    const Vec3 x = (start - piece.center).normalized();
    const Vec3 q = point - piece.center;
    const double angle = std::atan2(q.dot(piece.axis.cross(x)), q.dot(x));
    return angle >= 0 && angle <= sweep() ? (at(angle / sweep()) - point).norm() : nearest;
  }
};

std::vector<Placed> placed(const CurvePieces& pieces, Vec3 start) {
  std::vector<Placed> all;
  for (const CurvePiece& piece : pieces.pieces) {
    all.push_back({start, piece});
    start = piece.end;
  }
  return all;
}

double turn_at(const std::vector<Placed>& pieces, std::size_t i) {
  const Vec3 in = pieces[i - 1].tangent(pieces[i].start);
  const Vec3 out = pieces[i].tangent(pieces[i].start);
  return 2 * std::atan2((out - in).norm(), (out + in).norm());
}

bool is_speck(const CurvePiece& piece) {
  return !piece.is_arc && piece.length <= curve_tolerance;
}

/// The tips of what is almost a cusp left out.
double sharpest_turn(const std::vector<Placed>& pieces) {
  double sharpest = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (!is_speck(pieces[i - 1].piece) && !is_speck(pieces[i].piece)) {
      sharpest = std::max(sharpest, turn_at(pieces, i));
    }
  }
  return sharpest;
}

/// Greatest distance of places on the curve from the pieces, which are looked through along with it.
double greatest_distance(const std::vector<Placed>& pieces, const ParametricCurve& curve, double to) {
  constexpr int looks = 4000;
  constexpr std::size_t onwards = 4;
  double greatest = 0;
  std::size_t near = 0;
  for (int i = 0; i <= looks; ++i) {
    const Vec3 point = curve(to * i / looks).point;
    double nearest = 1e9;
    std::size_t found = near;
    const auto look = [&](std::size_t from, std::size_t end) {
      for (std::size_t k = from; k < std::min(end, pieces.size()); ++k) {
        const double distance = pieces[k].distance(point);
        found = distance < nearest ? k : found;
        nearest = std::min(nearest, distance);
      }
    };
    look(near > 0 ? near - 1 : 0, near + onwards);
    if (nearest > curve_tolerance) {
      look(0, pieces.size());
    }
    near = found;
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

TEST(CurveArcs, AQuarterCircleIsTwoArcsOfItsRadius) {
  const std::vector<Eigen::Vector4d> points{weighted({10, 0, 0}, 1), weighted({10, 10, 0}, std::sqrt(0.5)),
                                            weighted({0, 10, 0}, 1)};
  const std::vector<double> knots = clamped_knots(3, 2);
  const CurvePieces fitted =
      arcs_of_curve([&](double u) { return b_spline_place(points, knots, 2, 2, u); }, 0, 1);
  ASSERT_EQ(fitted.pieces.size(), 2U);
  for (const CurvePiece& piece : fitted.pieces) {
    EXPECT_TRUE(piece.is_arc);
    EXPECT_NEAR(piece.center.norm(), 0, 1e-12);
    EXPECT_NEAR(piece.axis.z(), 1, 1e-12);
    EXPECT_NEAR(piece.length, 10 * pi / 4, 1e-12);
  }
  EXPECT_NEAR(fitted.length, 5 * pi, 1e-12);
  EXPECT_NEAR((fitted.end_direction - Vec3(-1, 0, 0)).norm(), 0, 1e-12);
}

TEST(CurveArcs, TheJointOfABiarcIsThatOfEqualTangentLengths) {
  // t1.t2 = 0, v = (4, 2): d^2 + 6 d / 1 - 10 = 0 of v.v - 2 d v.t - 2 d^2 (1 - t1.t2) = 0.
  const Bezier p{Vec3(0, 0, 0), Vec3(1e-4, 0, 0), Vec3(4e-4, 1e-4, 0), Vec3(4e-4, 2e-4, 0)};
  const CurvePieces fitted = arcs_of_curve(curve_of(p), 0, 1);
  ASSERT_EQ(fitted.pieces.size(), 2U);
  const double d = (-6 + std::sqrt(36 + 40)) / 2 * 1e-4;
  const Vec3 joint((d + 4e-4) / 2, (2e-4 - d) / 2, 0);
  EXPECT_NEAR((fitted.pieces[0].end - joint).norm(), 0, 1e-16);
  EXPECT_EQ(fitted.pieces[1].end, p[3]);
}

TEST(CurveArcs, AStraightCurveIsOneLine) {
  const CurvePieces fitted =
      arcs_of_curve(curve_of({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(7, 7, 7), Vec3(9, 9, 9)}), 0, 1);
  ASSERT_EQ(fitted.pieces.size(), 1U);
  EXPECT_FALSE(fitted.pieces[0].is_arc);
  EXPECT_NEAR(fitted.length, std::sqrt(243), 1e-12);
}

TEST(CurveArcs, EndsWhereTheSlopeVanishesKeepTheirDirections) {
  const Vec3 start(0, 0, 0);
  const Vec3 end(30, 10, 5);
  const ParametricCurve curve = curve_of({start, start, Vec3(20, -10, 0), end});
  const CurvePieces fitted = arcs_of_curve(curve, 0, 1);
  const std::vector<Placed> pieces = placed(fitted, start);
  EXPECT_LT(pieces.size(), 100U);
  EXPECT_LT(sharpest_turn(pieces), 1e-6);
  EXPECT_LE(greatest_distance(pieces, curve, 1), curve_tolerance);
  const Vec3 leaves = Vec3(20, -10, 0).normalized();
  EXPECT_NEAR((pieces.front().tangent(start) - leaves).norm(), 0, 1e-5);
}

TEST(CurveArcs, ACuspAtACutIsMetFromBothSides) {
  const auto curve = [](double t) -> CurvePlace {
    const double u = 2 * t - 1;
    return {{10 * u * u, 10 * u * u * u, 0}, {40 * u, 60 * u * u, 0}};
  };
  const std::vector<Placed> pieces = placed(arcs_of_curve(curve, 0, 1), curve(0).point);
  int reversals = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double turn = turn_at(pieces, i);
    if (turn > 1e-5) {
      EXPECT_NEAR(turn, pi, 1e-4);
      EXPECT_NEAR(pieces[i].start.norm(), 0, 1e-12);
      ++reversals;
    }
  }
  EXPECT_EQ(reversals, 1);
  EXPECT_LE(greatest_distance(pieces, curve, 1), curve_tolerance);
}

TEST(CurveArcs, ACuspBetweenCutsAndAWayBackOnALineEnd) {
  const auto cusp = [](double t) -> CurvePlace {
    const double u = t - 1 / pi;
    return {{40 * u * u, 80 * u * u * u, 9 * u * u}, {80 * u, 240 * u * u, 18 * u}};
  };
  const std::vector<Placed> pieces = placed(arcs_of_curve(cusp, 0, 1), cusp(0).point);
  EXPECT_LT(pieces.size(), 150U);
  EXPECT_LE(greatest_distance(pieces, cusp, 1), curve_tolerance);

  const ParametricCurve back = curve_of({Vec3(0, 0, 0), Vec3(50, 0, 0), Vec3(60, 0, 0), Vec3(30, 0, 0)});
  const std::vector<Placed> line = placed(arcs_of_curve(back, 0, 1), Vec3::Zero());
  EXPECT_LT(line.size(), 60U);
  EXPECT_LE(greatest_distance(line, back, 1), curve_tolerance);
}

TEST(CurveArcs, PointsThatCoincideEnd) {
  const Vec3 p(3, 4, 5);
  const CurvePieces fitted = arcs_of_curve(curve_of({p, p, p, p}), 0, 1);
  ASSERT_EQ(fitted.pieces.size(), 1U);
  EXPECT_EQ(fitted.pieces[0].end, p);
  EXPECT_EQ(fitted.length, 0);
  EXPECT_TRUE(fitted.end_direction.isZero());
}

TEST(CurveArcs, TheNumberOfArcsGrowsWithTheThirdRootOfTheSize) {
  const auto count = [](double size) {
    const Bezier p{Vec3(0, 0, 0), Vec3(size, size, 0), Vec3(2 * size, -size, size), Vec3(3 * size, 0, 0)};
    return static_cast<double>(arcs_of_curve(curve_of(p), 0, 1).pieces.size());
  };
  EXPECT_NEAR(count(512 * 8) / count(8), 8, 2.5);
}

TEST(CurveArcs, RandomCurvesInSpaceAreMetWithOneTangent) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::ptrdiff_t specks = 0;
  for (int round = 0; round < test::random_cases(200); ++round) {
    Bezier p;
    const double size = std::pow(10, 1 + unit(random));
    for (Vec3& point : p) {
      point = size * Vec3(unit(random), unit(random), round % 3 == 0 ? 0 : unit(random));
    }
    const ParametricCurve curve = curve_of(p);
    const CurvePieces fitted = arcs_of_curve(curve, 0, 1);
    const std::vector<Placed> pieces = placed(fitted, p[0]);
    ASSERT_LT(pieces.size(), 400U) << "round " << round;
    ASSERT_LE(greatest_distance(pieces, curve, 1), curve_tolerance) << "round " << round;
    ASSERT_LT(sharpest_turn(pieces), 1e-5) << "round " << round;
    ASSERT_EQ(pieces.back().piece.end, p[3]);
    specks += std::ranges::count_if(fitted.pieces, is_speck);
    for (const Placed& piece : pieces) {
      if (piece.piece.is_arc) {
        const double radius = (piece.start - piece.piece.center).norm();
        ASSERT_NEAR((piece.piece.end - piece.piece.center).norm(), radius, 1e-9 + 1e-15 * radius);
        ASSERT_NEAR(piece.piece.axis.dot(piece.piece.end - piece.start), 0, 1e-9);
        ASSERT_LE(piece.sweep(), pi / 2);
      }
    }
  }
  EXPECT_LE(specks, 4);
}

TEST(CurveArcs, RandomRationalCurvesOfAllDegreesStayClose) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < test::random_cases(200); ++round) {
    const std::size_t degree = 1 + random() % max_spline_degree;
    const std::size_t count = degree + 1 + random() % 4;
    std::vector<Eigen::Vector4d> points;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 place = 30 * Vec3(unit(random), unit(random), unit(random));
      points.push_back(weighted(place, std::pow(10, 2 * unit(random))));
    }
    const std::vector<double> knots = clamped_knots(count, degree);
    for (std::size_t span = degree; span < count; ++span) {
      const auto curve = [&](double u) {
        return b_spline_place(points, knots, degree, span, knots[span] + u);
      };
      const double h = 1e-6;
      const Vec3 slope = (curve(0.5 + h).point - curve(0.5 - h).point) / (2 * h);
      ASSERT_NEAR((curve(0.5).slope - slope).norm(), 0, 1e-5 * (1 + slope.norm()));
      const std::vector<Placed> pieces = placed(arcs_of_curve(curve, 0, 1), curve(0).point);
      ASSERT_LE(greatest_distance(pieces, curve, 1), curve_tolerance) << "round " << round;
      ASSERT_LT(sharpest_turn(pieces), 1e-5) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace feedscope
