#include "core/drives/arc_course.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feedscope {
namespace {

constexpr double arc_tolerance = 3e-9;

Arc helix(double radius, double rise) {
  Arc arc;
  arc.center = {10, -4, 2};
  arc.x = Vec3(1, 1, 0).normalized();
  arc.y = Vec3(-1, 1, 0).normalized();
  arc.rise = {0, 0, rise};
  arc.radius = radius;
  arc.sweep = 6;
  return arc;
}

// Speed up, slow down through rest and back, or neither; turns of some radians in few spans.
TEST(ArcCourse, SpansAreTheArcWithinTheToleranceThatTheyWereCutFor) {
  for (const double radius : {0.01, 4.0, 700.0, 3e4}) {
    for (const double rise : {0.0, 0.3 * radius}) {
      const Arc arc = helix(radius, rise);
      for (const double change : {0.0, 1.0, -1.5}) {
        for (const double turn : {0.02, 0.5, 5.0}) {
          Part part;
          part.duration = 0.2;
          part.v = turn * arc.length_per_radian() / part.duration;
          part.a = change * part.v / part.duration;
          part.j = change * part.v / part.duration / part.duration;
          const ArcCourse course(arc, part, arc_tolerance);
          double largest = 0;
          int spans = 0;
          SetSpan span;
          for (double from = 0; from < part.duration * (1 - 1e-9); from += span.duration, ++spans) {
            course.fill(span, from);
            for (int i = 0; i <= 20; ++i) {
              const double h = span.duration * i / 20;
              const LawPoint law = advance({0, part.v, part.a, part.j}, from + h);
              largest = std::max(largest, (arc.at(law.q).position - span.at(h)).norm());
            }
          }
          // Rounding of positions that are differences of radii besides.
          EXPECT_LT(largest, 1.01 * arc_tolerance + 1e-15 * 100 * radius)
              << radius << ' ' << rise << ' ' << change << ' ' << turn;
          EXPECT_LT(spans, 30 + 2 * radius / 100) << radius << ' ' << change << ' ' << turn;
        }
      }
    }
  }
}

}  // namespace
}  // namespace feedscope
