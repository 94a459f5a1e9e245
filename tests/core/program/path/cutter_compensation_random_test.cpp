#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/base/units.h"
#include "tests/core/program/path/line_writer.h"

namespace feedscope {
namespace {

using units::pi;

/// One element of a random contour; `center` of arcs.
struct Element {
  Vec3 start, end, center;
  int turn = 0;  ///< 1, -1: arcs

  double distance(const Vec3& p) const {
    if (turn != 0) {
      return std::abs((p - center).norm() - (start - center).norm());
    }
    const Vec3 along = (end - start).normalized();
    return (p - start).cross(along).norm();
  }
};

std::vector<Element> random_contour(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Element> contour;
  Vec3 at = Vec3::Zero();
  double heading = 2 * pi * unit(random);
  for (int i = 0; i < 12; ++i) {
    const Vec3 along(std::cos(heading), std::sin(heading), 0);
    Element element{at, at + (5 + 25 * unit(random)) * along, Vec3::Zero(), 0};
    if (i > 0 && unit(random) < 0.5) {
      element.turn = unit(random) < 0.5 ? 1 : -1;
      const Vec3 inward = (2 + 18 * unit(random)) * element.turn * Vec3::UnitZ().cross(along);
      const double sweep = 0.2 + 5 * unit(random);
      element.center = at + inward;
      element.end = element.center - std::cos(sweep) * inward -
                    std::sin(sweep) * element.turn * Vec3::UnitZ().cross(inward);
      heading += element.turn * sweep;
    }
    contour.push_back(element);
    at = element.end;
    heading += unit(random) < 0.4 ? 0 : (unit(random) - 0.5) * 1.8 * pi;
  }
  return contour;
}

ReadProgram compensated(const std::vector<Element>& contour, ToolSide side, double radius,
                        OutsideCorner corner) {
  LineWriter writer(corner);
  writer.on(side, radius);
  for (const Element& element : contour) {
    if (element.turn == 0) {
      writer.line(element.end);
    } else {
      writer.arc(element.end, element.center, element.turn * Vec3::UnitZ());
    }
  }
  return writer.finish();
}

Vec3 middle_of(const Vec3& start, const MotionBlock& block, const ReadProgram& program) {
  if (block.motion != Motion::arc) {
    return (start + block.target) / 2;
  }
  const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
  const Vec3 from = start - arc.center;
  const Vec3 to = block.target - arc.center;
  double sweep = std::atan2(arc.axis.dot(from.cross(to)), from.dot(to));
  sweep += sweep < 0 ? 2 * pi : 0;
  return arc.center + Eigen::AngleAxisd(sweep / 2, arc.axis) * from;
}

TEST(CutterCompensation, KeepsItsDistanceWhereverNoGougeIsDiagnosed) {
  std::mt19937 random(2026);
  constexpr double rounding = 1e-6;
  int sound = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::vector<Element> contour = random_contour(random);
    const double radius = 0.5 + 3 * static_cast<double>(random() % 1000) / 1000;
    const OutsideCorner corner = round % 2 == 0 ? OutsideCorner::arc : OutsideCorner::lines;
    const ToolSide side = round % 4 < 2 ? ToolSide::left : ToolSide::right;
    const ReadProgram program = compensated(contour, side, radius, corner);
    std::vector<bool> gouged(contour.size() + 2, false);
    for (const Diagnostic& diagnostic : program.diagnostics) {
      for (std::size_t line = diagnostic.line; line < std::min(diagnostic.line + 2UL, gouged.size());
           ++line) {
        gouged[line] = true;
      }
    }
    Vec3 start = Vec3::Zero();
    for (const MotionBlock& block : program.motions) {
      const Element& element = contour.at(block.line - 1);
      const Vec3 middle = middle_of(start, block, program);
      if (block.line > 1 && !gouged[block.line]) {
        const double from_corner = (middle - element.start).norm();
        const bool around = from_corner > radius - rounding && from_corner < radius * 1.42;
        ASSERT_TRUE(around || std::abs(element.distance(middle) - radius) < 1e-3)
            << "round " << round << " line " << block.line << " of radius " << radius;
        ++sound;
      }
      if (block.motion == Motion::arc) {
        const ArcWords& arc = program.arcs.at(static_cast<std::size_t>(block.arc));
        ASSERT_NEAR((start - arc.center).norm(), (block.target - arc.center).norm(), 1e-9);
      }
      start = block.target;
    }
  }
  EXPECT_GT(sound, 20000);
}

TEST(CutterCompensation, AroundAConvexContourIsAsFarFromAllOfIt) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> angles(3 + random() % 30);
    std::generate(angles.begin(), angles.end(), [&] { return 2 * pi * unit(random); });
    std::sort(angles.begin(), angles.end());
    std::vector<Vec3> corners;
    for (const double angle : angles) {
      corners.push_back(Vec3(50 * std::cos(angle), 30 * std::sin(angle), 0));
    }
    const double radius = 0.1 + 20 * unit(random);
    LineWriter writer;
    writer.rapid({200, 200, 0}).on(ToolSide::right, radius);
    for (const Vec3& corner : corners) {
      writer.line(corner);
    }
    writer.line(corners.front());
    const ReadProgram program = writer.finish_clean();
    for (std::size_t i = 2; i < program.motions.size(); ++i) {
      const Vec3 middle = middle_of(program.motions[i - 1].target, program.motions[i], program);
      double nearest = 1e9;
      for (std::size_t j = 0; j < corners.size(); ++j) {
        const Vec3& from = corners[j];
        const Vec3 way = corners[(j + 1) % corners.size()] - from;
        const double share = std::clamp((middle - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (from + share * way - middle).norm());
      }
      ASSERT_NEAR(nearest, radius, 1e-3) << "round " << round << ", motion " << i;
    }
  }
}

}  // namespace
}  // namespace feedscope
